package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.obermuhlner.math.big.BigDecimalMath;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * Compares whole paths of units under a constant force with closed forms in 60 digits: EXACT with the solution of m
 * dv/dt = F − f v at the end of all steps; the others with the geometric series of their own rule. The difference is
 * the sum of the rounding errors of all steps.
 */
class PathAccuracyTest {
    private static final int STEPS = 1000, UNITS = 100;

    /** 60 digits, and the number that differences lose for a small z. */
    private static final MathContext DIGITS = new MathContext(90);

    private static final BigDecimal ZERO = BigDecimal.ZERO, ONE = BigDecimal.ONE, TWO = new BigDecimal(2);

    /** The allowed error, relative to the greatest velocity and displacement. */
    private static final double MOST = 2.5e-13;

    @ParameterizedTest
    @EnumSource(Integrator.class)
    void hundredsOfUnitsFollowTheClosedForm(Integrator integrator) {
        double worst = worst(integrator, 3, 1);
        assertTrue(worst <= MOST, integrator + ": " + worst);
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    @Tag("long")
    void tenThousandUnitsFollowTheClosedForm(Integrator integrator) {
        double worst = worst(integrator, 100, 2);
        System.out.println("worst of " + integrator + " after " + STEPS + " steps: " + worst);
        assertTrue(worst <= MOST, integrator + ": " + worst);
    }

    /** The largest error of several worlds, each with its own dt. */
    private static double worst(Integrator integrator, int worlds, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double worst = 0;
        for (int i = 0; i < worlds; i++) worst = Math.max(worst, worst(integrator, random));
        return worst;
    }

    private static double worst(Integrator integrator, SplittableRandom random) {
        double dt = number(random, 1e-4, 1);
        World world = new World(integrator, Timestep.variable(1));
        double[] v = new double[UNITS], force = new double[UNITS], xy = new double[2 * UNITS];
        for (int i = 0; i < UNITS; i++) {
            Unit unit = world.add(new Unit(number(random, 1e-2, 1e5)));
            double z = random.nextInt(8) == 0 ? 0 : number(random, 1e-8, 10);
            unit.setFriction(z * unit.getMass() / dt);
            v[i] = signed(random, 1e-2, 1e3);
            force[i] = signed(random, 1e-2, 1e3) * unit.getMass();
            unit.setVelocity(v[i], 0);
            xy[2 * i] = force[i];
        }
        for (int step = 0; step < STEPS; step++) {
            world.applyForces(xy, 0);
            world.step(dt);
        }
        double worst = 0;
        for (int i = 0; i < UNITS; i++) {
            worst = Math.max(worst, error(world.get(i), v[i], force[i], dt, integrator));
            assertEquals(0, world.get(i).getY(), "nothing pushes it sideways");
        }
        return worst;
    }

    private static double error(Unit unit, double v0, double force, double dt, Integrator integrator) {
        BigDecimal h = big(dt).divide(big(unit.getMass()), DIGITS);
        BigDecimal z = h.multiply(big(unit.getFriction())), push = h.multiply(big(force)), n = big(STEPS);
        BigDecimal[] end = integrator == Integrator.EXACT
                ? step(integrator, z.multiply(n), push.multiply(n), big(v0), big(dt).multiply(n))
                : series(integrator, z, push, big(v0), big(dt));
        // The greatest speed, and the distance at that speed.
        double fastest = Math.max(Math.abs(v0), end[0].abs().doubleValue());
        double speed = Math.max(fastest, end[1].abs().doubleValue() / (dt * STEPS));
        return Math.max(
                end[0].subtract(big(unit.getVx())).abs().doubleValue() / fastest,
                end[1].subtract(big(unit.getX())).abs().doubleValue() / (dt * STEPS * speed));
    }

    /** The velocity and the displacement after all steps, each v' = d v + g, with the sum 1 + d + d² + … */
    private static BigDecimal[] series(
            Integrator integrator, BigDecimal z, BigDecimal push, BigDecimal v, BigDecimal dt) {
        BigDecimal n = big(STEPS),
                d = decay(integrator, z),
                g = gain(integrator, z).multiply(push);
        BigDecimal power = d.pow(STEPS, DIGITS), left = ONE.subtract(d);
        boolean free = left.signum() == 0;
        BigDecimal sum = free ? n : ONE.subtract(power).divide(left, DIGITS);
        BigDecimal sums =
                free ? n.multiply(n.subtract(ONE)).divide(TWO) : n.subtract(sum).divide(left, DIGITS);
        BigDecimal end = power.multiply(v).add(g.multiply(sum));
        BigDecimal firsts = v.multiply(sum).add(g.multiply(sums)); // the sum of the velocities before steps
        BigDecimal led = end.subtract(v); // the sum of those after steps, minus firsts
        BigDecimal share = switch (integrator) {
            case EULER -> ZERO;
            case SEMI_IMPLICIT -> ONE;
            default -> ONE.divide(TWO);
        };
        return new BigDecimal[] {end, firsts.add(led.multiply(share)).multiply(dt)};
    }

    private static BigDecimal decay(Integrator integrator, BigDecimal z) {
        BigDecimal half = z.divide(TWO);
        return switch (integrator) {
            case EULER -> ZERO.max(ONE.subtract(z));
            case SEMI_IMPLICIT -> ONE.divide(ONE.add(z), DIGITS);
            case MIDPOINT -> ZERO.max(ONE.subtract(half).divide(ONE.add(half), DIGITS));
            case EXACT -> z.intValue() > 3000 ? ZERO : BigDecimalMath.exp(z.negate(), DIGITS);
        };
    }

    private static BigDecimal gain(Integrator integrator, BigDecimal z) {
        BigDecimal half = z.divide(TWO);
        return switch (integrator) {
            case EULER -> ONE.divide(ONE.max(z), DIGITS);
            case SEMI_IMPLICIT -> ONE.divide(ONE.add(z), DIGITS);
            case MIDPOINT -> ONE.divide(z.max(ONE.add(half)), DIGITS);
            case EXACT ->
                z.signum() == 0 ? ONE : ONE.subtract(decay(integrator, z)).divide(z, DIGITS);
        };
    }

    /** The closed form, over a time t: z = f t/m, push = F t/m. */
    private static BigDecimal[] step(Integrator integrator, BigDecimal z, BigDecimal push, BigDecimal v, BigDecimal t) {
        BigDecimal gain = gain(integrator, z);
        BigDecimal carried =
                z.signum() == 0 ? ONE.divide(TWO) : ONE.subtract(gain).divide(z, DIGITS);
        return new BigDecimal[] {
            decay(integrator, z).multiply(v).add(gain.multiply(push)),
            gain.multiply(v).add(carried.multiply(push)).multiply(t)
        };
    }

    private static BigDecimal big(double v) {
        return new BigDecimal(v);
    }

    /** Nearly uniform in the logarithm. */
    private static double number(SplittableRandom random, double from, double to) {
        return from * StrictMath.exp(random.nextDouble() * StrictMath.log(to / from));
    }

    private static double signed(SplittableRandom random, double from, double to) {
        return number(random, from, to) * (random.nextBoolean() ? 1 : -1);
    }
}
