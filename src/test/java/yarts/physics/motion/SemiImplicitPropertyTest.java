package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.support.Doubles;

/** Springs and orbits under SEMI_IMPLICIT, without friction, with the force at the start of each step. */
class SemiImplicitPropertyTest {
    private static void step(Unit unit, double fx, double fy, double dt) {
        unit.applyForce(fx, fy);
        unit.integrate(dt, Integrator.SEMI_IMPLICIT);
    }

    /** s = k dt²/m. A unit that starts at rest at 1 m has an amplitude of at most 1/√(1 − s/4) m. */
    @Property(tries = 30)
    void theAmplitudeOfASpringStaysWithinItsBoundForAMillionSteps(
            @ForAll("stiffness") double s, @ForAll("masses") double mass, @ForAll("steps") double dt) {
        double k = s * mass / (dt * dt), bound = 1 / Math.sqrt(1 - s / 4), most = 0;
        Unit unit = new Unit(mass).setPosition(1, 0);
        for (int i = 0; i < 1_000_000; i++) {
            step(unit, -k * unit.getX(), 0, dt);
            most = Math.max(most, Math.abs(unit.getX()));
        }
        assertTrue(most <= bound * (1 + 1e-8), most + " m, the bound is " + bound + " m");
        assertTrue(most >= 0.99, "the oscillation has stopped: " + most + " m");
    }

    /** Any k dt²/m below 4, also very close to it. */
    @Provide
    Arbitrary<Double> stiffness() {
        return Arbitraries.oneOf(
                Doubles.logUniform(1e-4, 3.9), Doubles.logUniform(1e-4, 0.1).map(d -> 4 - d));
    }

    @Provide
    Arbitrary<Double> masses() {
        return Doubles.logUniform(1e-3, 1e6);
    }

    @Provide
    Arbitrary<Double> steps() {
        return Doubles.logUniform(1e-4, 1);
    }

    /** The forces are equal and opposite. Each step rounds each momentum by at most 2 ulp. */
    @Property(tries = 100)
    void twoUnitsWithASpringBetweenThemConserveMomentum(
            @ForAll("masses") double massA,
            @ForAll("masses") double massB,
            @ForAll("steps") double dt,
            @ForAll @DoubleRange(min = 0.01, max = 0.99) double part) {
        double k = part * 4 / (dt * dt * (1 / massA + 1 / massB));
        Unit a = new Unit(massA).setPosition(-1, 0).setVelocity(0.5, 0.25);
        Unit b = new Unit(massB).setPosition(1, 0.5).setVelocity(-0.125, 0);
        double px = massA * 0.5 - massB * 0.125, py = massA * 0.25, largest = 0;
        int n = 10_000;
        for (int i = 0; i < n; i++) {
            double fx = k * (b.getX() - a.getX()), fy = k * (b.getY() - a.getY());
            step(a, fx, fy, dt);
            step(b, -fx, -fy, dt);
            largest = Math.max(largest, massA * a.getSpeed() + massB * b.getSpeed());
        }
        double tolerance = n * largest * 0x1p-51;
        assertEquals(px, massA * a.getVx() + massB * b.getVx(), tolerance);
        assertEquals(py, massA * a.getVy() + massB * b.getVy(), tolerance);
    }

    /** The error of the position is proportional to dt. */
    @Property(tries = 50)
    void anOrbitConvergesToKeplersSolution(
            @ForAll @DoubleRange(min = 0, max = 0.6) double eccentricity,
            @ForAll @DoubleRange(min = 0.1, max = 0.9) double time) {
        double coarse = error(eccentricity, time, 4_000), fine = error(eccentricity, time, 16_000);
        assertTrue(fine < 0.02, "error " + fine);
        assertTrue(fine < coarse / 3.3, "errors " + coarse + " and, with a quarter of the step, " + fine);
    }

    /** The distance from the exact place on an ellipse with the semi-major axis 1 after a part of a revolution. */
    private static double error(double e, double time, int steps) {
        double period = 2 * Math.PI, dt = period * time / steps;
        Unit unit = new Unit(1).setPosition(1 - e, 0).setVelocity(0, Math.sqrt((1 + e) / (1 - e)));
        for (int i = 0; i < steps; i++) {
            double x = unit.getX(), y = unit.getY(), r2 = x * x + y * y, g = 1 / (r2 * Math.sqrt(r2));
            step(unit, -g * x, -g * y, dt);
        }
        double anomaly = period * time; // E, by Newton's method for Kepler's equation E − e sin E = M
        for (int i = 0; i < 50; i++) {
            anomaly -= (anomaly - e * Math.sin(anomaly) - period * time) / (1 - e * Math.cos(anomaly));
        }
        double x = Math.cos(anomaly) - e, y = Math.sqrt(1 - e * e) * Math.sin(anomaly);
        return Math.hypot(unit.getX() - x, unit.getY() - y);
    }
}
