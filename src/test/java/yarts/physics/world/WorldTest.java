package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Listeners;
import yarts.physics.time.WorldTimeTest;

/** Examples of membership, order and listeners. {@link WorldTimeTest} has time and interpolation. */
class WorldTest {
    private static class Tank extends Unit {
        int shells = 3;

        Tank(double mass) {
            super(mass);
        }
    }

    private final World world = new World(Integrator.EULER, Timestep.fixed(60));
    private final Listeners listeners = new Listeners(world);
    private final Unit a = new Unit(1), b = new Unit(2), c = new Unit(3), d = new Unit(4);

    private void addAll() {
        for (Unit unit : List.of(a, b, c, d)) world.add(unit);
    }

    @Test
    void unitsAreInTheOrderInWhichTheyWereAdded() {
        addAll();
        assertEquals(List.of(a, b, c, d), world.units());
        assertSame(c, world.get(2));
        assertEquals(4, world.size());
        List<Unit> seen = new ArrayList<>();
        for (Unit unit : world) seen.add(unit);
        assertEquals(world.units(), seen);
        assertThrows(IndexOutOfBoundsException.class, () -> world.get(4));
        assertThrows(IndexOutOfBoundsException.class, () -> world.get(-1));
    }

    @Test
    void theLastUnitTakesTheIndexOfARemovedOne() {
        addAll();
        assertTrue(world.remove(b));
        assertEquals(List.of(a, d, c), world.units());
        assertEquals(1, world.units().indexOf(d));
        assertTrue(world.remove(c));
        assertEquals(List.of(a, d), world.units());
        assertEquals(4, d.getMass());
        assertFalse(world.remove(b));
        assertFalse(world.remove(null));
    }

    @Test
    void removingThroughTheIteratorVisitsEveryUnitOnce() {
        addAll();
        List<Unit> seen = new ArrayList<>();
        for (Iterator<Unit> i = world.iterator(); i.hasNext(); ) {
            Unit unit = i.next();
            seen.add(unit);
            if (unit == a || unit == d) i.remove();
        }
        assertEquals(4, seen.size());
        assertTrue(seen.containsAll(List.of(a, b, c, d)));
        assertEquals(List.of(c, b), world.units());
    }

    @Test
    void theIteratorThrowsAfterAnyOtherChange() {
        addAll();
        Iterator<Unit> afterAdd = world.iterator();
        world.add(new Unit(5));
        assertThrows(ConcurrentModificationException.class, afterAdd::next);
        Iterator<Unit> afterRemove = world.iterator();
        world.remove(a);
        assertThrows(ConcurrentModificationException.class, afterRemove::next);
        Iterator<Unit> afterClear = world.units().iterator();
        world.clear();
        assertThrows(ConcurrentModificationException.class, afterClear::next);
    }

    @Test
    void unitsReturnsALiveViewThatCannotBeModified() {
        List<Unit> units = world.units();
        addAll();
        assertEquals(4, units.size());
        assertSame(units, world.units());
        assertThrows(UnsupportedOperationException.class, () -> units.remove(0));
        assertThrows(UnsupportedOperationException.class, () -> units.add(new Unit(1)));
        assertThrows(UnsupportedOperationException.class, units::clear);
        Iterator<Unit> i = units.iterator();
        i.next();
        assertThrows(UnsupportedOperationException.class, i::remove);
        assertEquals(4, world.size());
        world.clear();
        assertTrue(units.isEmpty());
    }

    @Test
    void aUnitIsInOneWorldOnly() {
        world.add(a);
        World other = new World();
        Exception here = assertThrows(IllegalStateException.class, () -> world.add(a));
        Exception there = assertThrows(IllegalStateException.class, () -> other.add(a));
        assertTrue(here.getMessage().contains("this world already"), here.getMessage());
        assertTrue(there.getMessage().contains("another"), there.getMessage());
        assertThrows(NullPointerException.class, () -> world.add(null));
        assertEquals(1, world.size());
        assertEquals(0, other.size());
        assertFalse(other.remove(a));
        assertFalse(other.contains(a));
        assertFalse(world.contains(null));
        assertSame(world, a.getWorld());
        assertTrue(world.remove(a));
        assertNull(a.getWorld());
        other.add(a);
        assertSame(other, a.getWorld());
    }

    @Test
    void aTankIsAUnit() {
        Tank tank = world.add(new Tank(40_000));
        tank.shells--;
        tank.applyForce(40_000, 0);
        world.step(1);
        assertEquals(1, tank.getVx());
        assertEquals(2, ((Tank) world.get(0)).shells);
    }

