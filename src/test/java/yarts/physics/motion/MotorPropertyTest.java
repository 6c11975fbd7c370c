package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.obermuhlner.math.big.BigDecimalMath;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Copies;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;
import yarts.physics.support.Doubles;

/**
 * The motor: v' moves towards the ordered velocity u by at most gain(z) (dt/m) R. Below, w is the velocity without the
 * motor, and an ulp without a number is that of the largest of |u|, |v| and gain(z) (dt/m) |F|, with which a step
 * computes.
 */
class MotorPropertyTest {
    /**
     * Large enough that the rounding errors of a step, below 4 ulp, do not decide whether the motor exceeds friction
     * and force.
     */
    private static final double MARGIN = 4;

    /** The digits of the closed form, and the number that 1 − e^−z loses for a small z. */
    private static final MathContext DIGITS = new MathContext(80);

    private static final BigDecimal ONE = BigDecimal.ONE;

    private record Vector(double x, double y) {
        static final Vector ZERO = new Vector(0, 0);

        double length() {
            return Math.hypot(x, y);
        }

        Vector times(double k) {
            return new Vector(k * x, k * y);
        }

        Vector minus(Vector other) {
            return new Vector(x - other.x, y - other.y);
        }
    }

    private static Vector velocity(Unit unit) {
        return new Vector(unit.getVx(), unit.getVy());
    }

    private static Vector ordered(Unit unit) {
        return new Vector(unit.getMotorVx(), unit.getMotorVy());
    }

    private static void step(Unit unit, Vector force, double dt, Integrator integrator) {
        unit.applyForce(force.x, force.y);
        unit.integrate(dt, integrator);
    }

    /** gain(z) dt/m of the documentation: the change of velocity in a step per newton. */
    private static double gain(Unit unit, double dt, Integrator integrator) {
        double h = dt / unit.getMass(), z = unit.getFriction() * h;
        return switch (integrator) {
            case EULER -> h / Math.max(1, z);
            case SEMI_IMPLICIT -> h / (1 + z);
            case MIDPOINT -> h / Math.max(1 + z / 2, z);
            case EXACT -> z < 1e-9 ? h : -Math.expm1(-z) / z * h;
        };
    }

    @Provide
    Arbitrary<Double> masses() {
        return mostly(Doubles.logUniform(1e-3, 1e6), Doubles.logUniform(1e-50, 1e50));
    }

    @Provide
    Arbitrary<Double> times() {
        return mostly(Doubles.logUniform(1e-3, 1), mostly(Doubles.logUniform(0, 1e9), Arbitraries.of(0.0, 1e9)));
    }

    @Provide
    Arbitrary<Double> frictions() {
        return mostly(
                mostly(Doubles.logUniform(1e-3, 1e6), Arbitraries.just(0.0)),
                mostly(Doubles.logUniform(0, 1e50), Arbitraries.of(Double.MIN_VALUE, 1e50)));
    }

    /** z = f dt/m, which may be so large that the decay is 0. */
    @Provide
    Arbitrary<Double> stiffness() {
        return mostly(
                mostly(Doubles.logUniform(1e-3, 10), Arbitraries.just(0.0)),
                mostly(Doubles.logUniform(1e-12, 1e6), Arbitraries.of(1.0, 2.0, 0.5, 700.0)));
    }

    @Provide
    Arbitrary<Double> motorForces() {
        return mostly(
                Doubles.logUniform(1e-3, 1e6),
                mostly(Doubles.logUniform(0, 1e50), Arbitraries.of(0.0, Double.MIN_VALUE, 1e50)));
    }

    @Provide
    Arbitrary<Vector> forces() {
        Arbitrary<Double> any = Doubles.signedLogUniform(Double.MIN_VALUE, 1e50);
        return mostly(vectors(mostly(Doubles.signedLogUniform(1e-3, 1e6), any)), Arbitraries.just(Vector.ZERO));
    }

    /** Up to half of the greatest possible speed, so that its cap does not bind. */
    @Provide
    Arbitrary<Vector> velocities() {
        Arbitrary<Double> slow = Doubles.signedLogUniform(0x1p-510, 0x1p-490);
        Arbitrary<Double> any = Doubles.signedLogUniform(Double.MIN_VALUE, 0x1p498);
        return vectors(mostly(Doubles.signedLogUniform(1e-6, 1e6), mostly(any, slow)));
    }

