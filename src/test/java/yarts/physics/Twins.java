package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * A world beside a plain model of it: lists, and for every unit a twin that is never in a world. Time is counted in
 * integers, and a force's impulse as its definition says. Each step's forces must be those of the model but for
 * rounding; the twin then takes them as they are, so that whatever follows must be the same bits.
 */
final class Twins {
    private static final long SECOND = 1_000_000_000;

    private static final class Twin {
        final Unit unit;
        final Unit alone;
        final double[] frame = new double[2], carry = new double[2], scale = new double[2];
        double previousX, previousY;

        Twin(Unit unit, Unit alone) {
            this.unit = unit;
            this.alone = alone;
        }

        void settle() {
            previousX = alone.getX();
            previousY = alone.getY();
        }

        /** A frame in which nothing falls due, and after which {@code after} seconds wait: time is rounded as they are. */
        void hold(double elapsed, double after) {
            double[] f = {alone.getFx(), alone.getFy()};
            for (int k = 0; k < 2; k++) {
                carry[k] += f[k] * elapsed;
                scale[k] += Math.abs(f[k]) * after;
            }
            alone.clearForces();
        }

        /** A frame that covers some seconds, of them {@code now} in this frame, and leaves {@code later} seconds of it. */
        void spread(double now, double later, double covered) {
            double[] f = {alone.getFx(), alone.getFy()};
            for (int k = 0; k < 2; k++) {
                frame[k] = (carry[k] + f[k] * now) / covered;
                scale[k] = scale[k] / covered + Math.abs(f[k]);
                carry[k] = f[k] * later;
            }
            alone.clearForces();
        }

        void step(double dt, Integrator how) {
            assertEquals(frame[0], unit.getFx(), 1e-14 * scale[0]);
            assertEquals(frame[1], unit.getFy(), 1e-14 * scale[1]);
            settle();
            alone.applyForce(unit.getFx(), unit.getFy());
            alone.integrate(dt, how);
        }

        void frameDone() {
            for (int k = 0; k < 2; k++) scale[k] = Math.abs(carry[k]);
        }
    }

    private World world;
    private Integrator how;
    private Timestep timestep;
    private final List<Twin> inside = new ArrayList<>();
    private final List<Twin> outside = new ArrayList<>();
    private long tick, remainder;
    private boolean interpolating;

    Twins() {
        move(Integrator.EULER, Timestep.fixed(60));
    }

    /** All units of the world move to a new one. */
    void move(Integrator how, Timestep timestep) {
        this.how = how;
        this.timestep = timestep;
        if (world != null) world.clear();
        world = new World(how, timestep);
        tick = remainder = 0;
        interpolating = false;
        for (Twin twin : inside) world.add(twin.unit);
    }

    /** A unit made twice, one of them added. */
    void addNew(double mass, double friction) {
        Twin twin = new Twin(new Unit(mass).setFriction(friction), new Unit(mass).setFriction(friction));
        outside.add(twin);
        add(outside.size() - 1);
    }

    void add(int pick) {
        if (outside.isEmpty()) return;
        Twin twin = outside.remove(pick % outside.size());
        assertSame(twin.unit, world.add(twin.unit));
        twin.settle();
        inside.add(twin);
    }

    void remove(int pick) {
        if (inside.isEmpty()) return;
        Twin twin = inside.get(pick % inside.size());
        assertTrue(world.remove(twin.unit));
        removed(pick % inside.size());
    }

    private void removed(int i) {
        outside.add(inside.get(i));
        Twin last = inside.remove(inside.size() - 1);
        if (i < inside.size()) inside.set(i, last);
    }

    /** Removes those whose mass is above a limit, through the iterator. */
    void removeHeavierThan(double limit) {
        for (Iterator<Unit> i = world.iterator(); i.hasNext(); ) {
            if (i.next().getMass() > limit) i.remove();
        }
        for (int i = 0; i < inside.size(); ) {
            if (inside.get(i).alone.getMass() > limit) removed(i);
            else i++;
        }
    }

    void clear() {
        world.clear();
        outside.addAll(inside);
        inside.clear();
    }

    /** Does the same to one of the units, in the world or not, and to its twin. */
    void change(int pick, Consumer<Unit> change) {
        Twin twin = pick(pick);
        if (twin == null) return;
        change.accept(twin.unit);
        change.accept(twin.alone);
    }

    void teleport(int pick, double x, double y) {
        change(pick, u -> u.setPosition(x, y));
        if (pick(pick) != null) pick(pick).settle();
    }

    void integrateOne(int pick, double dt, Integrator how) {
        change(pick, u -> u.integrate(dt, how));
        if (pick(pick) != null) pick(pick).settle();
    }

    void clearForces(int pick) {
        change(pick, Unit::clearForces);
        Twin twin = pick(pick);
        if (twin != null) twin.carry[0] = twin.carry[1] = twin.scale[0] = twin.scale[1] = 0;
    }

