package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.StepListener;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/** Examples of ids, save and restore. {@link SnapshotPropertyTest} tests them after any history. */
class SnapshotTest {
    private final World world = new World();
    private final Unit a = world.add(new Unit(1)), b = world.add(new Unit(2)), c = world.add(new Unit(3));
    private final Snapshot saved = Saves.snapshot(world);

    @Test
    void idsCountTheAddedUnitsAndAreUnique() {
        assertEquals(0, new Unit(1).getId());
        assertEquals(List.of(1L, 2L, 3L), List.of(a.getId(), b.getId(), c.getId()));
        world.remove(a);
        assertEquals(1, a.getId(), "unchanged outside the world");
        assertNull(world.find(1));
        assertSame(c, world.find(3));
        assertEquals(4, world.add(a).getId());
        assertSame(a, world.find(4));
        assertNull(world.find(1));
        world.clear();
        assertNull(world.find(4));
        assertEquals(5, world.add(b).getId());
        assertEquals(1, new World().add(c).getId());
    }

    @Test
    void aRestoreRemovesAddedUnitsAndReturnsRemovedOnes() {
        world.remove(a);
        Unit d = world.add(new Unit(4));
        world.step(1);
        d.setPosition(5, 6);
        world.restore(saved);
        assertEquals(List.of(a, b, c), world.units());
        assertNull(d.getWorld());
        assertEquals(5, d.getX());
        assertEquals(0, world.getTick());
        assertEquals(4, world.add(d).getId(), "the id is used again");
    }

    @Test
    void aUnitAddedAgainHasItsFormerId() {
        assertSame(c, world.find(3));
        world.remove(c);
        assertEquals(4, world.add(c).getId());
        assertSame(c, world.find(4));
        world.restore(saved);
        assertEquals(3, c.getId());
        assertSame(c, world.find(3));
        assertNull(world.find(4));
    }

    @Test
    void aSnapshotCanBeRestoredManyTimes() {
        long hash = world.stateHash();
        for (int i = 0; i < 3; i++) {
            world.clear();
            world.restore(saved);
            assertEquals(hash, world.stateHash());
            a.applyForce(1, 1);
            world.advance(0.1);
            assertFalse(hash == world.stateHash());
        }
    }

    @Test
    void aSnapshotCanBeSavedIntoAgainByLargerAndSmallerWorlds() {
        IntStream up = IntStream.of(Tiles.sizes()), down = IntStream.of(Tiles.sizes());
        for (int size :
                IntStream.concat(up, down.map(i -> -i).sorted().map(i -> -i)).toArray()) {
            World other = new World();
            for (int i = 0; i < size; i++) other.add(new Unit(1).setPosition(i, 0));
            other.save(saved);
            assertEquals(size, saved.size());
            List<Unit> units = List.copyOf(other.units());
            long hash = other.stateHash();
            other.clear();
            other.restore(saved);
            assertEquals(units, other.units());
            assertEquals(hash, other.stateHash());
            assertEquals(size, Snapshot.fromBytes(saved.toBytes()).size());
        }
    }

    @Test
    void aSnapshotKeepsOnlyItsOwnUnitsAlive() {
        World other = new World();
        for (int i = 0; i < 4; i++) other.add(new Unit(1));
        WeakReference<Unit> unit = new WeakReference<>(other.get(3));
        other.save(saved);
        other.clear();
        other.add(new Unit(1));
        other.save(saved);
        world.save(saved); // three units, so the snapshot must not refer to the fourth
        for (int i = 0; i < 100 && unit.get() != null; i++) System.gc();
        assertNull(unit.get());
        assertEquals(3, saved.size());
    }

    @Test
    void theFactoryCreatesUnitsThatAreMissingInAnotherWorld() {
        World other = new World(Integrator.EXACT, Timestep.variable(1));
        Unit first = other.add(new Unit(9)), second = other.add(new Unit(9));
        other.restore(Snapshot.fromBytes(saved.toBytes()));
        assertSame(first, other.get(0));
        assertSame(second, other.get(1));
        assertSame(Unit.class, other.get(2).getClass());
        assertNotSame(c, other.get(2));
        assertEquals(
                List.of(1.0, 2.0, 3.0),
                List.of(first.getMass(), second.getMass(), other.get(2).getMass()));
        assertEquals(world.stateHash(), other.stateHash());
    }