    @Provide
    Arbitrary<Vector> usualVelocities() {
        return vectors(Doubles.signedLogUniform(1e-6, 1e6));
    }

    @Provide
    Arbitrary<Vector> finite() {
        return vectors(Doubles.finite());
    }

    /** Ratios between the components of two vectors: equal, a few ulp apart, or farther. */
    @Provide
    Arbitrary<Vector> ratios() {
        Arbitrary<Double> few = Arbitraries.integers().between(-4, 4).map(k -> 1 + k * Math.ulp(1.0));
        return vectors(Arbitraries.oneOf(few, Arbitraries.of(0.0, 1.0, -1.0), Doubles.logUniform(1e-3, 1e3)));
    }

    @Provide
    Arbitrary<Double> topSpeeds() {
        return mostly(Doubles.logUniform(1e-3, 1e3), Doubles.logUniform(0, Double.POSITIVE_INFINITY));
    }

    private static Arbitrary<Vector> vectors(Arbitrary<Double> components) {
        return Combinators.combine(components, components).as(Vector::new);
    }

    private static <T> Arbitrary<T> mostly(Arbitrary<T> usual, Arbitrary<T> unusual) {
        return Arbitraries.frequencyOf(Tuple.of(3, usual), Tuple.of(1, unusual));
    }

    private static Unit unit(double mass, double friction, Vector v) {
        return new Unit(mass).setFriction(friction).setVelocity(v.x, v.y);
    }

    // 1. Between the ordered velocity and the one without the motor

    @Property(tries = 5000)
    void eachComponentLiesBetweenThatOfTheOrderedVelocityAndTheOneWithoutTheMotor(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("velocities") Vector v,
            @ForAll("forces") Vector force,
            @ForAll("velocities") Vector u,
            @ForAll("motorForces") double most) {
        assertBetween(unit(mass, friction, v), force, u, most, dt, integrator);
    }

    /** Ordered velocities near the current one, and motors that only just reach them or only just fail to. */
    @Property(tries = 5000)
    void eachComponentLiesBetweenThemEvenIfTheMotorOnlyJustReaches(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("velocities") Vector v,
            @ForAll("forces") Vector force,
            @ForAll("ratios") Vector ratio,
            @ForAll("ratios") Vector share) {
        Unit unit = unit(mass, friction, v), free = Copies.of(unit);
        step(free, force, dt, integrator);
        Vector u = new Vector(v.x * ratio.x, v.y * ratio.y);
        double most = u.minus(velocity(free)).length() / gain(unit, dt, integrator) * Math.abs(share.x);
        if (most <= 1e50) assertBetween(unit, force, u, most, dt, integrator);
    }

    private static void assertBetween(
            Unit unit, Vector force, Vector u, double most, double dt, Integrator integrator) {
        Unit free = Copies.of(unit);
        step(free, force, dt, integrator);
        unit.setMotor(u.x, u.y, most);
        step(unit, force, dt, integrator);
        assertBetween(free.getVx(), unit.getMotorVx(), unit.getVx());
        assertBetween(free.getVy(), unit.getMotorVy(), unit.getVy());
        if (most == 0 || dt == 0) assertSame(free, unit);
    }

    /** To within 1 ulp of the larger, exactly if u is 0; below the rest threshold, both velocities are reduced. */
    private static void assertBetween(double w, double u, double v) {
        double ulp = u == 0 ? 0 : Math.ulp(Math.max(Math.abs(u), Math.abs(w)));
        double allowed = Math.abs(v) < Range.REST ? Range.REST : ulp;
        assertTrue(
                v >= Math.min(u, w) - allowed && v <= Math.max(u, w) + allowed,
                () -> v + " is not between " + u + " and " + w);
    }

    private static void assertSame(Unit expected, Unit actual) {
        same(expected.getVx(), actual.getVx());
        same(expected.getVy(), actual.getVy());
        same(expected.getX(), actual.getX());
        same(expected.getY(), actual.getY());
    }

    private static void same(double expected, double actual) {
        assertEquals(
                Double.doubleToRawLongBits(expected),
                Double.doubleToRawLongBits(actual),
                () -> expected + " and " + actual);
    }

