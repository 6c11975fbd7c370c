package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Unit;

/**
 * A step of half the length halves the error of EULER, divides that of MIDPOINT by four, and has no effect on EXACT.
 */
class ConvergenceTest {
    /** m dv/dt = F − f v from x(0) = 0, v(0) = v0, and its closed form at time t. */
    private record Problem(double mass, double friction, double force, double v0, double t) {
        double velocity() {
            double terminal = force / friction;
            return terminal + (v0 - terminal) * Math.exp(-friction / mass * t);
        }

        double position() {
            double terminal = force / friction;
            return terminal * t - (v0 - terminal) * mass / friction * Math.expm1(-friction / mass * t);
        }

        Unit solve(Integrator integrator, int steps) {
            Unit unit = new Unit(mass).setFriction(friction).setVelocity(v0, 0);
            for (int i = 0; i < steps; i++) {
                unit.applyForce(force, 0);
                unit.integrate(t / steps, integrator);
            }
            return unit;
        }

        /** The order measured between n and 2n steps. */
        double order(Integrator integrator, int n, ToDoubleFunction<Unit> quantity, double exact) {
            double coarse = Math.abs(quantity.applyAsDouble(solve(integrator, n)) - exact);
            double fine = Math.abs(quantity.applyAsDouble(solve(integrator, 2 * n)) - exact);
            return Math.log(coarse / fine) / Math.log(2);
        }
    }

    static Stream<Problem> problems() {
        return Stream.of(
                new Problem(1, 1, 0, 1, 1),
                new Problem(1, 0.5, 3, 0, 2),
                new Problem(40_000, 8_000, 120_000, -5, 4),
                new Problem(2, 3, -7, 11, 0.7));
    }

    @ParameterizedTest
    @MethodSource("problems")
    void eulerIsOfFirstOrder(Problem p) {
        assertOrder(0.9, 1.1, p, Integrator.EULER, 1024);
    }

    @ParameterizedTest
    @MethodSource("problems")
    void midpointIsOfSecondOrder(Problem p) {
        assertOrder(1.9, 2.1, p, Integrator.MIDPOINT, 128);
    }

    private static void assertOrder(double low, double high, Problem p, Integrator integrator, int n) {
        double velocity = p.order(integrator, n, Unit::getVx, p.velocity());
        double position = p.order(integrator, n, Unit::getX, p.position());
        assertTrue(velocity >= low && velocity <= high, integrator + " velocity: order " + velocity);
        assertTrue(position >= low && position <= high, integrator + " position: order " + position);
    }

    @ParameterizedTest
    @MethodSource("problems")
    void exactIsTheClosedFormInOneStepAndInAThousand(Problem p) {
        for (int n : new int[] {1, 2, 7, 1000}) {
            Unit unit = p.solve(Integrator.EXACT, n);
            double v = Math.abs(p.v0) + Math.abs(p.force / p.friction);
            assertEquals(p.velocity(), unit.getVx(), 1e-12 * v, n + " steps");
            assertEquals(p.position(), unit.getX(), 1e-12 * v * p.t, n + " steps");
        }
    }

    @Test
    void midpointIsExactForAConstantForceWithoutFriction() {
        Unit unit = new Unit(2).setVelocity(3, 0);
        for (int i = 0; i < 8; i++) {
            unit.applyForce(5, 0);
            unit.integrate(0.25, Integrator.MIDPOINT);
        }
        assertEquals(3 * 2 + 0.5 * 5 / 2 * 2 * 2, unit.getX());
    }
}
