package yarts.physics.faults;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Makes calls at several depths before the end of the stack. A call can fail at any point, even in the middle of a
 * step, which cannot be undone. But the world must stay usable with finite numbers, and the restore of a snapshot must
 * succeed.
 */
class StackOverflowTest {
    private static final int DEPTHS = 100;

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
        for (int i = 0; i < Tiles.TILE + 9; i++) {
            world.add(new Unit(1 + i)).setFriction(i % 4).setVelocity(i, 1).applyForce(i, -i);
        }
        return world;
    }

    /** Recurses to the end of the stack, and on return calls another world in each stack frame. */
    private static final class Dive {
        private final Consumer<World> call;
        private final List<World> worlds = new ArrayList<>();
        private final List<Snapshot> saves = new ArrayList<>();
        private int next, stopped;

        Dive(Consumer<World> call) {
            this.call = call;
            call.accept(world()); // loads all classes
            for (int i = 0; i < DEPTHS; i++) {
                World world = world();
                if (i % 2 == 0) world.find(1); // builds the index of ids
                worlds.add(world);
                saves.add(world.save());
            }
        }

        @SuppressWarnings("InfiniteRecursion") // the purpose of this method
        void down() {
            try {
                down();
            } catch (StackOverflowError e) {
                // The end of the stack.
            }
            if (next == DEPTHS) return;
            World world = worlds.get(next);
            next++;
            try {
                call.accept(world);
            } catch (StackOverflowError e) {
                stopped++;
            }
        }
    }

    private static void run(Dive dive) throws InterruptedException {
        Thread thread = new Thread(null, dive::down, "little stack", 256 << 10);
        thread.start();
        thread.join();
        assertEquals(DEPTHS, dive.next);
        assertTrue(dive.stopped < DEPTHS, "the call never succeeded");
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("calls")
    void aWorldSurvivesACallWithoutStack(String name, Consumer<World> call) throws Exception {
        int stopped = 0;
        for (int i = 0; i < 3; i++) { // compiled code fails at other points
            Dive dive = new Dive(call);
            run(dive);
            stopped += dive.stopped;
            for (int k = 0; k < DEPTHS; k++) assertSurvived(dive.worlds.get(k), dive.saves.get(k));
        }
        assertTrue(stopped > 0, "the call never failed");
    }

    /** The unit is either in the world or alone, and a change of it changes no other unit. */
    @Test
    void aUnitThatCouldNotBeAddedIsAlone() throws Exception {
        IdentityHashMap<World, Unit> newUnits = new IdentityHashMap<>();
        Dive dive = new Dive(world -> {
            Unit newUnit = newUnits.get(world);
            if (newUnit != null) world.add(newUnit);
        });
        for (World world : dive.worlds) newUnits.put(world, new Unit(1).setPosition(1, 2));
        run(dive);
        for (World world : dive.worlds) {
            Unit newUnit = newUnits.get(world);
            if (newUnit.getWorld() != null) continue;
            Unit other = world.add(new Unit(1));
            newUnit.setPosition(3, 4).applyForce(5, 6);
            assertEquals(0, other.getX());
            assertEquals(0, other.getFx());
            world.step();
            assertEquals(3, newUnit.getX());
            long id = other.getId() + 1;
            assertEquals(id, world.add(newUnit).getId());
            assertSame(newUnit, world.find(id));
            assertSame(other, world.find(id - 1));
            assertEquals(world.size() - 1, world.units().indexOf(newUnit));
        }
    }

    private static void assertSurvived(World world, Snapshot before) {
        for (int i = 0; i < 3; i++) {
            world.step();
            world.advance(0.03);
        }
        double[] xy = new double[2 * world.size() + 2];
        world.copyVelocities(xy, 0);
        world.copyPositions(xy, 0, 1);
        for (double v : xy) assertTrue(Double.isFinite(v));
        world.restore(before);
        World same = world();
        assertEquals(same.stateHash(), world.stateHash());
        assertEquals(Churn.bits(same), Churn.bits(world));
        for (Unit unit : world) assertSame(unit, world.find(unit.getId()));
        assertNull(world.find(world.size() + 1));
        world.step();
        same.step();
        assertEquals(same.stateHash(), world.stateHash(), "it continues from the snapshot");
    }
}
