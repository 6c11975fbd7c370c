package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Finds causes of desyncs on one machine: in every tick, goes back eight ticks, replays the same orders, and compares
 * the hashes with the first ones.
 *
 * <p>Orders follow from the tick, as if they had been recorded, and name units by id. In a replay, the units that they
 * add are other objects with the same ids.
 */
class SyncTest {
    private static final int BACK = 8;
    private static final int NONE = -1;

    /** A tick: reads its orders, gives them to the units, and steps. */
    private interface Game {
        void tick(World world, long tick);
    }

    /** {@return the first tick after which a replay has another hash, or NONE} */
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
                world.save(past[tick % BACK]); // with the units that this replay creates
                game.tick(world, tick);
                if (world.stateHash() != hashes[tick % BACK]) return tick;
            }
        }
        return NONE;
    }

    private static World world(Integrator integrator) {
        return new World(integrator, Timestep.fixed(60));
    }

    /** Some dozens of units; in each tick, a few join, leave and change. */
    private static void skirmish(World world, long tick) {
        new Churn(tick, 50, 30).frame(world);
    }

    @ParameterizedTest
    @EnumSource
    void everyReplayHasTheSameHashes(Integrator integrator) {
        World world = world(integrator);
        assertEquals(NONE, firstMismatch(world, SyncTest::skirmish, 2000));
        assertTrue(world.getTick() > 1500, world.getTick() + " steps");
        long added = world.add(new Unit(1)).getId();
        assertTrue(added > 2000 && added > 20L * world.size(), "too few units joined and left: " + added);
    }

    @ParameterizedTest
    @EnumSource
    @Tag("long")
    void everyReplayOfALongGameHasTheSameHashes(Integrator integrator) {
        assertEquals(NONE, firstMismatch(world(integrator), SyncTest::skirmish, 100_000));
    }

    /** From tick 1234 on, an order depends on how often it was executed. */
    @Test
    void stateOutsideTheWorldIsDetected() {
        int[] calls = {0};
        Game game = (world, tick) -> {
            skirmish(world, tick);
            if (tick >= 1234) world.get(7).setPosition(1e-9 * ++calls[0], 0);
        };
        assertEquals(1234, firstMismatch(world(Integrator.EXACT), game, 2000));
    }

    /** The same units are used in another order. */
    @Test
    void anotherOrderOfUnitsIsDetected() {
        int[] calls = {0};
        Game game = (world, tick) -> {
            skirmish(world, tick);
            if (tick != 700) return;
            Unit a = new Unit(3), b = new Unit(4);
            boolean swap = calls[0]++ % 2 == 1; // as a hash map of objects can
            world.add(swap ? b : a);
            world.add(swap ? a : b);
        };
        assertEquals(700, firstMismatch(world(Integrator.EXACT), game, 2000));
    }
}
