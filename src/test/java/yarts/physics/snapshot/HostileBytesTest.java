package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.World;
import yarts.physics.support.Churn;

/** Bytes that are truncated, damaged or invented cause an exception or are a valid state, and use little memory. */
class HostileBytesTest {
    /** The allowed memory in addition to twice the size of the bytes, including the stack trace of an exception. */
    private static final int SMALL = 14 * 1024;

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void everyWrongLengthThrows() {
        byte[] save = Saves.save(100);
        for (int length = 0; length < save.length + 300; length++) {
            if (length == save.length) continue;
            Saves.refused(Arrays.copyOf(save, length));
            if (length >= Saves.CRC) Saves.refused(Saves.repair(Arrays.copyOf(save, length)));
        }
        Snapshot.fromBytes(save);
    }

    @Test
    void everyFlippedBitThrows() {
        byte[] save = Saves.save(100);
        for (int bit = 0; bit < 8 * save.length; bit++) {
            save[bit / 8] ^= (byte) (1 << bit % 8);
            Saves.refused(save);
            save[bit / 8] ^= (byte) (1 << bit % 8);
        }
        Snapshot.fromBytes(save);
    }

    @Test
    void wrongNumbersOfUnitsThrowBeforeMemoryIsAllocated() {
        for (int units : new int[] {0, 1, 100}) {
            byte[] save = Saves.save(units);
            int fit = units;
            int overflows = (int) ((1L << 32) / Saves.RECORD); // this many, and half, are too many bytes for an int
            IntStream.of(
                            -1,
                            Integer.MIN_VALUE,
                            Integer.MAX_VALUE,
                            overflows / 2,
                            overflows,
                            overflows + 1,
                            fit - 1,
                            fit + 1)
                    .forEach(count -> {
                        Saves.order(save).putInt(12, count);
                        Saves.repair(save);
                        String message = Saves.refused(save);
                        assertTrue(
                                message.matches("the bytes are (truncated|too many): .*|the number of units .*"),
                                message);
                        assertTrue(allocated(save) <= SMALL, allocated(save) + " bytes");
                    });
        }
    }

    @Test
    void readingAllocatesAtMostTwiceTheSize() {
        IntStream.concat(IntStream.of(Tiles.sizes()), IntStream.of(2, 10, 63, 64, 65, 100, 100_000))
                .forEach(units -> {
                    byte[] save = Saves.save(units);
                    assertTrue(allocated(save) <= 2L * save.length + SMALL, units + " units: " + allocated(save));
                });
    }

    @Test
    void mutationsThrowOrAreSound() {
        mutate(1, 20_000);
    }

    @Test
    @Tag("long")
    void aMillionMutationsThrowOrAreSound() {
        mutate(2, 1_000_000);
    }

    private static void mutate(long seed, int times) {
        SplittableRandom random = new SplittableRandom(seed);
        List<byte[]> saves = new ArrayList<>();
        for (int units : new int[] {0, 1, 3, 20}) {
            saves.add(Saves.save(units));
            saves.add(Saves.save(units, Timestep.variable(0.02)));
        }
        World target = Churn.world(seed, Integrator.EULER, Timestep.fixed(60), 20);
        long hash = target.stateHash();
        int accepted = 0;
        for (int i = 0; i < times; i++) {
            byte[] save = mutant(saves.get(random.nextInt(saves.size())), random);
            Snapshot snapshot = null;
            try {
                snapshot = Snapshot.fromBytes(save);
            } catch (IllegalArgumentException e) {
                assertTrue(e.getMessage() != null && e.getMessage().length() < 200, e.getMessage());
            }
            assertTrue(allocated(save) <= 2L * save.length + SMALL, () -> allocated(save) + " bytes");
            if (snapshot == null) continue;
            accepted++;
            Saves.assertSound(snapshot);
        }
        assertEquals(hash, target.stateHash());
        assertTrue(accepted > times / 20 && accepted < times * 19 / 20, accepted + " of " + times + " accepted");
    }

    private static final double[] DOUBLES = {
        0,
        -0.0,
        1,
        -1,
        1e50,
        -1e50,
        1e70,
        1e-50,
        1e100,
        0x1p500,
        0x1p-500,
        1e-200,
        1 / 60.0,
        1e-6,
        1e9,
        Double.MIN_VALUE,
        Double.MIN_NORMAL,
        Double.MAX_VALUE,
        -Double.MAX_VALUE,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
    };

    /** A snapshot with one to four random changes of any kind, and the right checksum. */
    private static byte[] mutant(byte[] save, SplittableRandom random) {
        byte[] mutant = save.clone();
        for (int changes = 1 + random.nextInt(4); changes > 0; changes--) {
            int word = 8 * random.nextInt((mutant.length - Saves.CRC) / 8), other = 8 * random.nextInt(save.length / 8);
            switch (random.nextInt(7)) {
                case 0:
                    mutant[random.nextInt(mutant.length)] = (byte) random.nextInt();
                    break;
                case 1:
                    mutant[random.nextInt(mutant.length)] ^= (byte) (1 << random.nextInt(8));
                    break;
                case 2:
                    Saves.order(mutant).putDouble(word, DOUBLES[random.nextInt(DOUBLES.length)]);
                    break;
                case 3:
                    Saves.order(mutant).putLong(word, random.nextLong() >> random.nextInt(64));
                    break;
                case 4:
                    Saves.order(mutant).putInt(word + 4 * random.nextInt(2), random.nextInt() >> random.nextInt(32));
                    break;
                case 5:
                    System.arraycopy(save, other, mutant, word, Math.min(8, mutant.length - word));
                    break;
                default: // one unit more, or fewer
                    if (random.nextInt(4) > 0) break;
                    mutant = Arrays.copyOf(
                            mutant,
                            Math.max(
                                    Saves.HEADER + Saves.CRC,
                                    mutant.length + (random.nextBoolean() ? Saves.RECORD : -Saves.RECORD)));
                    Saves.order(mutant).putInt(12, (mutant.length - Saves.HEADER) / Saves.RECORD);
            }
        }
        return Saves.repair(mutant);
    }

    /** {@return the bytes that reading allocates} The fewer of two, because the JVM links code at its first use. */
    private static long allocated(byte[] save) {
        long fewest = Long.MAX_VALUE, thread = Thread.currentThread().getId();
        for (int i = 0; i < 2; i++) {
            long before = THREADS.getThreadAllocatedBytes(thread);
            try {
                Snapshot.fromBytes(save);
            } catch (IllegalArgumentException e) {
                // counts as well
            }
            fewest = Math.min(fewest, THREADS.getThreadAllocatedBytes(thread) - before);
        }
        return fewest;
    }
}
