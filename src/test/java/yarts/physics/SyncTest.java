package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The test that finds what would come apart over a network, on one machine: in every tick go back eight ticks, replay the
 * same orders, and compare the hashes with those of the first time.
 *
 * <p>Orders are worked out from the tick, as if they had been recorded, and name units by id. In a replay the units that
 * they add are other objects with the same ids.
 */
class SyncTest {
    private static final int BACK = 8;
    private static final int NONE = -1;

    /** What a tick does: reads the orders for it, gives them to the units, and steps. */
    private interface Game {
        void tick(World world, long tick);
    }

    /** {@return the first tick after which a replay's hash is another, or NONE} */
    private static long firstMismatch(World world, Game game, int ticks) {
        Snapshot[] past = Stream.generate(Snapshot::new).limit(BACK).toArray(Snapshot[]::new);
        long[] hashes = new long[BACK];
        for (int now = 0; now < ticks; now++) {
            world.save(past[now % BACK]);
            game.tick(world, now);
            hashes[now % BACK] = world.stateHash();
            int start = Math.max(0, now - BACK + 1);
            world.restore(past[start % BACK]);
            for (int tick = start; tick <= now; tick++) {
                world.save(past[tick % BACK]); // with the units that this replay makes
                game.tick(world, tick);
                if (world.stateHash() != hashes[tick % BACK]) return tick;
            }
        }
        return NONE;
    }

    private static World world(Integrator how) {
        World world = new World(how, Timestep.fixed(60));
        world.setStepListener((w, dt) -> { // all are drawn to the first
            Unit first = w.size() > 0 ? w.get(0) : null;
            for (Unit unit : w) unit.applyForce(first.getX() - unit.getX(), first.getY() - unit.getY());
        });
        return world;
    }

    /** Some hundred units, of which a few come, go and change in each tick. */
    private static void skirmish(World world, long tick) {
        SplittableRandom orders = new SplittableRandom(tick);
        while (world.size() < 50 || orders.nextInt(3) > 0) {
            world.add(new Unit(orders.nextDouble(1, 9)).setFriction(orders.nextDouble()))
                    .setPosition(orders.nextDouble(), orders.nextDouble());
        }
        for (int n = orders.nextInt(9); n > 0; n--) {
            long newest = world.get(world.size() - 1).getId();
            Unit unit = world.find(newest - orders.nextInt(150));
            if (unit == null) continue; // it has been removed, or in this replay was never added
            switch (orders.nextInt(6)) {
                case 0:
                    unit.setMass(orders.nextDouble(1, 9)).setFriction(orders.nextDouble(20));
                    break;
                case 1:
                    unit.setMaxSpeed(orders.nextDouble(50));
                    break;
                case 2:
                    unit.applyImpulse(orders.nextDouble(-99, 99), orders.nextDouble(-99, 99));
                    break;
                case 3:
                    unit.setPosition(orders.nextDouble(99), orders.nextDouble(99));
                    break;
                default:
                    world.remove(unit);
            }
        }
        while (world.size() > 150) world.remove(world.get(orders.nextInt(world.size())));
        for (int i = orders.nextInt(4); i < world.size(); i += 4) world.get(i).applyForce(i, -tick % 10);
        if (tick % 4 > 0) world.step(1 / 60.0);
        else world.advance(orders.nextDouble(0.04)); // none to three steps: forces wait for the next
    }

    @ParameterizedTest
    @EnumSource
    void everyReplayHasTheSameHashes(Integrator how) {
        World world = world(how);
        assertEquals(NONE, firstMismatch(world, SyncTest::skirmish, 2000));
        assertTrue(world.getTick() > 2000 && world.size() >= 50);
        assertTrue(world.get(world.size() - 1).getId() > 4000, "units come and go");
    }

    @ParameterizedTest
    @EnumSource
    @Tag("long")
    void everyReplayHasTheSameHashesForLong(Integrator how) {
        assertEquals(NONE, firstMismatch(world(how), SyncTest::skirmish, 100_000));
    }

    /** An order that depends on how often it was carried out, from tick 1234 on. */
    @Test
    void whatIsKeptBesideTheWorldIsFound() {
        int[] calls = {0};
        Game game = (world, tick) -> {
            skirmish(world, tick);
            if (tick >= 1234) world.get(7).applyImpulse(1e-9 * ++calls[0], 0);
        };
        assertEquals(1234, firstMismatch(world(Integrator.EXACT), game, 2000));
    }

    /** The same units, in another order. */
    @Test
    void anotherOrderIsFound() {
        int[] calls = {0};
        Game game = (world, tick) -> {
            skirmish(world, tick);
            if (tick != 700) return;
            Unit a = new Unit(3), b = new Unit(4);
            boolean swap = calls[0]++ % 2 == 1; // as a hash map of objects may
            world.add(swap ? b : a);
            world.add(swap ? a : b);
        };
        assertEquals(700, firstMismatch(world(Integrator.EXACT), game, 2000));
    }
}