    @Property(tries = 2000)
    void aMotorWithoutForceGivesTheBitsOfNoMotor(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("finite") Vector v,
            @ForAll("forces") Vector force,
            @ForAll("finite") Vector u,
            @ForAll("topSpeeds") double top) {
        Unit free = unit(mass, friction, v).setMaxSpeed(top),
                unit = Copies.of(free).setMotor(u.x, u.y, 0);
        for (int i = 0; i < 5; i++) {
            step(free, force, dt, integrator);
            step(unit, force, dt, integrator);
            assertSame(free, unit);
        }
    }

    /** If R ≥ f|u| + |F|. If both are equal and opposed, the velocity should stay, but rounding may change it. */
    @Property(tries = 3000)
    void theDistanceFromTheOrderedVelocityNeverGrowsByMoreThanRounding(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("stiffness") double z,
            @ForAll("times") double dt,
            @ForAll("usualVelocities") Vector v,
            @ForAll("usualVelocities") Vector u,
            @ForAll("pushes") Vector push,
            @ForAll("surpluses") double surplus) {
        if (dt < 1e-50 || z * mass / dt > 1e50) return;
        Unit unit = unit(mass, z * mass / dt, v);
        Vector force = push.times(Math.max(u.length(), v.length()) * mass / dt);
        double least = 1e-15 * Math.max(u.length(), v.length()) * mass / dt;
        double most = Math.max(least, (unit.getFriction() * u.length() + force.length()) * surplus);
        if (!(most <= 1e50)) return;
        unit.setMotor(u.x, u.y, most);
        for (int i = 0; i < 100; i++) {
            double before = u.minus(velocity(unit)).length(), ulp = ulp(unit, force, dt, integrator);
            step(unit, force, dt, integrator);
            double after = u.minus(velocity(unit)).length();
            assertTrue(
                    after <= before + MARGIN * ulp,
                    () -> after + " from " + u + ", before " + before + ": " + (after - before) / ulp + " ulp");
        }
    }

    /** Forces for this test, relative to the greatest velocity. */
    @Provide
    Arbitrary<Vector> pushes() {
        return mostly(Arbitraries.just(Vector.ZERO), vectors(Doubles.signedLogUniform(1e-15, 1e3)));
    }

    @Provide
    Arbitrary<Double> surpluses() {
        return mostly(Arbitraries.of(1.0, Math.nextUp(1.0), 1 + 1e-15, 1 + 1e-12), Doubles.logUniform(1, 100));
    }

    private static double ulp(Unit unit, Vector force, double dt, Integrator integrator) {
        double pushed = gain(unit, dt, integrator) * force.length();
        return Math.ulp(Math.max(Math.max(ordered(unit).length(), velocity(unit).length()), pushed));
    }

    // 2. Arrival

    /**
     * This holds if gain(z) (dt/m) (R − f|u| − |F|) is at least 4 ulp, and |u| is below the cap. The unit then arrives
     * within twice the number of steps that it would need without rounding.
     */
    @Property(tries = 3000)
    void aUnitApproachesTheOrderedVelocityInEveryStepReachesItExactlyAndKeepsIt(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("stiffness") double z,
            @ForAll("times") double dt,
            @ForAll("usualVelocities") Vector v,
            @ForAll("usualVelocities") Vector u,
            @ForAll("pushes") Vector push,
            @ForAll("margins") Vector margins) {
        if (dt < 1e-50 || z * mass / dt > 1e50) return;
        double top = margins.x < 100 ? Double.POSITIVE_INFINITY : u.length() / (1 - 0x1p-48) * (margins.x / 100);
        Unit unit = unit(mass, z * mass / dt, v).setMaxSpeed(top).setMotor(u.x, u.y, 0);
        Vector force = push.times(Math.max(u.length(), v.length()) * mass / dt);
        double ulp = ulp(unit, force, dt, integrator), gain = gain(unit, dt, integrator);
        double needed = unit.getFriction() * u.length() + force.length();
        double most = needed + MARGIN * ulp / gain * margins.y, margin = (most - needed) * gain;
        if (!(margin >= MARGIN * ulp && most <= 1e50)) return;
        unit.setMotor(u.x, u.y, most);
        double distance = u.minus(velocity(unit)).length();
        double steps = 2 * distance / margin + 2;
        for (int i = 0; i < 300; i++) {
            step(unit, force, dt, integrator);
            double before = distance, after = u.minus(velocity(unit)).length();
            assertTrue(after <= before * (1 + Math.ulp(2.0)), () -> after + " from " + u + ", before " + before);
            distance = after;
            if (i + 1 >= steps) assertEquals(ordered(unit), velocity(unit), () -> "after " + steps + " steps");
        }
    }

