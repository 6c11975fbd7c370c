package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Listeners;

/** The drawn positions in each frame while a game corrects the positions of units. */
class CorrectionTest {
    private static final double FRAME = 0.0125, STEP = 0.1; // s

    private final World world = new World(Integrator.EULER, Timestep.fixed(10));
    private final Listeners listeners = new Listeners(world);

    /** The drawn x of a unit in each of some frames. */
    private List<Double> drawn(Unit unit, int frames) {
        List<Double> xs = new ArrayList<>();
        float[] xy = new float[2 * world.size()];
        for (int i = 0; i < frames; i++) {
            world.advance(FRAME);
            xs.add(unit.getInterpolatedX());
            world.copyPositions(xy, 0);
            assertEquals((float) unit.getInterpolatedX(), xy[2 * world.units().indexOf(unit)]);
        }
        return xs;
    }

    /** Checks that x never decreases, and never grows faster than the speed. */
    private static void assertSmooth(List<Double> xs, double speed) {
        for (int i = 1; i < xs.size(); i++) {
            double way = xs.get(i) - xs.get(i - 1);
            assertTrue(way >= -1e-12 && way <= speed * FRAME + 1e-9, i + ": " + xs.get(i - 1) + " to " + xs.get(i));
        }
    }

    /** The longest move that is interpolated, on each axis, and the shortest that is not. */
    @Test
    void aMoveIsDrawnIfItsDistanceIsFinite() {
        Unit tank = world.add(new Unit(1));
        assertSame(tank, tank.moveTo(1, 2), "before a step, it is a teleport");
        assertEquals(1, tank.getInterpolatedX(0));
        tank.setPosition(0, 0);
        world.step();
        double most = Double.MAX_VALUE;
        for (double[] to : new double[][] {{most, 0}, {0, most}, {-most, -most}}) {
            assertSame(tank, tank.moveTo(to[0], to[1]));
            assertEquals(0, tank.getInterpolatedX(0));
            assertEquals(0, tank.getInterpolatedY(0));
            assertEquals(to[0] / 2, tank.getInterpolatedX(0.5));
            assertEquals(to[1] / 2, tank.getInterpolatedY(0.5));
        }
        for (double[] to : new double[][] {{-most, 0}, {0, -most}}) {
            tank.setPosition(-to[0] * 1e-15, -to[1] * 1e-15).moveTo(to[0], to[1]);
            assertEquals(to[0], tank.getInterpolatedX(0));
            assertEquals(to[1], tank.getInterpolatedY(0));
        }
    }

    @Test
    void noUnitIsDrawnInsideAWall() {
        Unit tank = world.add(new Unit(1).setPosition(9, 0).setVelocity(10, 5));
        listeners.setAfter((w, dt) -> {
            if (tank.getX() > 9.5) tank.moveTo(9.5, tank.getY()).setVelocity(0, tank.getVy());
        });
        List<Double> xs = drawn(tank, 40);
        assertSmooth(xs, 10);
        assertEquals(9.5, xs.stream().mapToDouble(x -> x).max().orElseThrow());
        assertEquals(9.5, xs.get(39));
        assertTrue(xs.get(12) > 9 && xs.get(12) < 9.5, "on its way there: " + xs.get(12));
        assertEquals(2.5 - STEP / 2 * 5 + STEP * 5 / 2, tank.getY(), 1e-12); // it slides along the wall
    }

    /** Two units that overlap are moved apart after each step; neither is drawn with a jump. */
    @Test
    void theCorrectionOfAnOverlapIsDrawnSmoothly() {
        Unit a = world.add(new Unit(1).setPosition(0, 0).setVelocity(10, 0));
        Unit b = world.add(new Unit(1).setPosition(5, 0));
        listeners.setAfter((w, dt) -> {
            double overlap = 2 - (b.getX() - a.getX());
            if (overlap <= 0) return;
            a.moveTo(a.getX() - overlap / 2, 0);
            b.moveTo(b.getX() + overlap / 2, 0);
        });
        List<Double> xs = new ArrayList<>(), others = new ArrayList<>();
        for (int i = 0; i < 80; i++) {
            world.advance(FRAME);
            xs.add(a.getInterpolatedX());
            others.add(b.getInterpolatedX());
            assertTrue(b.getInterpolatedX() - a.getInterpolatedX() >= 2 - 1e-9, "they are never drawn overlapping");
        }
        assertSmooth(xs, 10);
        assertSmooth(others, 10);
        assertTrue(others.get(79) > 7, "one pushes the other");
    }