    @Test
    void unitsThatJoinOrLeaveKeepTheirStateAndLoseTheirForces() {
        a.setPosition(1, 2).setVelocity(3, 4).setFriction(0.5).setMaxSpeed(6).setFrozen(true);
        String before = a.toString().replaceAll("#\\d+", "");
        List<Runnable> moves = List.of(
                () -> world.add(a),
                () -> world.remove(a),
                () -> world.add(a),
                world::clear,
                () -> world.add(a),
                () -> world.removeIf(unit -> unit == a));
        for (Runnable move : moves) {
            a.setFrozen(false);
            a.applyForce(7, 8);
            world.advance(1e-3); // now it is a pending impulse, if the unit is in the world
            a.applyForce(7, 8);
            a.setFrozen(false);
            move.run();
            assertNoForces(a);
            assertEquals(before, a.setFrozen(true).toString().replaceAll("#\\d+", ""));
        }
        assertNull(a.getWorld());
    }

    private static void assertNoForces(Unit unit) {
        for (double v :
                new double[] {unit.getFx(), unit.getFy(), unit.getPendingImpulseX(), unit.getPendingImpulseY()}) {
            assertEquals(0, v);
        }
    }

    @Test
    void theListenerIsCalledBeforeEveryStepWithItsLength() {
        List<Double> lengths = new ArrayList<>();
        listeners.setBefore((w, dt) -> {
            assertSame(world, w);
            assertEquals(lengths.size(), w.getTick());
            lengths.add(dt);
        });
        assertEquals(2, world.advance(0.04));
        world.step(0.5);
        listeners.clear();
        world.step(0.25);
        assertEquals(List.of(1 / 60.0, 1 / 60.0, 0.5), lengths);
        assertEquals(4, world.getTick());
    }

    @Test
    void aForceFromAListenerActsForItsStepInAdditionToTheForceOfTheFrame() {
        world.add(a);
        listeners.setBefore((w, dt) -> {
            if (w.getTick() == 1) a.applyForce(60, 0);
        });
        a.applyForce(0, 60);
        world.advance(0.051); // three steps
        assertEquals(1, a.getVx(), 1e-15);
        assertEquals(3, a.getVy(), 1e-15);
        assertEquals(0, a.getFx());
    }

    @Test
    void aListenerMayAddAndRemoveUnits() {
        world.add(a);
        world.add(b);
        listeners.setBefore((w, dt) -> {
            if (w.getTick() == 1) {
                w.remove(a);
                c.applyForce(1e9, 0);
                w.add(c);
                c.applyForce(180, 0);
            }
        });
        a.setVelocity(60, 0);
        c.setVelocity(0, 60);
        b.applyForce(120, 0);
        assertEquals(3, world.advance(0.051));
        assertEquals(1, a.getX(), 1e-15, "a moved only in the first step");
        assertEquals(2, c.getY(), 1e-15, "c moved in the second and the third");
        assertEquals(1, c.getVx(), 1e-15, "the force that was applied after it was added acted in the second step");
        assertEquals(3, b.getVx(), 1e-15, "the force of the frame acts on b in all steps");
        assertEquals(List.of(b, c), world.units());
    }

    /** The removed unit was pushed in this frame; the unit that takes its row, in the frame before. */
    @Test
    void aUnitWhoseRowMovesToAnotherTileDuringAFrameHasNoOldForces() {
        for (int i = 0; i <= Tiles.TILE; i++) world.add(new Unit(1));
        Unit first = world.get(0), pushed = world.get(1), other = world.get(2), last = world.get(Tiles.TILE);
        last.applyForce(600, 0);
        assertEquals(2, world.advance(2 / 60.0));
        assertEquals(20, last.getVx(), 1e-14);
        double v = last.getVx();
        pushed.applyForce(60, 0);
        other.applyForce(60, 0);
        listeners.setBefore((w, dt) -> w.remove(first));
        assertEquals(2, world.advance(2 / 60.0));
        assertSame(last, world.get(0));
        assertEquals(2, pushed.getVx(), 1e-14);
        assertEquals(v, last.getVx());
        assertEquals(0, last.getFx());
    }

