package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.snapshot.Saves;

/** A game with rollback allocates nothing per frame, except for units that it creates or removes. */
class RollbackAllocationTest {
    private static final int WARM_UP = 300;
    private static final int BATCHES = 20;
    private static final int REPEATS = 10;

    /** A restore that removes units allocates one table for them: its arrays, with a row for each unit. */
    private static final int TABLE = 2550, BYTES_PER_LEAVER = 208;

    /** A unit outside a world has its own table: 1.1 kB. */
    private static final int BYTES_PER_UNIT = 1150;

    private static ThreadMXBean threads;
    private static volatile Object escape;

    @BeforeAll
    static void allocationsAreCounted() {
        assumeTrue(ManagementFactory.getThreadMXBean() instanceof ThreadMXBean, "this JVM counts no allocations");
        threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        assumeTrue(threads.isThreadAllocatedMemorySupported(), "this JVM counts no allocations");
        threads.setThreadAllocatedMemoryEnabled(true);
    }

    private static void nothing() {}

    private static long fewestBytes(Runnable work) {
        return fewestBytes(RollbackAllocationTest::nothing, work);
    }

    /**
     * The fewest bytes that the calls of a batch allocate, without the preparation before each call. The fewest,
     * because the JVM itself sometimes allocates when it compiles.
     */
    private static long fewestBytes(Runnable prepare, Runnable work) {
        long id = Thread.currentThread().getId();
        long fewest = Long.MAX_VALUE;
        for (int batch = -WARM_UP / REPEATS; batch < BATCHES; batch++) {
            long bytes = 0;
            for (int i = 0; i < REPEATS; i++) {
                prepare.run();
                long before = threads.getThreadAllocatedBytes(id);
                work.run();
                bytes += threads.getThreadAllocatedBytes(id) - before;
            }
            if (batch >= 0) fewest = Math.min(fewest, bytes);
        }
        return fewest;
    }

    private static World crowd(int units) {
        World world = new World();
        for (int i = 1; i <= units; i++) {
            world.add(new Unit(i).setFriction(i % 7).setVelocity(i % 3, i % 5).setMaxSpeed(i % 5 == 0 ? 1 : 100));
        }
        world.addBeforeStep((w, dt) -> w.get(0).applyForce(dt, 1));
        world.addAfterStep((w, dt) -> w.get(1).applyForce(1, dt));
        return world;
    }

    @Test
    void theCounterDetectsASingleObject() {
        assertTrue(fewestBytes(() -> escape = new Object()) >= 8 * REPEATS);
        assertEquals(0, fewestBytes(() -> escape = new Object(), RollbackAllocationTest::nothing));
    }