    /** From only just enough to far more. */
    @Provide
    Arbitrary<Vector> margins() {
        return vectors(mostly(Doubles.logUniform(1.001, 1e16), Doubles.logUniform(1.001, 2)));
    }

    /** A motor too weak for this friction and u: R < f|u|. Its direction is that of u, whatever the velocity was. */
    @Property(tries = 1000)
    void aMotorThatIsTooWeakApproachesItsForceOverTheFriction(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("weakStiffness") double z,
            @ForAll("times") double dt,
            @ForAll("usualVelocities") Vector v,
            @ForAll("directions") double angle,
            @ForAll("speeds") double terminal,
            @ForAll("excesses") double excess) {
        double friction = z * mass / dt, most = terminal * friction;
        if (!(dt >= 1e-50 && friction <= 1e50 && most <= 1e50)) return;
        Vector direction = new Vector(Math.cos(angle), Math.sin(angle)), u = direction.times(terminal * excess);
        Unit unit = unit(mass, friction, v).setMotor(u.x, u.y, most);
        double start = v.length() / terminal, steps = (45 + Math.log(1 + start)) * (1 + 1 / z);
        for (int i = 0; i < steps; i++) unit.integrate(dt, integrator);
        double allowed = 4e-16 * (2 + 2 / z) * terminal;
        assertEquals(direction.x * terminal, unit.getVx(), allowed);
        assertEquals(direction.y * terminal, unit.getVy(), allowed);
    }

    @Provide
    Arbitrary<Double> weakStiffness() {
        return mostly(Doubles.logUniform(0.05, 10), Doubles.logUniform(10, 1e6));
    }

    @Provide
    Arbitrary<Double> directions() {
        return mostly(
                Doubles.logUniform(1e-9, 6.3),
                Arbitraries.integers().between(0, 7).map(k -> k * Math.PI / 4));
    }

    @Provide
    Arbitrary<Double> speeds() {
        return Doubles.logUniform(1e-6, 1e6);
    }

    /** The ordered speed, as a multiple of the speed that the motor can reach. */
    @Provide
    Arbitrary<Double> excesses() {
        return mostly(Doubles.logUniform(1.001, 100), Doubles.logUniform(1.001, 1e140));
    }

    // 3. Dry friction

    @Property(tries = 3000)
    void aForceBelowThatOfTheBrakeDoesNotMoveAUnit(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("directions") double angle,
            @ForAll("motorForces") double most,
            @ForAll("shares") double share) {
        Unit unit = new Unit(mass).setFriction(friction).setPosition(3, -4).setMotor(0, 0, most);
        Vector force = new Vector(Math.cos(angle), Math.sin(angle)).times(most * (1 - 1e-12) * share);
        for (int i = 0; i < 20; i++) {
            step(unit, force, dt, integrator);
            assertEquals(3, unit.getX());
            assertEquals(-4, unit.getY());
            if (gain(unit, dt, integrator) * most >= Range.REST) assertEquals(Vector.ZERO, velocity(unit));
        }
    }

    @Provide
    Arbitrary<Double> shares() {
        return mostly(Arbitraries.just(1.0), Doubles.logUniform(1e-3, 1));
    }

    @Property(tries = 2000)
    void aForceAboveThatOfTheBrakeAcceleratesByTheDifference(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("usualTimes") double dt,
            @ForAll("directions") double angle,
            @ForAll("usualForces") double most) {
        Unit unit = new Unit(mass).setMotor(0, 0, most);
        Vector direction = new Vector(Math.cos(angle), Math.sin(angle)), force = direction.times(1.001 * most);
        double gained = 0.001 * most / mass * dt;
        for (int i = 1; i <= 20; i++) {
            step(unit, force, dt, integrator);
            assertEquals(direction.x * gained * i, unit.getVx(), 1e-12 * gained * i);
            assertEquals(direction.y * gained * i, unit.getVy(), 1e-12 * gained * i);
        }
    }

