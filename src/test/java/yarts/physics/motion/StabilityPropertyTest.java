package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.support.Doubles;

/** The effect of friction with every accepted mass, friction, force, velocity and dt. */
class StabilityPropertyTest {
    @Provide
    Arbitrary<Double> masses() {
        return Doubles.logUniform(1e-50, 1e50);
    }

    @Provide
    Arbitrary<Double> frictions() {
        return Arbitraries.oneOf(Doubles.logUniform(0, 1e50), Doubles.logUniform(1e-6, 1e6), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> times() {
        return Arbitraries.oneOf(Doubles.logUniform(0, 1e9), Doubles.logUniform(1e-6, 1e3), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> velocities() {
        return Arbitraries.oneOf(Doubles.signedLogUniform(0, Double.MAX_VALUE), Doubles.signedLogUniform(1e-6, 1e6));
    }

    @Provide
    Arbitrary<Double> forces() {
        return Arbitraries.oneOf(
                Doubles.signedLogUniform(0, 1e50), Doubles.signedLogUniform(1e-6, 1e6), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> stiffness() {
        return Doubles.logUniform(1e-6, 1e6);
    }

    @Property(tries = 3000)
    void velocityMovesTowardsTheTerminalSpeedAndNeverPastIt(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("velocities") double v,
            @ForAll("forces") double force) {
        Unit unit = new Unit(mass).setFriction(friction).setVelocity(0, v);
        double terminal = terminal(force, friction);
        double direction = 0;
        for (int i = 0; i < 100; i++) {
            double before = unit.getVy();
            unit.applyForce(0, force);
            unit.integrate(dt, integrator);
            double after = unit.getVy();
            double slack = force == 0 ? 0 : 4 * Math.ulp(Math.max(Math.abs(before), Math.abs(terminal)));
            double low = Math.min(before, terminal);
            double high = Math.max(before, terminal);
            if (force != 0) { // a speed below REST may become 0 under any force
                low = Math.min(low, 0.0 < low && low < Range.REST ? 0 : low);
                high = Math.max(high, -Range.REST < high && high < 0.0 ? 0 : high);
            }
            assertTrue(
                    after >= low - slack && after <= high + slack,
                    () -> "from " + before + " to " + after + " with F/f = " + terminal);
            if (Math.abs(before) >= Range.REST && Math.abs(after) >= Range.REST) {
                assertTrue((after - before) * direction >= 0, "direction changed: from " + before + " to " + after);
                direction = Math.signum(after - before);
            }
            assertEquals(0, unit.getVx());
        }
    }

    @Property
    void withoutAForceFrictionNeverChangesTheSignOfAComponent(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("velocities") double vx,
            @ForAll("velocities") double vy) {
        Unit unit = new Unit(mass).setFriction(friction).setVelocity(vx, vy);
        for (int i = 0; i < 20; i++) {
            double x = unit.getVx();
            double y = unit.getVy();
            unit.integrate(dt, integrator);
            assertTrue(unit.getVx() * x >= 0 && Math.abs(unit.getVx()) <= Math.abs(x), x + " to " + unit.getVx());
            assertTrue(unit.getVy() * y >= 0 && Math.abs(unit.getVy()) <= Math.abs(y), y + " to " + unit.getVy());
        }
    }

    @Property
    void aUnitAtRestWithoutAForceDoesNotMove(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("velocities") double x,
            @ForAll("velocities") double y) {
        Unit unit = new Unit(mass).setFriction(friction).setPosition(x, y);
        for (int i = 0; i < 100; i++) unit.integrate(dt, integrator);
        assertEquals(x + 0.0, unit.getX());
        assertEquals(y + 0.0, unit.getY());
        assertEquals(0.0, unit.getVx());
        assertEquals(0.0, unit.getVy());
    }

    @Property
    void noAcceptedValueLeadsToNaNOrInfinity(
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll("frictions") double friction,
            @ForAll("times") double dt,
            @ForAll("velocities") double v,
            @ForAll("forces") double force,
            @ForAll("velocities") double x) {
        Unit unit = new Unit(mass).setFriction(friction).setVelocity(v, -v).setPosition(x, -x);
        for (int i = 0; i < 100; i++) {
            unit.applyForce(force, v > 0 ? force : -1e50);
            unit.applyImpulse(-force, force);
            unit.integrate(dt, integrator);
            assertTrue(Double.isFinite(unit.getX()) && Double.isFinite(unit.getY()), unit.toString());
            assertTrue(unit.getSpeed() <= Range.FASTEST, unit.toString());
        }
    }

    /**
     * To 1e-12, or to the precision of a double: near F/f a step changes v by z(F/f − v), which has no effect if it is
     * less than half an ulp of v.
     */
    @Property(tries = 100)
    void terminalSpeedIsForceOverFrictionAtEveryStiffness(
            @ForAll Integrator integrator,
            @ForAll("stiffness") double z,
            @ForAll("stiffness") double mass,
            @ForAll("stiffness") double force) {
        double dt = 1 / 64.0;
        double friction = z * mass / dt;
        double terminal = force / friction;
        double tolerance = Math.max(1e-12, 0x1p-51 / z);
        Unit unit = new Unit(mass).setFriction(friction);
        // From rest if that takes less than 100,000 steps, otherwise from a velocity near F/f.
        if (z < 3e-4) unit.setVelocity(terminal * (1 + tolerance * 10), 0);
        double steps = Math.min(30 / z, 1e5) + 1;
        if (integrator == Integrator.SEMI_IMPLICIT) steps = Math.max(steps, 30 / Math.log(1 + z) + 1); // its decay
        for (int i = 0; i < steps; i++) {
            unit.applyForce(force, 0);
            unit.integrate(dt, integrator);
        }
        double late = z < 3e-4 ? 10 * StrictMath.exp(-z * (long) steps) : 0;
        assertEquals(1, unit.getVx() / terminal, tolerance * (1 + late));
    }

    /** F/f, limited to the speeds that a unit can reach. */
    private static double terminal(double force, double friction) {
        if (force == 0) return 0;
        double terminal = force / friction;
        return Math.max(-Range.FASTEST, Math.min(Range.FASTEST, terminal));
    }
}
