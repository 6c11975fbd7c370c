package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import yarts.physics.Snapshot;
import yarts.physics.Unit;
import yarts.physics.World;

/** A small world takes little memory, and the removal of all units allocates little. */
class MemoryTest {
    private static final int REPEATS = 20;

    private static ThreadMXBean threads;
    private static volatile Object escape;

    @BeforeAll
    static void allocationsAreCounted() {
        assumeTrue(ManagementFactory.getThreadMXBean() instanceof ThreadMXBean, "this JVM counts no allocations");
        threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        assumeTrue(threads.isThreadAllocatedMemorySupported(), "this JVM counts no allocations");
        threads.setThreadAllocatedMemoryEnabled(true);
    }

    /** The fewest bytes that one of several calls allocates. A call retains at most the bytes that it allocates. */
    private static long fewestBytes(Runnable work) {
        long id = Thread.currentThread().getId();
        long fewest = Long.MAX_VALUE;
        for (int i = 0; i < REPEATS; i++) {
            long before = threads.getThreadAllocatedBytes(id);
            work.run();
            fewest = Math.min(fewest, threads.getThreadAllocatedBytes(id) - before);
        }
        return fewest;
    }

    private static World world(int units) {
        World world = new World();
        for (int i = 0; i < units; i++) world.add(new Unit(1).setPosition(i, -i).setVelocity(1, i % 3));
        return world;
    }

    @Test
    void anEmptyWorldTakesLessThanTenKilobytes() {
        long bytes = fewestBytes(() -> escape = new World());
        assertTrue(bytes > 0 && bytes < 10_000, () -> bytes + " bytes");
        long restored = fewestBytes(() -> {
            World world = new World();
            world.restore(new World().save());
            escape = world;
        });
        assertTrue(restored < 30_000, () -> restored + " bytes for two worlds and a snapshot");
    }

    /** Twenty units of 1.1 kB each, created outside; the rest is the world. */
    @Test
    void aWorldOfTwentyUnitsTakesLessThanThirtyKilobytes() {
        Unit[] units = new Unit[20];
        long id = Thread.currentThread().getId();
        long fewest = Long.MAX_VALUE;
        for (int i = 0; i < REPEATS; i++) {
            for (int k = 0; k < units.length; k++) units[k] = new Unit(1);
            long before = threads.getThreadAllocatedBytes(id);
            World world = new World();
            for (Unit unit : units) world.add(unit);
            fewest = Math.min(fewest, threads.getThreadAllocatedBytes(id) - before);
            escape = world;
        }
        long bytes = fewest;
        assertTrue(bytes < 30_000, () -> bytes + " bytes");
    }

    @Test
    void clearAllocatesLittle() {
        long id = Thread.currentThread().getId();
        long fewest = Long.MAX_VALUE;
        for (int i = 0; i < 3; i++) {
            World world = world(100_000);
            world.find(1);
            long before = threads.getThreadAllocatedBytes(id);
            world.clear();
            fewest = Math.min(fewest, threads.getThreadAllocatedBytes(id) - before);
            assertEquals(0, world.size());
        }
        long bytes = fewest;
        assertTrue(bytes < 20_000, () -> bytes + " bytes");
    }

    /** They share the former table of the world, and the world has a new one. */
    @Test
    void unitsThatLeftByClearMoveAlone() {
        World world = world(1000);
        List<Unit> units = List.copyOf(world.units());
        world.addAfterStep((w, dt) -> w.get(3).applyForce(5, 5));
        world.step();
        for (Unit unit : units) unit.applyForce(1, 2);
        Snapshot saved = world.save();
        world.clear();
        assertEquals(0, world.size());
        assertEquals(List.of(), world.units());
        for (int i = 0; i < units.size(); i++) {
            Unit unit = units.get(i);
            assertNull(unit.getWorld());
            assertEquals(-1, unit.getIndex());
            assertEquals(i + 1, unit.getId());
            assertNull(world.find(i + 1));
            assertEquals(0, unit.getFx());
            assertEquals(0, unit.getFy());
            assertEquals(i + 1 / 60.0, unit.getX(), 1e-12);
            unit.integrate(1);
            assertEquals(1, unit.getVx());
            assertEquals(i + 1 / 60.0 + 1, unit.getX(), 1e-12);
        }
        Unit fresh = world.add(new Unit(7));
        assertEquals(1001, fresh.getId());
        Unit again = world.add(units.get(5));
        assertSame(world, again.getWorld());
        assertEquals(1, again.getIndex());
        units.get(6).setPosition(-1, -2).setVelocity(0, 0);
        assertEquals(0, fresh.getX(), "rows of the old table are not those of the new one");
        world.restore(saved);
        assertEquals(units, world.units());
        assertEquals(saved.size(), world.size());
        assertEquals("", saved.difference(world.save()));
        assertNull(fresh.getWorld());
    }

    /** Steps of a world and of units that left it do not affect each other. */
    @Test
    void aClearedWorldStepsOnlyItsNewUnits() {
        World world = world(600);
        List<Unit> old = List.copyOf(world.units());
        world.clear();
        for (int i = 0; i < 600; i++) world.add(new Unit(2).setVelocity(0, 1));
        for (int i = 0; i < 60; i++) world.step();
        for (int i = 0; i < 600; i++) {
            assertEquals(i, old.get(i).getX());
            assertEquals(1, world.get(i).getY(), 1e-12);
        }
    }
}