    @Provide
    Arbitrary<Double> usualTimes() {
        return mostly(Doubles.logUniform(1e-3, 1), Doubles.logUniform(1e-9, 1e9));
    }

    @Provide
    Arbitrary<Double> usualForces() {
        return mostly(Doubles.logUniform(1e-3, 1e6), Doubles.logUniform(1e-20, 9e49));
    }

    // 4. The motor's force

    @Property(tries = 3000)
    void withoutFrictionTheMotorPushesTowardsTheOrderedVelocityWithItsFullForceUntilItArrives(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("usualTimes") double dt,
            @ForAll("usualVelocities") Vector v,
            @ForAll("usualVelocities") Vector u,
            @ForAll("pushes") Vector push,
            @ForAll("reaches") double reach) {
        double scale = Math.max(u.length(), v.length());
        Vector force = push.times(scale * mass / dt);
        double most = reach * scale * mass / dt;
        if (!(scale > 0 && most <= 1e50 && force.length() <= 1e50)) return;
        Unit unit = unit(mass, 0, v), free = Copies.of(unit);
        step(free, force, dt, integrator);
        unit.setMotor(u.x, u.y, most);
        step(unit, force, dt, integrator);
        BigDecimal perSecond = big(mass).divide(big(dt), DIGITS);
        BigDecimal x = motorForce(perSecond, v.x, unit.getVx(), force.x);
        BigDecimal y = motorForce(perSecond, v.y, unit.getVy(), force.y);
        double ulp = Math.ulp(Math.max(scale, force.length() / mass * dt));
        double allowed = 1e-12 * most + 4 * ulp * mass / dt;
        double size = Math.hypot(x.doubleValue(), y.doubleValue());
        assertTrue(size <= most + allowed, () -> size + " N of " + most);
        if (!velocity(unit).equals(ordered(unit))) assertEquals(most, size, allowed);
        Vector way = u.minus(velocity(free));
        double along = x.doubleValue() * way.x + y.doubleValue() * way.y;
        double across = x.doubleValue() * way.y - y.doubleValue() * way.x;
        assertTrue(along >= -allowed * way.length(), () -> "the motor pushes away from " + u);
        assertEquals(0, across, 2 * allowed * way.length() + 4 * ulp * size);
    }

    private static BigDecimal motorForce(BigDecimal perSecond, double before, double after, double force) {
        return big(after).subtract(big(before)).multiply(perSecond).subtract(big(force));
    }

    /** The reach of the motor in a step, as a fraction of u or v. */
    @Provide
    Arbitrary<Double> reaches() {
        return mostly(Doubles.logUniform(1e-4, 4), Doubles.logUniform(1e-15, 1e15));
    }

    @Property(tries = 2000)
    void aBrakeLetsNoComponentGrow(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("velocities") Vector v,
            @ForAll("motorForces") double most) {
        Unit unit = unit(mass, friction, v).setMotor(0, 0, most);
        for (int i = 0; i < 20; i++) {
            Vector before = velocity(unit);
            unit.integrate(dt, integrator);
            assertTrue(Math.abs(unit.getVx()) <= Math.abs(before.x) && unit.getVx() * before.x >= 0);
            assertTrue(Math.abs(unit.getVy()) <= Math.abs(before.y) && unit.getVy() * before.y >= 0);
        }
    }

    // 5. EXACT against the closed form

    /**
     * A unit on a line under a force F and a motor that reaches u at the time T, or never: m dv/dt = F ± R − f v until
     * then, v = u afterwards.
     */
    private static final class Line {
        /** The acceleration at the start; f/m; and the velocity that the unit approaches if there is friction. */
        private final BigDecimal v, u, acceleration, perSecond, terminal;

        /** T, in s. */
        final BigDecimal arrival;

