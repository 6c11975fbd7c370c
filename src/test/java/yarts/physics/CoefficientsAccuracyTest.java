package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.obermuhlner.math.big.BigDecimalMath;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Compares decay, gain and lag with the formulas of {@link Integrator} in 60 digits, as functions of z. Mass and dt are
 * 1, so z is the friction and has no rounding error. The long test prints the largest errors of a million points, which
 * docs/maintainers/quality.md lists.
 */
class CoefficientsAccuracyTest {
    private static final String[] NAMES = {"decay", "gain", "lag"};

    /** 60 digits, and the number that the difference 1 − e^−z can lose. */
    private static final MathContext DIGITS = new MathContext(76);

    private static final BigDecimal ONE = BigDecimal.ONE, HALF = new BigDecimal(0.5);

    /** The allowed errors of an integrator in ulp, in the order of NAMES. */
    private static double[] most(Integrator integrator) {
        return switch (integrator) {
            case EULER -> new double[] {0.5, 0.5, 0};
            case SEMI_IMPLICIT -> new double[] {1.5, 1.5, 0};
            case MIDPOINT -> new double[] {2, 1.5, 0};
            case EXACT -> new double[] {1.5, 2, 4.5};
        };
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    void coefficientsAreWithinAFewUlp(Integrator integrator) {
        assertWithin(integrator, worst(integrator, 3000, 1));
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    @Tag("long")
    void coefficientsAreWithinAFewUlpAtAMillionPoints(Integrator integrator) {
        double[] worst = worst(integrator, 1_000_000, 2);
        System.out.println("worst of " + integrator + " in ulp: " + Arrays.toString(worst));
        assertWithin(integrator, worst);
    }

    private static void assertWithin(Integrator integrator, double[] worst) {
        double[] most = most(integrator);
        for (int k = 0; k < 3; k++)
            assertTrue(worst[k] <= most[k], integrator + " " + NAMES[k] + ": " + worst[k] + " ulp");
    }

    /** The largest errors at random points, at the borders of the branches, and one ulp beside these. */
    private static double[] worst(Integrator integrator, int points, long seed) {
        double[] borders = borders();
        return IntStream.range(0, points + borders.length)
                .parallel()
                .mapToObj(i -> errors(integrator, i < points ? random(seed, i) : borders[i - points]))
                .reduce(new double[3], CoefficientsAccuracyTest::max);
    }

    /** Nearly uniform in the logarithm, from 1e-12 to 1e4; one of three is near the branches. */
    private static double random(long seed, int i) {
        SplittableRandom random = new SplittableRandom(seed * 1_000_000_007L + i);
        double from = i % 3 == 0 ? 0.1 : 1e-12, to = i % 3 == 0 ? 3 : 1e4;
        return from * StrictMath.exp(random.nextDouble() * StrictMath.log(to / from));
    }

    /** The borders between two formulas: 1/2, 1, 2, 700, and the points where 2^-n changes. */
    private static double[] borders() {
        return IntStream.range(0, 1014)
                .mapToDouble(n -> n == 0 ? 0.5 : n == 1 ? 1 : n == 2 ? 2 : n == 3 ? 700 : (n - 3.5) * Math.log(2))
                .flatMap(z -> Arrays.stream(new double[] {Math.nextDown(z), z, Math.nextUp(z)}))
                .toArray();
    }

    private static double[] errors(Integrator integrator, double z) {
        Table t = new Table(0);
        t.reserve(1);
        t.size = 1;
        t.friction[0] = z;
        Coefficients.prepare(t, 1, integrator);
        Coefficients.renewTile(t, 0);
        double[] all = {t.decay[0], t.gain[0], t.lag[0]};
        BigDecimal[] exact = exact(integrator, z);
        double[] errors = new double[3];
        for (int k = 0; k < 3; k++) {
            double error = exact[k].subtract(new BigDecimal(all[k])).abs().doubleValue();
            double value = exact[k].doubleValue();
            boolean gone = k == 0 && value < 1e-304; // this decay reduces even the greatest velocity to rest
            errors[k] = gone && all[k] <= 1e-304 ? 0 : error / Math.ulp(value);
        }
        // integrate of a unit alone computes the coefficients in other code.
        Table lone = new Table(1);
        lone.friction[0] = z;
        Kernel.setMaxSpeed(lone, 0, Double.POSITIVE_INFINITY);
        Coefficients.setRow(lone, 0, 1, integrator);
        double[] again = {lone.decay[0], lone.gain[0], lone.lag[0]};
        assertTrue(Arrays.equals(all, again), "alone and in a tile, z = " + z);
        return errors;
    }

    private static BigDecimal[] exact(Integrator integrator, double friction) {
        BigDecimal z = new BigDecimal(friction);
        switch (integrator) {
            case EULER:
                return new BigDecimal[] {BigDecimal.ZERO.max(ONE.subtract(z)), ONE.divide(ONE.max(z), DIGITS), ONE};
            case SEMI_IMPLICIT:
                BigDecimal implicit = ONE.divide(ONE.add(z), DIGITS);
                return new BigDecimal[] {implicit, implicit, BigDecimal.ZERO};
            case MIDPOINT:
                BigDecimal half = z.multiply(HALF), more = ONE.add(half);
                return new BigDecimal[] {
                    BigDecimal.ZERO.max(ONE.subtract(half).divide(more, DIGITS)), ONE.divide(more.max(z), DIGITS), HALF
                };
            default:
                BigDecimal decay = BigDecimalMath.exp(z.negate(), DIGITS), lost = ONE.subtract(decay);
                BigDecimal after = ONE.divide(lost, DIGITS).subtract(ONE.divide(z, DIGITS));
                return new BigDecimal[] {decay, lost.divide(z, DIGITS), ONE.subtract(after)};
        }
    }

    private static double[] max(double[] a, double[] b) {
        double[] max = new double[3];
        Arrays.setAll(max, k -> Math.max(a[k], b[k]));
        return max;
    }
}