    /** The cap reduces a sideways push by 170 orders of magnitude, and the forward velocity with it. */
    @ParameterizedTest
    @EnumSource
    void aVelocityThatTheCapHasMadeTinyCanBeRead(Integrator integrator) {
        World other = new World(integrator, Timestep.fixed(60));
        Unit ahead = other.add(new Unit(1).setMaxSpeed(1e-140).setVelocity(0, 9e-141));
        Unit aside = other.add(new Unit(1).setMaxSpeed(1e-140).setVelocity(9e-141, 0));
        ahead.applyForce(1e30, 0);
        aside.applyForce(0, 1e30);
        other.step(1);
        assertTrue(ahead.getVx() > 9.9e-141 && ahead.getVy() < 1e-300);
        assertTrue(aside.getVy() > 9.9e-141 && aside.getVx() < 1e-300);
        assertEquals(
                other.stateHash(),
                Saves.restored(Snapshot.fromBytes(Saves.of(other))).stateHash());
    }

    @Test
    void theSignOfZeroIsNotWritten() {
        byte[] zero = saved.toBytes(), minus = zero.clone();
        Map<String, Saves.Place> places = Saves.places(1);
        for (String name : Saves.STATE) {
            if (places.get(name).get(zero).equals(0.0)) places.get(name).put(minus, -0.0);
        }
        for (String name : List.of("remainderError", "time", "timeError", "droppedTime", "droppedTimeError")) {
            places.get(name).put(minus, -0.0);
        }
        assertFalse(Arrays.equals(zero, Saves.repair(minus)));
        assertArrayEquals(zero, Snapshot.fromBytes(minus).toBytes());
        World other = new World(Integrator.EULER, Timestep.fixed(20));
        other.add(new Unit(1)).applyForce(-5, 0);
        other.advance(0.05); // a whole step, so that the pending impulse is −5 · 0
        assertEquals(0L, Saves.places(0).get("pendingX").bits(Saves.of(other)));
    }

    /** Also below the rest threshold, with frozen and capped units. (Subnormal numbers are slow.) */
    @ParameterizedTest
    @EnumSource
    void aVelocityIsNeverSubnormal(Integrator integrator) {
        World other = new World(integrator, Timestep.fixed(60));
        for (int i = 0; i < 100; i++) {
            Unit unit = new Unit(1).setFriction(i).setMaxSpeed(i % 3 == 0 ? 0x1p-499 : 1);
            other.add(unit.setVelocity(Math.scalb(1.0 + i / 100.0, -500), Math.scalb(1.0, -490 - i)));
        }
        int resting = 0;
        for (int i = 0; i < 100; i++) {
            for (Unit unit : other) {
                double speed = Math.abs(unit.getVx());
                assertTrue(speed == 0 || speed >= Double.MIN_NORMAL, () -> "subnormal: " + speed);
                if (speed > 0 && speed < 0x1p-500) resting++;
            }
            Snapshot.fromBytes(Saves.of(other));
            if (i % 2 == 0) other.get(i).applyForce(1e-150, 1e-300);
            if (i % 3 == 0) other.get(i).setFrozen(i % 2 == 0);
            other.step();
        }
        assertTrue(resting > 50, resting + " units below the rest threshold");
    }

    /** A frozen unit below the rest threshold, alone and beside one that moves. */
    @ParameterizedTest
    @EnumSource
    void aFrozenUnitHasTheSameBitsBesideAnyOther(Integrator integrator) {
        World alone = new World(integrator, Timestep.fixed(60)), beside = new World(integrator, Timestep.fixed(60));
        for (World each : List.of(alone, beside)) {
            Unit unit = each.add(new Unit(1).setFriction(3).setVelocity(0x1.01p-500, 0x1.8p-500));
            each.step();
            unit.setFrozen(true);
        }
        beside.add(new Unit(1)).setVelocity(1, 0);
        for (int i = 0; i < 5; i++) {
            assertEquals(Churn.bits(alone.get(0)), Churn.bits(beside.get(0)), "after " + i + " steps");
            if (i == 2) beside.get(0).applyForce(1, 1);
            alone.step();
            beside.step();
        }
    }