        Line(double v, double u, double force, double most, double friction, double mass) {
            this.v = big(v);
            this.u = big(u);
            BigDecimal all = big(force).add(big(u > v ? most : -most));
            acceleration = all.divide(big(mass), DIGITS);
            perSecond = big(friction).divide(big(mass), DIGITS);
            terminal = friction == 0 ? null : all.divide(big(friction), DIGITS);
            arrival = terminal == null
                    ? this.u.subtract(this.v).divide(acceleration, DIGITS)
                    : BigDecimalMath.log(left(this.v).divide(left(this.u), DIGITS), DIGITS)
                            .divide(perSecond, DIGITS);
        }

        private BigDecimal left(BigDecimal v) {
            return terminal.subtract(v);
        }

        /** {@return the velocity and the position after t seconds} */
        BigDecimal[] at(BigDecimal t) {
            if (t.compareTo(arrival) > 0) {
                BigDecimal rest = t.subtract(arrival).multiply(u);
                return new BigDecimal[] {u, at(arrival)[1].add(rest)};
            }
            if (terminal == null) {
                BigDecimal gained = acceleration.multiply(t);
                BigDecimal average = v.add(gained.divide(big(2), DIGITS));
                return new BigDecimal[] {v.add(gained), average.multiply(t)};
            }
            BigDecimal decay = BigDecimalMath.exp(perSecond.multiply(t).negate(), DIGITS);
            BigDecimal lost = left(v).multiply(ONE.subtract(decay)).divide(perSecond, DIGITS);
            return new BigDecimal[] {
                terminal.subtract(left(v).multiply(decay)), terminal.multiply(t).subtract(lost)
            };
        }
    }

    private static BigDecimal big(double v) {
        return new BigDecimal(v);
    }

    @Property(tries = 500)
    void exactOnALineFollowsTheClosedFormAtEveryTickRate(
            @ForAll("tickRates") double ticksPerSecond,
            @ForAll("masses") double mass,
            @ForAll("lineStiffness") double z,
            @ForAll("directions") double angle,
            @ForAll("usualVelocities") Vector vu,
            @ForAll("linePushes") double push,
            @ForAll("surpluses") double surplus,
            @ForAll("steps") double steps) {
        double dt = 1 / ticksPerSecond, v = vu.x, u = vu.y, fastest = Math.max(Math.abs(u), Math.abs(v));
        double friction = z * mass / dt, force = push * fastest * mass / dt;
        double most = Math.abs(force - friction * u) * surplus + Math.abs(u - v) * mass / (steps * dt);
        if (u == v || !(friction <= 1e50 && most <= 1e50 && Math.abs(force) <= 1e50)) return;
        Vector direction = new Vector(Math.cos(angle), Math.sin(angle));
        Unit unit = unit(mass, friction, direction.times(v)).setMotor(direction.x * u, direction.y * u, most);
        Line line = new Line(v, u, force, most, friction, mass);
        assertFollows(line, unit, Vector.ZERO, direction, force, dt, fastest + Math.abs(force) * dt / mass);
    }

    /** Without other forces, the direction of u − v does not change. */
    @Property(tries = 200)
    void exactWithoutFrictionAndForceFollowsTheClosedFormInThePlane(
            @ForAll("tickRates") double ticksPerSecond,
            @ForAll("masses") double mass,
            @ForAll("usualVelocities") Vector v,
            @ForAll("usualVelocities") Vector u,
            @ForAll("steps") double steps) {
        Vector way = u.minus(v);
        double dt = 1 / ticksPerSecond, length = way.length(), most = length * mass / (steps * dt);
        if (length == 0 || !(most <= 1e50)) return;
        Unit unit = unit(mass, 0, v).setMotor(u.x, u.y, most);
        Line line = new Line(0, length, 0, most, 0, mass);
        assertFollows(line, unit, v, way.times(1 / length), 0, dt, u.length() + v.length());
    }