    /** A map that wraps round: a deliberate teleport before the step. Modulo the size of the map, there is no jump. */
    @Test
    void aUnitThatCrossesTheEdgeOfAMapThatWrapsIsDrawnWithoutAJump() {
        double map = 20;
        Unit tank = world.add(new Unit(1).setPosition(18.2, 0).setVelocity(10, 0));
        listeners.setBefore((w, dt) -> {
            if (tank.getX() >= map) tank.setPosition(tank.getX() - map, tank.getY());
        });
        List<Double> xs = drawn(tank, 200);
        int jumps = 0;
        for (int i = 1; i < xs.size(); i++) {
            double way = xs.get(i) - xs.get(i - 1);
            if (way < 0) {
                jumps++;
                way += map;
            }
            assertTrue(way >= -1e-9 && way <= 10 * FRAME + 1e-9, i + ": " + way);
            assertTrue(xs.get(i) < map + 10 * STEP, "at most a step beyond the edge");
        }
        assertEquals(2, jumps);
    }

    /**
     * The origin of the map follows the tank: all units and the camera are moved equally, so the picture does not
     * change.
     */
    @Test
    void aFloatingOriginDoesNotChangeThePicture() {
        Unit tank = world.add(new Unit(1).setVelocity(100, 0));
        Unit rock = world.add(new Unit(1).setPosition(50, 0));
        double[] origin = {0, 0}; // of the state, and of the step before
        listeners.setBefore((w, dt) -> {
            if (tank.getX() < 30) return;
            double shift = tank.getX();
            for (Unit unit : w) unit.setPosition(unit.getX() - shift, unit.getY());
            origin[0] += shift;
        });
        double last = 0;
        for (int i = 0; i < 400; i++) {
            world.advance(FRAME);
            double x = origin[0] + tank.getInterpolatedX();
            if (i >= STEP / FRAME) assertEquals(100 * FRAME, x - last, 1e-9, "frame " + i);
            assertEquals(50, origin[0] + rock.getInterpolatedX(), 1e-9);
            assertTrue(Math.abs(tank.getInterpolatedX()) <= 40 + 1e-9);
            last = x;
        }
        assertTrue(origin[0] > 400);
    }

    /** A lift or a train: the game sets its position after each step. */
    @Test
    void aUnitThatIsMovedByScriptIsDrawnSmoothly() {
        Unit lift = world.add(new Unit(1));
        listeners.setAfter((w, dt) -> lift.moveTo(3 * w.getTime(), 0));
        List<Double> xs = drawn(lift, 100);
        for (int i = 8; i < 100; i++) assertEquals(3 * FRAME, xs.get(i) - xs.get(i - 1), 1e-12);
        assertEquals(3 * (100 * FRAME - STEP), xs.get(99), 1e-12, "a step behind the time, as all units");
    }

    @Test
    void withoutAPositionBeforeTheStepAMoveIsATeleport() {
        Unit tank = world.add(new Unit(1).setVelocity(10, 0));
        world.advance(0.15);
        tank.setPosition(1000, 0);
        assertEquals(1000, tank.getInterpolatedX());
        assertEquals(1000, tank.getInterpolatedX(0));
        listeners.setBefore((w, dt) -> tank.setPosition(2000, 0));
        world.advance(0.1);
        assertEquals(2000, tank.getInterpolatedX(0));
        assertEquals(2000.5, tank.getInterpolatedX(), 1e-12);
        Unit elsewhere = new World().add(new Unit(1));
        listeners.setAfter((w, dt) -> elsewhere.moveTo(7, 0));
        world.advance(0.1);
        assertEquals(7, elsewhere.getInterpolatedX(0), "a unit of another world");
    }

    /** A distance that overflows is not interpolated. */
    @Test
    void aCorrectionAcrossAllDoublesStaysFinite() {
        Unit tank = world.add(new Unit(1).setPosition(-Double.MAX_VALUE, Double.MAX_VALUE));
        listeners.setAfter((w, dt) -> tank.moveTo(Double.MAX_VALUE, -Double.MAX_VALUE));
        world.advance(0.15);
        for (double alpha : new double[] {0, 0.3, 1}) {
            assertTrue(Double.isFinite(tank.getInterpolatedX(alpha)) && Double.isFinite(tank.getInterpolatedY(alpha)));
        }
        World restored = new World();
        restored.restore(world.save());
        assertEquals(world.stateHash(), restored.stateHash());
    }
}