    /** Saves, predicts 8 steps, restores, and finds a unit by its id. */
    @ParameterizedTest
    @EnumSource
    void aRollbackLoopAllocatesNothing(Integrator integrator) {
        World world = crowd(1000);
        world.setIntegrator(integrator);
        Snapshot snapshot = new Snapshot();
        long[] id = {0};
        assertEquals(0, fewestBytes(() -> {
            world.save(snapshot);
            for (int i = 0; i < 8; i++) {
                world.get(i * 100).applyForce(1, -1);
                world.step();
            }
            world.restore(snapshot);
            world.find(1 + id[0]++ % 1000).applyForce(2, 3);
            world.advance(0.02);
        }));
        assertTrue(world.getTick() > 300);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 15, 16, 17, 511, 512, 513, 10_000})
    void aRollbackLoopAllocatesNothingWithAnyNumberOfUnits(int units) {
        World world = new World();
        for (int i = 0; i < units; i++) world.add(new Unit(1).setVelocity(1, 0));
        Snapshot snapshot = new Snapshot();
        assertEquals(0, fewestBytes(() -> {
            world.save(snapshot);
            for (int i = 0; i < 8; i++) world.step();
            world.restore(snapshot);
            if (world.find(units) == null) throw new AssertionError();
        }));
    }

    /** Snapshots of one world from several ticks, in any order. */
    @Test
    void restoringOneOfManySnapshotsAllocatesNothing() {
        World world = crowd(1000);
        List<Snapshot> ring = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            ring.add(world.save());
            world.step();
        }
        int[] i = {0};
        assertEquals(0, fewestBytes(() -> {
            world.restore(ring.get(i[0]++ * 5 % 8));
            world.step();
            world.save(ring.get(i[0] * 3 % 8));
        }));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 20, 512, 10_000})
    void restoringIntoAnotherWorldOfTheSameSizeAllocatesNothing(int units) {
        World source = new World(Integrator.EULER, Timestep.fixed(30)), target = new World();
        for (int i = 0; i < units; i++) source.add(new Unit(1).setVelocity(1, 0));
        Snapshot snapshot = source.save();
        target.restore(snapshot);
        assertEquals(0, fewestBytes(() -> {
            source.step();
            source.save(snapshot);
            target.restore(snapshot);
            if (target.find(units).getX() != source.find(units).getX()) throw new AssertionError();
        }));
        assertEquals(source.stateHash(), target.stateHash());
    }

    /** From the bytes of two saves of the same units, the second with the first unit at the end. */
    @Test
    void restoringUnitsInAnotherOrderAllocatesNothing() {
        byte[] save = crowd(1000).save().toBytes();
        int record = (save.length - new World().save().toBytes().length) / 1000;
        int end = save.length - Saves.CRC, first = end - 1000 * record;
        byte[] moved = save.clone();
        System.arraycopy(save, first, moved, end - record, record);
        System.arraycopy(save, first + record, moved, first, 999 * record);
        Snapshot[] saves = {Snapshot.fromBytes(save), Snapshot.fromBytes(Saves.repair(moved))};
        World world = new World();
        world.restore(saves[0]);
        Unit unit = world.get(0);
        int[] i = {0};
        assertEquals(0, fewestBytes(() -> {
            world.restore(saves[++i[0] % 2]);
            if (world.find(1) != world.get(i[0] % 2 == 0 ? 0 : 999)) throw new AssertionError();
        }));
        assertSame(unit, world.find(1));
    }

    @Test
    void findAllocatesNothing() {
        World world = crowd(1000);
        long[] id = {0, 0};
        assertEquals(0, fewestBytes(() -> {
            if (world.find(id[0]++ % 1500) != null) id[1]++;
            if (world.find(-id[0]) != null || world.find(id[0] << 40) != null) throw new AssertionError();
        }));
        assertTrue(id[1] > 100);
    }

    /** Also the first call after units were added, removed or exchanged by a restore. */
    @Test
    void theFirstFindAfterAChangeOfTheUnitsAllocatesNothing() {
        World world = crowd(1000);
        Snapshot snapshot = world.save();
        Runnable find = () -> {
            if (world.find(500) == null) throw new AssertionError();
            escape = world.find(1001);
        };
        find.run();
        assertEquals(
                0,
                fewestBytes(
                        () -> {
                            world.restore(snapshot);
                            world.add(new Unit(1));
                        },
                        find));
        assertEquals(0, fewestBytes(() -> world.restore(snapshot), find));
        assertEquals(
                0,
                fewestBytes(
                        () -> {
                            world.restore(snapshot);
                            world.remove(world.get(3));
                        },
                        find));
        assertEquals(
                0,
                fewestBytes(
                        () -> {
                            world.add(new Unit(1));
                            world.restore(snapshot);
                        },
                        find));
    }

    /** Units that were removed after the save return. */
    @ParameterizedTest
    @ValueSource(ints = {1, 8, 100, 1000})
    void aRestoreThatBringsUnitsBackAllocatesNothing(int back) {
        World world = crowd(1000);
        Snapshot snapshot = world.save();
        assertEquals(
                0,
                fewestBytes(
                        () -> {
                            for (int i = 0; i < back; i++) world.remove(world.get(i * 7 % world.size()));
                            world.find(1);
                        },
                        () -> world.restore(snapshot)));
        assertEquals(1000, world.size());
    }

    /** There is one table for all of them. */
    @ParameterizedTest
    @ValueSource(ints = {1, 8, 100, 1000})
    void aRestoreThatRemovesUnitsAllocatesOneTableForThem(int leavers) {
        World world = crowd(1000);
        Snapshot snapshot = world.save();
        long bytes = fewestBytes(
                () -> {
                    for (int i = 0; i < leavers; i++) world.add(new Unit(1));
                    world.find(1);
                },
                () -> world.restore(snapshot));
        long most = TABLE + (long) BYTES_PER_LEAVER * leavers;
        assertTrue(bytes <= most * REPEATS, () -> bytes / REPEATS + " bytes for " + leavers + " units, not " + most);
    }

    /** The allowed bytes are those of the new units and of a table for those that leave. */
    @Test
    void aRollbackLoopWithSpawnsAllocatesOnlyForItsUnits() {
        World world = crowd(1000);
        Snapshot snapshot = new Snapshot();
        int spawns = 8;
        for (int i = 0; i < 64; i++) world.add(new Unit(1)); // so that the arrays have free rows for the spawns
        world.removeIf(unit -> unit.getIndex() >= 1000);
        long bytes = fewestBytes(() -> {
            world.save(snapshot);
            for (int i = 0; i < spawns; i++) {
                world.add(new Unit(1));
                world.step();
            }
            world.restore(snapshot);
            escape = world.find(1);
        });
        long most = TABLE + (long) spawns * (BYTES_PER_LEAVER + BYTES_PER_UNIT);
        assertTrue(bytes <= most * REPEATS, () -> bytes / REPEATS + " bytes, not " + most);
    }

    @Test
    void creatingOrRemovingAUnitAllocatesLittle() {
        long made = fewestBytes(() -> escape = new Unit(1));
        assertTrue(made <= BYTES_PER_UNIT * REPEATS, () -> "made: " + made / REPEATS + " bytes");
        World world = crowd(1000);
        Unit[] unit = {null};
        long removed = fewestBytes(() -> unit[0] = world.add(new Unit(1)), () -> world.remove(unit[0]));
        assertTrue(removed <= BYTES_PER_UNIT * REPEATS, () -> "removed: " + removed / REPEATS + " bytes");
        assertEquals(
                0,
                fewestBytes(
                        () -> {
                            world.remove(unit[0]);
                            unit[0] = new Unit(1);
                        },
                        () -> world.add(unit[0])),
                "added to free rows");
    }

    /** The world and the units that left can both be used. */
    @Test
    void unitsThatLeftByARestoreMoveAlone() {
        World world = crowd(10);
        Snapshot snapshot = world.save();
        Unit a = world.add(new Unit(1).setPosition(1, 2)), b = world.add(new Unit(2).setPosition(3, 4));
        world.restore(snapshot);
        for (Unit unit : List.of(a, b)) {
            assertNull(unit.getWorld());
            assertEquals(-1, unit.getIndex());
            unit.applyForce(1, 0);
            unit.integrate(1);
            assertEquals(1 / unit.getMass(), unit.getVx());
            assertNull(world.find(unit.getId()));
        }
        assertEquals(1, a.getX());
        assertEquals(4, b.getY());
        assertNotNull(world.add(b).getWorld());
    }
}
