package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.NotSerializableException;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The messages of exceptions give the fault and the rule. */
class MessagesTest {
    /** Checks that the message contains numbers, each as a whole word. */
    private static void assertNames(String message, long... numbers) {
        List<String> words =
                Arrays.asList(message.replaceAll("[,_](?=\\d{3})", "").split("[^0-9.-]+"));
        for (long number : numbers) {
            boolean named = words.stream()
                    .anyMatch(word -> word.replaceFirst("\\.$", "").equals("" + number));
            assertTrue(named, () -> "names " + number + ": " + message);
        }
        assertFalse(message.matches(".*\\d\\.\\d.*"), () -> "no fractions of units or bytes: " + message);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4, 5, 10, 159, 160, 161, 300})
    void theMessageForATruncatedSaveGivesTheBytesThatItsUnitsNeed(int missing) {
        byte[] save = Saves.save(3);
        String message = Saves.refused(Arrays.copyOf(save, save.length - missing));
        assertTrue(message.contains("truncated"), message);
        assertNames(message, save.length, save.length - missing, 3);
    }

    /** The number of units cannot be known where not even the header is there. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 8, 15, 16, 50})
    void theMessageForASaveWithoutAHeaderSaysThatItIsTruncated(int length) {
        String message = Saves.refused(Arrays.copyOf(Saves.save(3), length));
        assertTrue(message.contains("truncated"), message);
        assertNames(message, length, Saves.HEADER + Saves.CRC);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 160, 1000})
    void theMessageForASaveThatIsTooLongDoesNotSayThatItIsTruncated(int more) {
        byte[] save = Saves.save(3);
        String message = Saves.refused(Arrays.copyOf(save, save.length + more));
        assertFalse(message.contains("truncated"), message);
        assertNames(message, save.length, save.length + more, 3);
    }

    @Test
    void theMessageForACallDuringAStepNamesOtherThreads() throws Exception {
        World world = new World();
        world.add(new Unit(1));
        CountDownLatch stepping = new CountDownLatch(1), done = new CountDownLatch(1);
        world.addBeforeStep((w, dt) -> {
            stepping.countDown();
            try {
                done.await();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });
        Thread other = new Thread(world::step);
        other.start();
        try {
            stepping.await();
            for (Executable call : List.<Executable>of(
                    world::step,
                    () -> world.step(1),
                    () -> world.advance(1),
                    world::save,
                    () -> world.save(new Snapshot()),
                    () -> world.restore(Saves.snapshot(new World())),
                    () -> world.setTimestep(Timestep.fixed(1)))) {
                String message = assertThrows(IllegalStateException.class, call).getMessage();
                assertTrue(message.contains("other thread"), message); // "another thread", too
            }
        } finally {
            done.countDown();
            other.join();
        }
        assertEquals(1, world.getTick());
    }

    /** A listener is one of the causes. */
    @Test
    void theMessageForACallDuringAStepNamesListeners() {
        World world = new World();
        world.addAfterStep((w, dt) -> w.step());
        String message = assertThrows(IllegalStateException.class, world::step).getMessage();
        assertTrue(message.contains("listener") || message.contains("StepListener"), message);
    }

    /** Three units need six elements. */
    @Test
    void theMessageForAShortArrayGivesTheElementsThatTheUnitsNeed() {
        World world = new World();
        for (int i = 0; i < 3; i++) world.add(new Unit(1));
        assertTooShort(5, 6, () -> world.applyForces(new double[5], 0));
        assertTooShort(5, 6, () -> world.copyVelocities(new double[5], 0));
        assertTooShort(5, 6, () -> world.copyPositions(new float[5], 0));
        assertTooShort(5, 6, () -> world.copyPositions(new float[5], 0, 0.5));
        assertTooShort(5, 6, () -> world.copyPositions(new double[5], 0, 0.5));
        assertTooShort(0, 6, () -> world.copyPositions(new float[0], 0));
    }

    private static void assertTooShort(long length, long needed, Executable call) {
        String message = assertThrows(IndexOutOfBoundsException.class, call).getMessage();
        assertNames(message, length, needed, 3);
        assertTrue(message.contains("xy"), () -> "names the argument: " + message);
    }

    @Test
    void theMessageForAnOffsetThatLeavesTooLittleRoomGivesIt() {
        World world = new World();
        for (int i = 0; i < 3; i++) world.add(new Unit(1));
        for (int offset : new int[] {-1, 2, 8, 9, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
            for (Executable call : List.<Executable>of(
                    () -> world.applyForces(new double[7], offset),
                    () -> world.copyVelocities(new double[7], offset),
                    () -> world.copyPositions(new float[7], offset),
                    () -> world.copyPositions(new float[7], offset, 0.5),
                    () -> world.copyPositions(new double[7], offset, 0.5))) {
                String message =
                        assertThrows(IndexOutOfBoundsException.class, call).getMessage();
                assertNames(message, offset, 7);
            }
        }
        world.copyPositions(new float[7], 1);
    }

    private static final class Tank extends Unit implements Serializable {
        private static final long serialVersionUID = 1;

        Tank() {
            super(1);
        }
    }

    /** Java itself throws for a class that is not serializable; the library throws for those that are. */
    @Test
    void theMessageForASerializedUnitNamesTheSnapshot() throws Exception {
        try (ObjectOutputStream out = new ObjectOutputStream(new ByteArrayOutputStream())) {
            String message = assertThrows(NotSerializableException.class, () -> out.writeObject(new Tank()))
                    .getMessage();
            assertTrue(message.contains(Tank.class.getName()) && message.contains("Snapshot"), message);
            assertThrows(NotSerializableException.class, () -> out.writeObject(new Unit(1)));
        }
    }
}
