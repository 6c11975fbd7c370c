package yarts.physics.faults;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Blocks;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * A call at the end of the stack, a little nearer each time. It can stop anywhere, even in the middle of a step, which no
 * library can take back: but the world must not be stuck, its numbers are finite, and a save from before brings all back.
 */
class StackOverflowTest {
    private static final int NEAREST = 60;

    static Stream<Arguments> calls() {
        return Stream.of(
                Arguments.of("step", (Consumer<World>) World::step),
                Arguments.of("advance", (Consumer<World>) world -> world.advance(0.1)),
                Arguments.of(
                        "integrate", (Consumer<World>) world -> world.get(0).integrate(0.1, Integrator.EXACT)),
                Arguments.of("add", (Consumer<World>) world -> world.add(new Unit(1))),
                Arguments.of("remove", (Consumer<World>) world -> world.remove(world.get(0))),
                Arguments.of("save", (Consumer<World>) World::save));
    }

    private static World world() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 0; i < Blocks.BLOCK + 9; i++) {
            world.add(new Unit(1 + i)).setFriction(i % 4).setVelocity(i, 1).applyForce(i, -i);
        }
        return world;
    }

    /** Calls itself some times, and then something else. */
    private static void dive(int depth, Runnable call) {
        if (depth == 0) call.run();
        else dive(depth - 1, call);
    }

    private static boolean overflows(int depth, Runnable call) {
        try {
            dive(depth, call);
            return false;
        } catch (StackOverflowError e) {
            return true;
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("calls")
    void aWorldSurvivesACallWithoutStack(String name, Consumer<World> call) throws Exception {
        Throwable[] failure = {null};
        Thread thread = new Thread(null, () -> tryAll(call), "little stack", 256 << 10);
        thread.setUncaughtExceptionHandler((t, e) -> failure[0] = e);
        thread.start();
        thread.join();
        assertNull(failure[0], () -> name + ": " + failure[0]);
    }

    private static void tryAll(Consumer<World> call) {
        for (int i = 0; i < 200; i++) call.accept(world()); // with all classes loaded
        int deepest = 0;
        while (!overflows(deepest, () -> {})) deepest += 10;
        int stopped = 0;
        for (int depth = deepest; depth > deepest - 10 * NEAREST && depth > 0; depth -= 3) {
            World world = world();
            Snapshot before = world.save();
            long hash = world.stateHash();
            if (overflows(depth, () -> call.accept(world))) stopped++;
            for (int i = 0; i < 3; i++) {
                world.step();
                world.advance(0.03);
            }
            double[] xy = new double[2 * world.size() + 2];
            world.copyVelocities(xy, 0);
            world.copyPositions(xy, 0, 1);
            for (double v : xy) assertTrue(Double.isFinite(v));
            world.restore(before);
            assertEquals(hash, world.stateHash());
            World same = world();
            assertEquals(Churn.bits(same), Churn.bits(world));
            world.step();
            same.step();
            assertEquals(same.stateHash(), world.stateHash(), "and it goes on from there");
        }
        assertTrue(stopped > 10, "stopped only " + stopped + " times");
    }
}