    /** They left after the first of two steps, and lost the forces of the second. */
    @Test
    void unitsThatARestoreReturnsHaveNoForcesOfEarlierFrames() {
        World other = new World();
        Unit stays = other.add(new Unit(1));
        List<Unit> leave = List.of(other.add(new Unit(1)), other.add(new Unit(1)));
        for (Unit unit : other) unit.applyForce(60, 0);
        StepListener departure = (w, dt) -> leave.forEach(w::remove);
        other.addBeforeStep(departure);
        assertEquals(2, other.advance(1 / 30.0));
        other.removeStepListener(departure);
        stays.setVelocity(0, 0);
        leave.forEach(other::add);
        other.step();
        World alike = Saves.restored(other.save());
        for (World each : List.of(other, alike)) assertEquals(2, each.advance(1 / 30.0));
        assertEquals(0, stays.getVx());
        assertEquals(alike.stateHash(), other.stateHash());
    }

    @Test
    void aRestoreDoesNotChangeListenersAndPool() {
        List<World> stepped = new ArrayList<>();
        world.addBeforeStep((w, dt) -> stepped.add(w));
        world.restore(saved);
        world.step(1);
        assertEquals(List.of(world), stepped);
        World other = new World();
        other.restore(saved);
        other.step(1);
        assertEquals(List.of(world), stepped);
    }

    @Test
    void iteratorsFailAfterARestoreThatChangesTheUnits() {
        world.remove(c);
        Iterator<Unit> units = world.iterator();
        world.restore(saved);
        assertThrows(ConcurrentModificationException.class, units::next);
        Iterator<Unit> same = world.iterator();
        world.restore(saved);
        assertSame(a, same.next());
    }

    @Test
    void aDifferenceNamesUnitsAndValues() {
        World other = new World();
        other.restore(saved);
        assertEquals("", saved.difference(Saves.snapshot(other)));
        other.get(0).setPosition(0.5, 0);
        other.remove(other.get(1));
        other.add(new Unit(4));
        assertEquals("""
                lastId: 3 | 4
                unit 1 x: 0x0.0p0 (0.0) | 0x1.0p-1 (0.5)
                unit 1 previousX: 0x0.0p0 (0.0) | 0x1.0p-1 (0.5)
                unit 2: index 1 | missing
                unit 3: index 2 | index 1
                unit 4: missing | index 2
                """, saved.difference(Saves.snapshot(other)));
    }

    @Test
    void aDifferenceHasAtMostAHundredLines() {
        for (int i = 0; i < 500; i++) world.add(new Unit(1));
        String lines = saved.difference(Saves.snapshot(world));
        assertEquals(101, lines.lines().count());
        assertTrue(lines.endsWith("\nand 402 more\n"), lines); // lastId, size and 500 units are 502
    }

    @Test
    void aDifferenceOfExactlyAHundredLinesShowsAll() {
        for (int i = 0; i < 98; i++) world.add(new Unit(1)); // and lastId, and size
        String lines = saved.difference(Saves.snapshot(world));
        assertEquals(100, lines.lines().count());
        assertTrue(
                lines.endsWith("\nunit " + world.get(world.size() - 1).getId() + ": missing | index "
                        + (world.size() - 1) + "\n"),
                lines);
    }

    /** Counts are shown as integers, times as doubles. */
    @Test
    void aDifferenceContainsTheTime() {
        World now = new World(Integrator.EULER, Timestep.fixed(4)),
                later = new World(Integrator.EULER, Timestep.fixed(4));
        later.step(0.5);
        later.step();
        later.advance(0.125);
        assertEquals("""
                tick: 0 | 2
                regularTicks: 0 | 1
                remainder: 0 | 500000000
                time: 0x0.0p0 (0.0) | 0x1.0p-1 (0.5)
                """, now.save().difference(later.save()));
        later.advance(0.1 / 3);
        String lines = now.save().difference(later.save());
        assertTrue(lines.matches("(?s).*\\nremainderError: 0x0\\.0p0 \\(0\\.0\\) \\| -?0x.*"), lines);
    }
}