    /** The units of the tile were pushed in the frame before; the unit that moves there, in this frame. */
    @Test
    void aUnitWhoseRowComesFromAnotherTileDuringAFrameDoesNotRepeatOldForces() {
        for (int i = 0; i <= Tiles.TILE; i++) world.add(new Unit(1));
        Unit first = world.get(0), other = world.get(1), last = world.get(Tiles.TILE);
        other.applyForce(600, 0);
        assertEquals(2, world.advance(2 / 60.0));
        double v = other.getVx();
        last.applyForce(60, 0);
        listeners.setBefore((w, dt) -> w.remove(first));
        assertEquals(2, world.advance(2 / 60.0));
        assertEquals(2, last.getVx(), 1e-14);
        assertEquals(v, other.getVx());
        assertEquals(0, other.getFx());
    }

    @Test
    void aForceOfTheFrameMovesWithItsRowToAnotherTile() {
        for (int i = 0; i <= Tiles.TILE; i++) world.add(new Unit(1));
        Unit first = world.get(0), last = world.get(Tiles.TILE);
        last.applyForce(60, 0);
        listeners.setBefore((w, dt) -> w.remove(first));
        assertEquals(3, world.advance(3 / 60.0));
        assertEquals(3, last.getVx(), 1e-14);
    }

    @Test
    void listenersAreCalledBeforeAndAfterEveryStep() {
        List<String> calls = new ArrayList<>();
        world.addBeforeStep((w, dt) -> calls.add("before " + w.getTick() + ": " + dt));
        world.addAfterStep((w, dt) -> {
            assertSame(world, w);
            calls.add("after " + w.getTick() + ": " + dt);
        });
        world.step(0.5);
        world.advance(2 / 60.0);
        double dt = 1 / 60.0;
        assertEquals(
                List.of(
                        "before 0: 0.5",
                        "after 1: 0.5",
                        "before 1: " + dt,
                        "after 2: " + dt,
                        "before 2: " + dt,
                        "after 3: " + dt),
                calls);
    }

    /** The units drive into a wall at x = 1: they are drawn from the start of the step to the wall. */
    @Test
    void aMoveAfterAStepIsDrawnFromTheStartOfTheStep() {
        world.add(a).setVelocity(45, 0);
        world.add(b).setVelocity(45, 0);
        listeners.setAfter((w, dt) -> {
            if (a.getX() > 1) a.moveTo(1, 0);
            if (c.getWorld() == null) world.add(c).moveTo(7, 8);
            world.remove(b);
            world.add(b).moveTo(3, 4);
        });
        world.advance(2.5 / 60); // to 0.75, and to 1.5
        assertEquals(1, a.getX());
        assertEquals(0.75, a.getInterpolatedX(0));
        assertEquals(0.875, a.getInterpolatedX(), 1e-12);
        assertEquals(3, b.getInterpolatedX(0), "it was added again after the step");
        assertEquals(7, c.getInterpolatedX(0), 1e-12);
        listeners.clear();
        a.setPosition(0, 0);
        assertEquals(0, a.getInterpolatedX(0), "between steps it is a teleport");
        World other = new World();
        other.add(d).setVelocity(1, 0);
        other.step(1);
        listeners.setAfter((w, dt) -> d.moveTo(9, 9));
        world.step();
        assertEquals(0, d.getInterpolatedX(0), "its position before the last step of its own world");
    }

    @Test
    void aMoveOverAnInfiniteDistanceIsATeleport() {
        double far = Double.MAX_VALUE;
        for (double[] to : new double[][] {{far, 0}, {0, far}, {far, far}}) {
            world.add(a).setPosition(-to[0], -to[1]).setVelocity(1, 1);
            listeners.setAfter((w, dt) -> a.moveTo(to[0], to[1]));
            world.step();
            assertEquals(to[0], a.getInterpolatedX(0.5));
            assertEquals(to[1], a.getInterpolatedY(0.5));
            world.remove(a);
        }
    }

    @Test
    void anExceptionAfterAStepDoesNotUndoTheStep() {
        world.add(a);
        a.applyForce(60, 0);
        listeners.setAfter((w, dt) -> {
            if (world.getTick() == 2) throw new UnsupportedOperationException("no third step");
        });
        assertThrows(UnsupportedOperationException.class, () -> world.advance(4 / 60.0));
        assertEquals(2, world.getTick());
        assertEquals(2, a.getVx(), 1e-15);
        assertNoForces(a);
        assertEquals(2 / 60.0, world.getDroppedTime(), 1e-15);
        listeners.clear();
        world.advance(1 / 60.0);
        assertEquals(2, a.getVx(), 1e-15, "the force of the frame is discarded with its other steps");
    }