    /**
     * Until u is reached, to 1e-12 of the greatest speed. In the step that reaches u, the motor acts with a smaller
     * force for the whole step, so the unit ends up to R dt²/(4 m) away from the closed form.
     */
    private static void assertFollows(
            Line line, Unit unit, Vector start, Vector direction, double force, double dt, double fastest) {
        double most = unit.getMotorForce(), off = most / unit.getMass() * dt * dt / 4;
        Vector each = direction.times(force);
        double arrival = line.arrival.doubleValue() / dt;
        int last = (int) Math.min(arrival + 5, 400), every = 1 + last / 8;
        for (int i = 1; i <= last; i++) {
            step(unit, each, dt, Integrator.EXACT);
            boolean arrived = i > arrival, near = Math.abs(i - arrival) < 3;
            if (i >= arrival + 1) assertEquals(ordered(unit), velocity(unit));
            if (i % every > 0 && !near) continue;
            BigDecimal t = big(i).multiply(big(dt));
            BigDecimal[] there = line.at(t);
            double scale = 1e-12 * fastest, allowed = scale * i * dt + (arrived ? off : 0);
            assertEquals(0, error(start.x, direction.x, there[0], unit.getVx()), scale);
            assertEquals(0, error(start.y, direction.y, there[0], unit.getVy()), scale);
            double x = error(start.x * i * dt, direction.x, there[1], unit.getX());
            double y = error(start.y * i * dt, direction.y, there[1], unit.getY());
            assertEquals(
                    0,
                    Math.hypot(x, y),
                    allowed,
                    () -> "after " + arrival + " steps, of R dt²/(4 m): " + Math.hypot(x, y) / off);
        }
    }

    private static double error(double start, double direction, BigDecimal along, double actual) {
        return big(actual)
                .subtract(big(start))
                .subtract(big(direction).multiply(along))
                .doubleValue();
    }

    @Provide
    Arbitrary<Double> tickRates() {
        return mostly(Doubles.logUniform(10, 1000), Doubles.logUniform(1e-3, 1e6));
    }

    @Provide
    Arbitrary<Double> lineStiffness() {
        return mostly(mostly(Doubles.logUniform(1e-6, 1), Arbitraries.just(0.0)), Doubles.logUniform(1, 1e4));
    }

    @Provide
    Arbitrary<Double> linePushes() {
        return mostly(Arbitraries.just(0.0), Doubles.signedLogUniform(1e-6, 100));
    }

    /** The number of steps in which the motor alone would reach the ordered velocity. */
    @Provide
    Arbitrary<Double> steps() {
        return Doubles.logUniform(0.01, 300);
    }

    // 6. Frame rates

    /** Units, motors and forces of a game from a seed. The orders are the same in every frame. */
    private static World game(Integrator integrator, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        World world = new World(integrator, Timestep.fixed(60));
        for (int i = 0; i < 12; i++) {
            Unit unit = world.add(new Unit(random.nextDouble(0.1, 50)).setVelocity(random.nextDouble(-9, 9), 1));
            if (i % 3 > 0) unit.setFriction(random.nextDouble(0, 20));
            if (i % 4 == 0) unit.setMaxSpeed(random.nextDouble(1, 9));
            unit.setFrozen(i == 11);
        }
        return world;
    }

    private static void order(World world, long seed) {
        SplittableRandom random = new SplittableRandom(seed + 1);
        for (Unit unit : world) {
            boolean brake = random.nextInt(3) == 0;
            double vx = random.nextDouble(-9, 9), vy = random.nextDouble(-9, 9), most = random.nextDouble(0, 200);
            unit.setMotor(brake ? 0 : vx, brake ? 0 : vy, most);
        }
    }

    /** Plays 1.5 s at a frame rate, with the motors set again in each frame; returns the bits after each tick. */
    private static Map<Long, List<List<Long>>> ticks(Integrator integrator, long seed, double framesPerSecond) {
        World world = game(integrator, seed);
        Map<Long, List<List<Long>>> ticks = new HashMap<>();
        world.addAfterStep((w, dt) -> ticks.put(w.getTick(), bits(w)));
        for (int i = 0; i < 1.5 * framesPerSecond; i++) {
            order(world, seed);
            world.advance(1 / framesPerSecond);
        }
        return ticks;
    }

    private static List<List<Long>> bits(World world) {
        List<List<Long>> bits = new ArrayList<>();
        for (Unit unit : world) bits.add(Churn.kept(unit));
        return bits;
    }

    @Property(tries = 100)
    void theSameMotorSetInEveryFrameGivesTheSameBitsAtEveryFrameRate(
            @ForAll Integrator integrator, @ForAll long seed, @ForAll("frameRates") double framesPerSecond) {
        Map<Long, List<List<Long>>> ticks = ticks(integrator, seed, framesPerSecond);
        World once = game(integrator, seed);
        order(once, seed);
        for (long tick = 1; tick <= 85; tick++) {
            once.step();
            assertEquals(bits(once), ticks.get(tick), "tick " + tick);
        }
    }

