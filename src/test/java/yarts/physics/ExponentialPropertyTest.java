package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.obermuhlner.math.big.BigDecimalMath;
import java.math.BigDecimal;
import java.math.MathContext;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import yarts.physics.support.Doubles;

/**
 * Compares the exponential and the coefficients of EXACT with 80 digits. The largest errors of 200,000: 1.1, 0.8 and 4
 * ulp.
 */
class ExponentialPropertyTest {
    private static final MathContext DIGITS = new MathContext(80);
    private static final BigDecimal ONE = BigDecimal.ONE;

    /** All z whose decay is not 0, and those near the borders between two formulas: halves of ln 2, 1/2, 1. */
    @Provide
    Arbitrary<Double> stiffness() {
        return Arbitraries.oneOf(
                Doubles.logUniform(1e-12, Math.nextDown(700.0)),
                Doubles.logUniform(0.3, 2),
                Arbitraries.integers().between(0, 1009).map(n -> Math.nextDown((n + 0.5) * Math.log(2))),
                Arbitraries.integers().between(0, 1009).map(n -> Math.nextUp((n + 0.5) * Math.log(2))),
                Arbitraries.of(0.5, Math.nextDown(0.5), 1.0, Math.nextDown(1.0), Math.nextDown(700.0)));
    }

    private static BigDecimal exp(double minusZ) {
        return BigDecimalMath.exp(new BigDecimal(minusZ), DIGITS);
    }

    private static void assertUlps(BigDecimal expected, double actual, double ulps, String what) {
        double error = expected.subtract(new BigDecimal(actual)).abs().doubleValue();
        double ulp = Math.ulp(expected.doubleValue());
        assertTrue(error <= ulps * ulp, () -> what + " " + actual + ": " + error / ulp + " ulp");
    }

    @Property(tries = 5000)
    void decayIsWithinTwoUlp(@ForAll("stiffness") double z) {
        assertUlps(exp(-z), Exponential.decay(z), 2, "decay of " + z);
    }

    @Property(tries = 5000)
    void gainIsWithinTwoUlp(
            @ForAll @DoubleRange(min = -0.5, max = 0.5) double offset, @ForAll("stiffness") double any) {
        double z = any < 0.5 ? any : offset * (any / 700);
        if (Math.abs(z) < 1e-12) return; // 80 digits cancel there
        BigDecimal expected = ONE.subtract(exp(-z)).divide(new BigDecimal(z), DIGITS);
        assertUlps(expected, Exponential.gain(z), 2, "gain of " + z);
    }

    @Property(tries = 5000)
    void lagIsWithinFiveUlp(@ForAll("stiffness") double z) {
        BigDecimal left = exp(-z);
        BigDecimal expected = ONE.divide(new BigDecimal(z), DIGITS).subtract(left.divide(ONE.subtract(left), DIGITS));
        assertUlps(expected, Exponential.lag(z, Exponential.decay(z)), 5, "lag of " + z);
    }

    @Property(tries = 5000)
    void decayNeverGrowsAndIsNeverOutOfRange(@ForAll("stiffness") double z) {
        double decay = Exponential.decay(z);
        assertTrue(decay > 0 && decay <= 1);
        assertTrue(Exponential.decay(z * (1 + 1e-13)) <= decay * (1 + 4 * Math.ulp(1.0)));
    }

    /** The bits of every machine at the borders of the series, which one term more or less would change. */
    @Example
    void theBitsAtTheBordersNeverChange() {
        assertEquals(0x1.92e9a0720d3ecp-1, Exponential.gain(0.5));
        assertEquals(0x1.4c2531c3c0d38p0, Exponential.gain(-0.5));
        assertEquals(0x1.ac0e4c53d9905p-2, Exponential.lag(Math.nextDown(1.0)));
        assertEquals(0x1.ac0e4c53d9904p-2, Exponential.lag(1, Exponential.decay(1)));
        assertEquals(0x1.368b2fc6f960ap-1, Exponential.decay(0.5));
        assertEquals(0x1.1b48655f37267p-29, Exponential.decay(20));
    }

    @Example
    void theCoefficientsAreExactAtTheEnds() {
        assertEquals(1, Exponential.decay(0));
        assertEquals(1, Exponential.gain(0));
        assertEquals(0.5, Exponential.lag(0));
        for (double z : new double[] {700, 745, 1e6, Double.MAX_VALUE, Double.POSITIVE_INFINITY}) {
            assertEquals(0, Exponential.decay(z));
            assertEquals(1 / z, Exponential.lag(z, Exponential.decay(z)));
        }
        assertTrue(Exponential.decay(Math.nextDown(700.0)) * Kernel.FASTEST < Kernel.REST, "smaller: rest");
    }
}