    /** Its forces and those that the listener has applied are discarded. */
    @Test
    void anExceptionBeforeAStepDiscardsAllForces() {
        World twin = new World(Integrator.EULER, Timestep.fixed(60));
        for (World w : List.of(world, twin)) {
            w.add(new Unit(2)).setVelocity(3, 4);
            w.step(0.1);
        }
        long before = world.stateHash();
        listeners.setBefore((w, dt) -> {
            w.get(0).applyForce(5, 6);
            throw new UnsupportedOperationException("no step");
        });
        world.get(0).applyForce(1, 2);
        assertThrows(UnsupportedOperationException.class, () -> world.step(1));
        assertEquals(before, world.stateHash());
        assertEquals("", world.save().difference(twin.save()));
        world.get(0).applyForce(1, 2);
        assertThrows(UnsupportedOperationException.class, () -> world.advance(1 / 60.0));
        assertNoForces(world.get(0));
        assertEquals(0.1, world.getTime());
        assertEquals(1 / 60.0, world.getDroppedTime());
    }

    @Test
    void unitsAreFoundById() {
        addAll();
        assertSame(c, world.find(3));
        assertNull(world.find(0));
        assertNull(world.find(5));
        world.remove(b);
        assertNull(world.find(2));
        world.add(b);
        assertSame(b, world.find(5));
        assertSame(d, world.find(4));
        world.clear();
        assertNull(world.find(4));
    }

    @Test
    void removeIfTestsEachUnitOnceInTheOrderOfTheIterator() {
        addAll();
        List<Unit> asked = new ArrayList<>();
        assertTrue(world.removeIf(unit -> {
            asked.add(unit);
            return unit == a || unit == d;
        }));
        assertEquals(List.of(a, d, c, b), asked, "the last unit takes the index, and is tested next");
        assertEquals(List.of(c, b), world.units());
        assertFalse(world.removeIf(unit -> false));
        assertThrows(
                ConcurrentModificationException.class,
                () -> world.removeIf(unit -> world.add(new Unit(1)).getMass() < 0));
        assertThrows(NullPointerException.class, () -> world.removeIf(null));
    }

    @Test
    void gettersReturnThePendingImpulse() {
        world.add(a);
        a.applyForce(60, -30);
        assertEquals(60, a.getFx());
        world.advance(0.01); // less than a step
        assertEquals(0, a.getFx());
        assertEquals(0.6, a.getPendingImpulseX(), 1e-15);
        assertEquals(-0.3, a.getPendingImpulseY(), 1e-15);
        world.step(0.5);
        assertEquals(0.6, a.getPendingImpulseX(), 1e-15, "step(dt) does not change it");
        world.advance(0.01);
        assertEquals(0, a.getPendingImpulseX());
        assertEquals(0.6, a.getVx(), 1e-15);
        a.applyForce(60, 0);
        world.advance(0.01);
        a.clearForces();
        assertNoForces(a);
    }