    @Provide
    Arbitrary<Double> frameRates() {
        return mostly(Doubles.logUniform(7, 1000), Arbitraries.of(7.0, 15.0, 30.0, 59.0, 60.0, 144.0, 240.0, 1000.0));
    }

    // 7. Nothing leads to NaN or infinity; the cap acts after the motor

    /**
     * Extreme units in a world and the same units alone: all numbers are finite, no cap is exceeded, the bits are the
     * same.
     */
    @Property(tries = 300)
    void extremeMotorsGiveFiniteNumbersWithinTheCapAndInAWorldTheSameBitsAsAlone(
            @ForAll Integrator integrator, @ForAll long seed, @ForAll @IntRange(min = 1, max = 70) int size) {
        SplittableRandom random = new SplittableRandom(seed);
        World world = new World(integrator, Timestep.variable(1));
        List<Unit> alone = new ArrayList<>();
        for (int i = 0; i < (size == 70 ? Tiles.TILE + 3 : size); i++) {
            Unit unit = world.add(new Unit(number(random, 1e-50, 1e50)).setFriction(number(random, 0, 1e50)));
            unit.setMaxSpeed(number(random, 0, Double.POSITIVE_INFINITY)).setPosition(any(random), any(random));
            unit.setVelocity(any(random), any(random)).setFrozen(random.nextInt(9) == 0);
            unit.setMotor(any(random), any(random), number(random, 0, 1e50));
            alone.add(Copies.of(unit));
        }
        for (int i = 0; i < 12; i++) {
            double dt = number(random, 0, 1e9);
            for (int k = 0; k < alone.size(); k++) {
                Unit[] both = {world.get(k), alone.get(k)};
                double fx = Math.copySign(number(random, 0, 1e50), random.nextDouble(-1, 1));
                double ux = any(random), uy = any(random), most = number(random, 0, 1e50);
                int order = random.nextInt(12);
                for (Unit unit : both) {
                    if (order < 3) unit.applyForce(fx, -fx);
                    if (order == 3) unit.setMotor(ux, uy, most);
                    if (order == 4) unit.setMotor(0, 0, most);
                    if (order == 5) unit.setFrozen(!unit.isFrozen());
                    if (order == 6) unit.setMotor(0, 0, 0);
                }
            }
            world.step(dt);
            for (int k = 0; k < alone.size(); k++) {
                Unit unit = alone.get(k);
                unit.integrate(dt, integrator);
                assertSame(unit, world.get(k));
                for (double value :
                        new double[] {unit.getX(), unit.getY(), unit.getVx(), unit.getVy(), unit.getSpeed()})
                    assertTrue(Double.isFinite(value), unit::toString);
                assertTrue(unit.getSpeed() <= unit.getMaxSpeed(), unit::toString);
                Vector v = velocity(unit);
                assertTrue(v.length() <= unit.getMaxSpeed() * (1 + 0x1p-50) && v.length() <= 0x1p500 * (1 + 0x1p-50));
                assertTrue(unit.getVx() == 0 || Math.abs(unit.getVx()) >= Double.MIN_NORMAL, unit::toString);
                assertTrue(unit.getVy() == 0 || Math.abs(unit.getVy()) >= Double.MIN_NORMAL, unit::toString);
            }
        }
    }

    /** From least to most, uniform in the logarithm; often exactly one of the two. */
    private static double number(SplittableRandom random, double least, double most) {
        int k = random.nextInt(16);
        if (k == 0) return least;
        if (k == 1) return most;
        double from = k < 8 ? Math.max(least, 1e-3) : least, to = k < 8 ? Math.min(most, 1e3) : most;
        long a = Double.doubleToRawLongBits(from), b = Double.doubleToRawLongBits(to);
        return Double.longBitsToDouble(random.nextLong(a, b + 1));
    }

    private static double any(SplittableRandom random) {
        double v = random.nextInt(20) == 0 ? 0x1p-500 : number(random, 0, Double.MAX_VALUE);
        return random.nextBoolean() ? v : -v;
    }
}
