package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The numbers for crowds in docs/cookbook.md, "Springs", and the example of docs/guide.md, "All units at once". */
class SpringsRecipeTest {
    /** The limit in the table: the largest k for an effective stiffness of n·k. */
    static double limit(Integrator integrator, int n, double mass, double friction, double dt) {
        switch (integrator) {
            case EULER:
                return friction / (n * dt);
            case SEMI_IMPLICIT:
                return (4 * mass + 2 * friction * dt) / (n * dt * dt);
            default:
                return 2 * friction / (n * dt);
        }
    }

    /** Units of 1 kg that push each other apart below a distance of 1 m, and are pushed towards one point or a corner. */
    private static final class Crowd {
        static final int RATE = 60;

        final World world;
        final int n;
        final double friction, k, push;
        final boolean corner;
        private final double[] x, force;

        Crowd(Integrator integrator, int n, double friction, double k, double push, boolean corner) {
            world = new World(integrator, Timestep.fixed(RATE));
            this.n = n;
            this.friction = friction;
            this.k = k;
            this.push = push * k;
            this.corner = corner;
            x = new double[2 * n];
            force = new double[2 * n];
            Random random = new Random(n);
            double side = 1.5 * Math.sqrt(n);
            for (int i = 0; i < n; i++) {
                Unit unit = world.add(new Unit(1).setFriction(friction));
                unit.setPosition(side * (random.nextDouble() - 0.5), side * (random.nextDouble() - 0.5));
            }
            world.addBeforeStep((w, dt) -> forces());
        }

        private void forces() {
            world.copyPositions(x, 0, 1);
            Arrays.fill(force, 0);
            for (int i = 0; i < 2 * n; i += 2) {
                for (int j = 0; j < i; j += 2) {
                    double dx = x[i] - x[j], dy = x[i + 1] - x[j + 1], distance = Math.sqrt(dx * dx + dy * dy);
                    if (distance == 0 || distance >= 1) continue;
                    double repulsion = k * (1 - distance) / distance;
                    add(i, repulsion * dx, repulsion * dy);
                    add(j, -repulsion * dx, -repulsion * dy);
                }
                if (corner) {
                    double wall = 0.75 * Math.sqrt(n), diagonal = push * Math.sqrt(0.5);
                    add(i, k * Math.max(0, -wall - x[i]) - diagonal, k * Math.max(0, -wall - x[i + 1]) - diagonal);
                } else {
                    double distance = Math.max(1, Math.hypot(x[i], x[i + 1]));
                    add(i, -push * x[i] / distance, -push * x[i + 1] / distance);
                }
            }
            world.applyForces(force, 0);
        }

        private void add(int i, double fx, double fy) {
            force[i] += fx;
            force[i + 1] += fy;
        }

        /** The highest speed in the last second, in m/s; 0 if all units have come to rest before. */
        double play() {
            double travel = 30 * Math.sqrt(n) * friction / push;
            int ticks = (int) (RATE * Math.min(3000, 60 + travel)), still = 0;
            double fastest = 0;
            for (int tick = 0; tick < ticks && still < RATE; tick++) {
                world.step();
                double speed = 0;
                for (Unit unit : world) speed = Math.max(speed, unit.getSpeed());
                still = speed < 1e-5 * RATE ? still + 1 : 0;
                fastest = tick < ticks - RATE ? 0 : Math.max(fastest, speed);
            }
            return still == RATE ? 0 : fastest;
        }

        double nearest() {
            double nearest = 1;
            world.copyPositions(x, 0, 1);
            for (int i = 0; i < 2 * n; i += 2) {
                for (int j = 0; j < i; j += 2) {
                    nearest = Math.min(nearest, Math.hypot(x[i] - x[j], x[i + 1] - x[j + 1]));
                }
            }
            return nearest;
        }
    }

    private static Crowd crowd(Integrator how, int springs, int n, double friction, double push, boolean corner) {
        return new Crowd(how, n, friction, limit(how, springs, 1, friction, 1.0 / Crowd.RATE), push, corner);
    }

    /** Under pushes that keep the distances above 0.55 m. */
    @ParameterizedTest
    @EnumSource
    void aCrowdComesToRestWithTheRuleForEightSprings(Integrator how) {
        double[][] cases = {{7, 0.3}, {30, 0.03}, {30, 0.1}, {100, 0.03}, {100, 0.06}};
        for (double[] a : cases) {
            for (double friction : a[0] == 100 ? new double[] {18} : new double[] {2, 18, 120}) {
                for (boolean corner : new boolean[] {false, true}) {
                    Crowd crowd = crowd(how, 8, (int) a[0], friction, a[1], corner);
                    String which = how + " " + Arrays.toString(a) + " " + friction + " " + corner;
                    assertEquals(0, crowd.play(), which);
                    double nearest = crowd.nearest();
                    assertTrue(nearest > 0.55, which + ": " + nearest + " m");
                }
            }
        }
    }