    @Test
    void forcesOfABulkCallAddToOthers() {
        addAll();
        b.applyForce(1, 2);
        world.applyForces(new double[] {9, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 1);
        assertEquals(1, a.getFx());
        assertEquals(4, b.getFx());
        assertEquals(6, b.getFy());
        assertEquals(8, d.getFy());
        world.step(4);
        assertEquals(4, a.getVx());
        assertEquals(8, d.getVy());
        assertEquals(0, d.getFy());
        double[] v = new double[9];
        world.copyVelocities(v, 1);
        assertArrayEquals(new double[] {0, 4, 8, 8, 12, 20 / 3.0, 8, 7, 8}, v, 1e-14);
    }

    @Test
    void aStepWithinAStepThrows() {
        world.add(a).setVelocity(1, 0);
        List<Executable> invalidCalls = List.of(
                () -> world.step(1),
                world::step,
                () -> world.advance(1),
                () -> world.advance(0),
                world::save,
                () -> world.save(new Snapshot()),
                () -> world.restore(new Snapshot()),
                () -> world.setIntegrator(Integrator.EXACT),
                () -> world.setTimestep(Timestep.fixed(30)));
        Runnable makeInvalidCalls = () -> {
            for (Executable each : invalidCalls) {
                assertEquals(
                        "a step of this world is running: until it ends, no listener, factory or other thread"
                                + " may step, save or restore the world, or set its integrator or timestep",
                        assertThrows(IllegalStateException.class, each).getMessage());
            }
        };
        listeners.setBefore((w, dt) -> makeInvalidCalls.run());
        world.step(1);
        listeners.setAfter((w, dt) -> makeInvalidCalls.run());
        world.step(1);
        assertSame(Integrator.EULER, world.getIntegrator());
        assertEquals(2, world.getTick());
        assertEquals(2, a.getX());
        World other = new World();
        listeners.setBefore((w, dt) -> other.step(dt));
        world.step(1);
        assertEquals(1, other.getTick());
    }

    @Test
    void aStepHasTheLengthOfTheTimestep() {
        world.add(a).setVelocity(60, 0);
        world.step();
        assertEquals(1, a.getX());
        world.setTimestep(Timestep.variable(0.5));
        world.step();
        assertEquals(31, a.getX());
        assertEquals(1 / 60.0 + 0.5, world.getTime(), 1e-15);
    }

    @Test
    void theIntegratorCanBeSet() {
        world.add(a).setFriction(1).setVelocity(1, 0);
        world.setIntegrator(Integrator.EXACT);
        assertSame(Integrator.EXACT, world.getIntegrator());
        world.step(1);
        assertEquals(Math.exp(-1), a.getVx(), 1e-15);
    }

    /** {@code TimestepChangeTest} has the details. */
    @Test
    void aChangeOfTheTimestepPreservesWaitingTimeAndImpulse() {
        world.setTimestep(Timestep.fixed(10));
        world.add(a);
        a.applyForce(20, 0);
        world.advance(0.05);
        assertEquals(1, a.getPendingImpulseX(), 1e-15);
        Timestep next = Timestep.fixed(16);
        world.setTimestep(next);
        assertSame(next, world.getTimestep());
        assertEquals(0.8, world.getAlpha());
        assertEquals(1, a.getPendingImpulseX(), 1e-15);
        assertEquals(1, world.advance(0.0125));
        assertEquals(1, a.getVx(), 1e-15);
        assertEquals(0.0625, world.getTime());
        assertEquals(0, world.getAlpha());
    }

    @Test
    void afterAnExceptionOfAListenerTheWorldContinues() {
        world.add(a);
        listeners.setBefore((w, dt) -> {
            if (w.getTick() == 1) throw new UnsupportedOperationException("no second step");
        });
        a.applyForce(60, 0);
        assertThrows(UnsupportedOperationException.class, () -> world.advance(0.051)); // three steps due
        assertEquals(1, world.getTick());
        assertEquals(1, a.getVx(), 1e-15);
        assertEquals(0, a.getFx());
        assertEquals(2 / 60.0, world.getDroppedTime(), 1e-15);
        listeners.clear();
        assertEquals(1, world.advance(1 / 60.0));
        assertEquals(1.06, a.getVx(), 1e-12, "the impulse of the last ms was pending");
        listeners.setBefore((w, dt) -> {
            throw new UnsupportedOperationException("nor a step");
        });
        assertThrows(UnsupportedOperationException.class, () -> world.step(1));
        listeners.clear();
        world.step(0);
        assertEquals(3, world.getTick());
    }

    @Test
    void copyPositionsWritesAllOrNothing() {
        addAll();
        a.setPosition(1, 2);
        d.setPosition(1e300, -1e300);
        float[] xy = new float[11];
        world.copyPositions(xy, 3);
        float max = Float.MAX_VALUE;
        assertArrayEquals(new float[] {0, 0, 0, 1, 2, 0, 0, 0, 0, max, -max}, xy);
        float[] small = {9, 9, 9, 9, 9, 9, 9, 9};
        assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(small, 1));
        assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(small, -1));
        assertArrayEquals(new float[] {9, 9, 9, 9, 9, 9, 9, 9}, small);
        double[] doubles = new double[9];
        world.copyPositions(doubles, 1, 1);
        assertArrayEquals(new double[] {0, 1, 2, 0, 0, 0, 0, 1e300, -1e300}, doubles);
        double[] few = {9, 9, 9, 9, 9, 9, 9, 9};
        assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(few, 1, 1));
        assertThrows(IndexOutOfBoundsException.class, () -> world.copyVelocities(few, 1));
        assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(small, -1, 1));
        assertArrayEquals(new double[] {9, 9, 9, 9, 9, 9, 9, 9}, few);
        world.clear();
        world.copyPositions(small, 8);
        world.copyVelocities(few, 8);
    }
}
