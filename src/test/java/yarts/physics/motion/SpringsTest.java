package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** With forces that depend on the position at the start of each step, only SEMI_IMPLICIT gains no energy. */
class SpringsTest {
    /** A unit of 1 kg, with a force at the start of each step that depends on its position. */
    private static World world(Integrator integrator, int rate, double stiffness, double gravity, Unit unit) {
        World world = new World(integrator, Timestep.fixed(rate));
        world.add(unit);
        world.addBeforeStep((w, dt) -> {
            double x = unit.getX(), y = unit.getY(), r2 = x * x + y * y;
            double k = gravity == 0 ? stiffness : gravity / (r2 * Math.sqrt(r2));
            unit.applyForce(-k * x, -k * y);
        });
        return world;
    }

    /** r = 100 m, v = 10 m/s, 60 steps per second: the radius after 100 turns, as a multiple of the initial one. */
    @ParameterizedTest
    @CsvSource({"EULER, 1.94", "SEMI_IMPLICIT, 1", "MIDPOINT, 1.61", "EXACT, 1.61"})
    void aCircularOrbitKeepsItsRadiusOnlyUnderSemiImplicit(Integrator integrator, double expected) {
        double r = 100, v = 10, turn = 2 * Math.PI * r / v;
        Unit unit = new Unit(1).setPosition(r, 0).setVelocity(0, v);
        World world = world(integrator, 60, 0, v * v * r, unit);
        double least = 1, most = 1;
        for (int i = 0; i < 100 * turn * 60; i++) {
            world.step();
            double ratio = Math.hypot(unit.getX(), unit.getY()) / r;
            least = Math.min(least, ratio);
            most = Math.max(most, ratio);
        }
        if (integrator != Integrator.SEMI_IMPLICIT) {
            assertEquals(expected, most, 0.01);
        } else {
            assertEquals(1, least, 1e-3);
            assertEquals(1, most, 1e-3);
        }
    }

    /** Undamped, 10 rad/s, at 60 steps per second, for ten minutes. */
    @ParameterizedTest
    @EnumSource
    void anUndampedSpringGrowsExceptUnderSemiImplicit(Integrator integrator) {
        Unit unit = new Unit(1).setPosition(1, 0);
        World world = world(integrator, 60, 100, 0, unit);
        double most = 0;
        for (int i = 0; i < 36_000 && most < 1e9; i++) {
            world.step();
            most = Math.max(most, Math.abs(unit.getX()));
        }
        if (integrator == Integrator.SEMI_IMPLICIT) assertTrue(most > 1 && most <= 1.0035, "amplitude " + most);
        else assertTrue(most > 1000, "amplitude " + most);
    }

    /** Stable for k dt² < 4 m + 2 f dt, and with the amplitude at most 1/√(1 − k dt²/(4 m)) without friction. */
    @Test
    void semiImplicitIsStableUpToItsLimitAndUnstableBeyond() {
        for (double friction : new double[] {0, 0.5, 3, 40}) {
            for (int rate : new int[] {1, 10, 60}) {
                double dt = 1.0 / rate, limit = (4 + 2 * friction * dt) / (dt * dt);
                for (double part : new double[] {1e-3, 0.1, 0.5, 0.9, 0.999}) {
                    double stiffness = part * limit, most = amplitude(rate, stiffness, friction, 20_000);
                    double bound = friction == 0 ? 1 / Math.sqrt(1 - part) : 1e3;
                    assertTrue(most <= bound * (1 + 1e-9), "k " + stiffness + ", f " + friction + ": " + most);
                }
                double beyond = amplitude(rate, 1.01 * limit, friction, 20_000);
                assertTrue(beyond > 1e6, "beyond the limit with f " + friction + ": " + beyond);
            }
        }
    }

    private static double amplitude(int rate, double stiffness, double friction, int steps) {
        Unit unit = new Unit(1).setFriction(friction).setPosition(1, 0);
        World world = world(Integrator.SEMI_IMPLICIT, rate, stiffness, 0, unit);
        double most = 0;
        for (int i = 0; i < steps && most < 1e9; i++) {
            world.step();
            most = Math.max(most, Math.abs(unit.getX()));
        }
        return most;
    }
}