    /** Under pushes that keep the distances above 0.3 m. */
    @ParameterizedTest
    @EnumSource
    void aCrowdUnderAStrongPushComesToRestWithTheRuleForSixteenSprings(Integrator how) {
        for (int n : new int[] {30, 100}) {
            for (double friction : n == 100 ? new double[] {18} : new double[] {2, 18, 120}) {
                for (boolean corner : new boolean[] {false, true}) {
                    Crowd crowd = crowd(how, 16, n, friction, 0.3, corner);
                    String which = how + " " + n + " " + friction + " " + corner;
                    assertEquals(0, crowd.play(), which);
                    double nearest = crowd.nearest();
                    assertTrue(nearest > 0.3 && nearest < 0.55, which + ": " + nearest + " m");
                }
            }
        }
    }

    /** So a crowd needs more than the rule for a chain, and under a strong push more than the rule for a crowd. */
    @ParameterizedTest
    @EnumSource
    void aCrowdShakesWithTheRuleForFourSpringsAndUnderAStrongPushWithTheRuleForEight(Integrator how) {
        for (boolean corner : new boolean[] {false, true}) {
            double soft = crowd(how, 4, 30, 18, 0.1, corner).play(),
                    hard = crowd(how, 8, 100, 18, 0.3, corner).play();
            assertTrue(soft > 0.5 && hard > 0.5, how + " " + corner + ": " + soft + " and " + hard + " m/s");
        }
    }

    /** The measured effective stiffnesses in the table, in multiples of k. */
    @ParameterizedTest
    @EnumSource
    void theEffectiveStiffnessOfACrowdIsFiveToSevenAndUnderAStrongPushSevenToThirteen(Integrator how) {
        for (boolean corner : new boolean[] {false, true}) {
            double soft = count(how, 30, 0.1, corner);
            assertEquals(6, soft, 1, "soft, " + corner);
            for (double hard : new double[] {count(how, 30, 0.3, corner), count(how, 100, 0.3, corner)})
                assertEquals(10, hard, 3, "hard, " + corner);
        }
    }

    /** The effective stiffness: lowers the number of springs until the crowd shakes. For EXACT, with its exact lag. */
    private static double count(Integrator how, int n, double push, boolean corner) {
        double friction = 18, dt = 1.0 / Crowd.RATE, z = friction * dt;
        double exact = how == Integrator.EXACT ? 0.5 / (1 / z - 1 / Math.expm1(z)) : 1;
        for (double count = 14; ; count /= 1.05) {
            double k = exact * limit(how, 1, 1, friction, dt) / count;
            if (new Crowd(how, n, friction, k, push, corner).play() > 0) return count * 1.05;
        }
    }

    /** 30 units, f/m = 18 /s: the crowd allows only a third to two thirds of k·dt = f, the rule for a single unit. */
    @Test
    void thirtyUnitsUnderAPushComeToRestAtAThirdOfTheStiffnessForOneUnitAndShakeAtTwoThirds() {
        double unit = 18 * Crowd.RATE;
        assertEquals(0, new Crowd(Integrator.EXACT, 30, 18, 0.33 * unit, 0.1, false).play());
        double shaking = new Crowd(Integrator.EXACT, 30, 18, 0.67 * unit, 0.1, false).play();
        assertTrue(shaking > 5, shaking + " m/s");
    }

    /** k = 5,000 N/m, c = 200 N·s/m, m = 2 kg at 50 steps/s, from (2, 0) to (5, 5). */
    @ParameterizedTest
    @EnumSource
    void withFrictionAUnitOnASpringComesToRest(Integrator how) {
        Unit unit = new Unit(2).setFriction(200).setPosition(2, 0);
        for (int tick = 0; tick < 500; tick++) pull(unit, 0, how);
        assertEquals(5, unit.getX(), 1e-9);
        assertEquals(5, unit.getY(), 1e-9);
        assertEquals(0, unit.getSpeed(), 1e-9);
    }

    @Test
    void theSameDamperAsAForceReversesTheUnitInEveryStepOrMakesItsOscillationsGrow() {
        for (Integrator how : new Integrator[] {Integrator.EXACT, Integrator.MIDPOINT}) {
            Unit unit = new Unit(2).setPosition(2, 0);
            for (int tick = 0; tick < 500; tick++) {
                double vx = unit.getVx(), vy = unit.getVy();
                pull(unit, 200, how);
                if (tick < 100) continue;
                assertEquals(194.4, unit.getSpeed(), 0.1);
                assertTrue(unit.getVx() * vx < 0 && unit.getVy() * vy < 0);
            }
        }
        Unit unit = new Unit(2).setPosition(2, 0);
        for (int tick = 0; tick < 100; tick++) pull(unit, 200, Integrator.SEMI_IMPLICIT);
        assertTrue(unit.getSpeed() > 1e6, unit.toString());
    }

    private static void pull(Unit unit, double damper, Integrator how) {
        double fx = 5000 * (5 - unit.getX()) - damper * unit.getVx();
        double fy = 5000 * (5 - unit.getY()) - damper * unit.getVy();
        unit.applyForce(fx, fy);
        unit.integrate(0.02, how);
    }
}