    private Twin pick(int pick) {
        int n = inside.size() + outside.size();
        if (n == 0) return null;
        int i = pick % n;
        return i < inside.size() ? inside.get(i) : outside.get(i - inside.size());
    }

    void step(double dt) {
        world.step(dt);
        for (Twin twin : inside) twin.alone.integrate(dt, how);
        tick++;
        interpolating = false;
    }

    void advance(long ns) {
        double elapsed = ns / 1e9;
        int steps = timestep.isFixed() ? fixedFrame(ns) : variableFrame(elapsed);
        double[] stepped = {0, 0};
        world.setStepListener((w, dt) -> {
            assertTrue(dt <= timestep.maxStep);
            for (Twin twin : inside) twin.step(dt, how);
            stepped[0]++;
            stepped[1] += dt;
        });
        assertEquals(steps, world.advance(elapsed));
        world.setStepListener(null);
        assertEquals(steps, stepped[0]);
        if (!timestep.isFixed()) {
            double all = Math.min(elapsed, timestep.maxSteps * timestep.maxStep);
            assertEquals(all, stepped[1], 1e-14 * steps * all);
        }
        if (steps > 0) for (Twin twin : inside) twin.frameDone();
        tick += steps;
        interpolating |= timestep.isFixed() && steps > 0;
    }

    private int fixedFrame(long ns) {
        double unit = 1.0 / SECOND / timestep.rate;
        long part = ns * timestep.rate + remainder;
        long due = part / SECOND;
        for (Twin twin : inside) {
            if (due == 0) twin.hold(ns / 1e9, part * unit);
            else {
                double now = (due * SECOND - remainder) * unit;
                twin.spread(now, part % SECOND * unit, (double) due / timestep.rate);
            }
        }
        remainder = part % SECOND;
        return (int) Math.min(due, timestep.maxSteps);
    }

    private int variableFrame(double frame) {
        double elapsed = Math.min(frame, timestep.maxSteps * timestep.maxStep);
        for (Twin twin : inside) {
            if (elapsed == 0) twin.hold(0, 0);
            else twin.spread(elapsed, 0, elapsed);
        }
        return (int) Math.min(Math.ceil(elapsed / timestep.maxStep), timestep.maxSteps);
    }

    /** The world is what the model says: every getter of every unit, to the bit. */
    void compare() {
        assertEquals(tick, world.getTick());
        assertEquals(inside.size(), world.size());
        List<Unit> expected = inside.stream().map(t -> t.unit).collect(Collectors.toList());
        assertEquals(expected, world.units());
        double alpha = Math.min(remainder / 1e9, Math.nextDown(1f));
        float[] xy = new float[2 * world.size()];
        world.copyPositions(xy, 0);
        for (int i = 0; i < inside.size(); i++) {
            Twin twin = inside.get(i);
            assertSame(world, twin.unit.getWorld());
            compare(twin);
            double x = twin.alone.getX(), y = twin.alone.getY();
            double drawnX = interpolating ? twin.previousX + (x - twin.previousX) * alpha : x;
            double drawnY = interpolating ? twin.previousY + (y - twin.previousY) * alpha : y;
            same("interpolated x", drawnX, twin.unit.getInterpolatedX());
            same("interpolated y", drawnY, twin.unit.getInterpolatedY());
            same("copied x", narrow(drawnX), xy[2 * i]);
            same("copied y", narrow(drawnY), xy[2 * i + 1]);
        }
        for (Twin twin : outside) {
            assertSame(null, twin.unit.getWorld());
            compare(twin);
            same("interpolated x", twin.alone.getX(), twin.unit.getInterpolatedX());
            same("interpolated y", twin.alone.getY(), twin.unit.getInterpolatedY());
        }
    }

    private static void compare(Twin twin) {
        Unit a = twin.alone, u = twin.unit;
        same("x", a.getX(), u.getX());
        same("y", a.getY(), u.getY());
        same("vx", a.getVx(), u.getVx());
        same("vy", a.getVy(), u.getVy());
        same("speed", a.getSpeed(), u.getSpeed());
        same("fx", a.getFx(), u.getFx());
        same("fy", a.getFy(), u.getFy());
        same("mass", a.getMass(), u.getMass());
        same("friction", a.getFriction(), u.getFriction());
        same("maxSpeed", a.getMaxSpeed(), u.getMaxSpeed());
    }

    private static double narrow(double v) {
        float f = (float) v;
        return Float.isInfinite(f) ? Math.copySign(Float.MAX_VALUE, v) : f;
    }

    private static void same(String what, double expected, double actual) {
        if (Double.doubleToRawLongBits(expected) != Double.doubleToRawLongBits(actual)) {
            throw new AssertionError(what + ": alone " + expected + ", in the world " + actual);
        }
    }

    @Override
    public String toString() {
        return inside.size() + " units in a world, " + outside.size() + " outside, tick " + tick;
    }
}
