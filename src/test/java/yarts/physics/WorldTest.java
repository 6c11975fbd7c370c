package yarts.physics;

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

/** Membership, order and the listener, by example. Time and interpolation: {@link WorldTimeTest}. */
class WorldTest {
    private static class Tank extends Unit {
        int shells = 3;

        Tank(double mass) {
            super(mass);
        }
    }

    private final World world = new World();
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
    void theLastUnitFillsTheHoleThatRemoveLeaves() {
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
    void anyOtherChangeFailsTheIteratorFast() {
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
    void unitsIsALiveViewThatCannotBeModified() {
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
    void unitsKeepTheirStateInAndOutOfAWorld() {
        a.setPosition(1, 2).setVelocity(3, 4).setFriction(0.5).setMaxSpeed(6);
        a.applyForce(7, 8);
        String before = a.toString() + a.getFriction() + a.getMaxSpeed() + a.getFx() + a.getFy();
        world.add(a);
        assertEquals(before, a.toString() + a.getFriction() + a.getMaxSpeed() + a.getFx() + a.getFy());
        world.clear();
        assertNull(a.getWorld());
        assertEquals(before, a.toString() + a.getFriction() + a.getMaxSpeed() + a.getFx() + a.getFy());
    }

    @Test
    void theListenerIsCalledBeforeEveryStepWithItsLength() {
        List<Double> lengths = new ArrayList<>();
        world.setStepListener((w, dt) -> {
            assertSame(world, w);
            assertEquals(lengths.size(), w.getTick());
            lengths.add(dt);
        });
        assertEquals(2, world.advance(0.04));
        world.step(0.5);
        world.setStepListener(null);
        world.step(0.25);
        assertEquals(List.of(1 / 60.0, 1 / 60.0, 0.5), lengths);
        assertEquals(4, world.getTick());
    }

    @Test
    void aForceOfTheListenerActsForItsStepAndAddsToTheFrames() {
        world.add(a);
        world.setStepListener((w, dt) -> {
            if (w.getTick() == 1) a.applyForce(60, 0);
        });
        a.applyForce(0, 60);
        world.advance(0.051); // three steps
        assertEquals(1, a.getVx(), 1e-15);
        assertEquals(3, a.getVy(), 1e-15);
        assertEquals(0, a.getFx());
    }

    @Test
    void unitsMayComeAndGoInTheListener() {
        world.add(a);
        world.add(b);
        world.setStepListener((w, dt) -> {
            if (w.getTick() == 1) {
                w.remove(a);
                c.applyForce(180, 0);
                w.add(c);
            }
        });
        a.setVelocity(60, 0);
        c.setVelocity(0, 60);
        b.applyForce(120, 0);
        assertEquals(3, world.advance(0.051));
        assertEquals(1, a.getX(), 1e-15, "a took the first step");
        assertEquals(2, c.getY(), 1e-15, "c took the second and the third");
        assertEquals(1, c.getVx(), 1e-15, "and the force that it brought acted for the second");
        assertEquals(3, b.getVx(), 1e-15, "the frame's force acts on b in all");
        assertEquals(List.of(b, c), world.units());
    }

    @Test
    void aStepWithinAStepIsRefused() {
        world.add(a).setVelocity(1, 0);
        world.setStepListener((w, dt) -> {
            assertThrows(IllegalStateException.class, () -> w.step(1));
            assertThrows(IllegalStateException.class, () -> w.advance(1));
            assertThrows(IllegalStateException.class, () -> w.advance(0));
        });
        world.step(2);
        assertEquals(1, world.getTick());
        assertEquals(2, a.getX());
        World other = new World();
        world.setStepListener((w, dt) -> other.step(dt));
        world.step(1);
        assertEquals(1, other.getTick());
    }

    @Test
    void anExceptionOfTheListenerLeavesTheWorldSane() {
        world.add(a);
        world.setStepListener((w, dt) -> {
            if (w.getTick() == 1) throw new UnsupportedOperationException("no second step");
        });
        a.applyForce(60, 0);
        assertThrows(UnsupportedOperationException.class, () -> world.advance(0.051)); // three steps due
        assertEquals(1, world.getTick());
        assertEquals(1, a.getVx(), 1e-15);
        assertEquals(0, a.getFx());
        assertEquals(2 / 60.0, world.getDroppedTime(), 1e-15);
        world.setStepListener(null);
        assertEquals(1, world.advance(1 / 60.0));
        assertEquals(1.06, a.getVx(), 1e-12, "the force's last ms was in the remainder, and carried");
        world.setStepListener((w, dt) -> {
            throw new UnsupportedOperationException("nor a step");
        });
        assertThrows(UnsupportedOperationException.class, () -> world.step(1));
        world.setStepListener(null);
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
        world.clear();
        world.copyPositions(small, 8);
    }
}
