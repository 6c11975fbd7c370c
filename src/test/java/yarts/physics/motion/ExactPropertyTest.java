package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.obermuhlner.math.big.BigDecimalMath;
import java.math.BigDecimal;
import java.math.MathContext;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.support.Doubles;

/** Compares EXACT with the closed form, computed to 60 digits and more. */
class ExactPropertyTest {
    /** 60 digits, and the number of digits that 1 − e^−z can lose. */
    private static final MathContext DIGITS = new MathContext(80);

    @Provide
    Arbitrary<Double> stiffness() {
        return Arbitraries.oneOf(
                Doubles.logUniform(1e-20, 1e6),
                Doubles.logUniform(0.5, 2), // around the threshold of the series
                Doubles.logUniform(600, 800), // where e^−z becomes 0
                Arbitraries.of(0.0, Double.MIN_VALUE, Math.nextDown(1.0), 1.0, 1e6));
    }

    @Provide
    Arbitrary<Double> sizes() {
        return Doubles.signedLogUniform(1e-9, 1e9);
    }

    @Property(tries = 2000)
    void oneStepIsWithin16UlpOfTheClosedForm(
            @ForAll("stiffness") double z, @ForAll("sizes") double v, @ForAll("sizes") double force) {
        assertClosedForm(1, z, 1, v, force, 16);
    }

    /**
     * The rounding error dz of z causes the factor e^−dz, a relative error of dz: at z = 100, the last two digits of
     * e^−z depend on it.
     */
    @Property(tries = 2000)
    void withAnyMassAndDtTheRoundingOfZAddsNoMoreThanZUlp(
            @ForAll("stiffness") double z,
            @ForAll("sizes") double v,
            @ForAll("sizes") double force,
            @ForAll("stiffness") double dt,
            @ForAll("stiffness") double mass) {
        if (dt < 1e-6 || mass < 1e-6) return;
        assertClosedForm(mass, z * mass / dt, dt, v, force, 16 + 2 * z);
    }

    private static void assertClosedForm(double mass, double friction, double dt, double v, double f, double ulps) {
        Unit unit = new Unit(mass).setFriction(friction).setVelocity(v, 0);
        unit.applyForce(f, 0);
        unit.integrate(dt, Integrator.EXACT);

        BigDecimal h = big(dt).divide(big(mass), DIGITS);
        BigDecimal z = h.multiply(big(friction));
        BigDecimal decay = exp(z.negate());
        BigDecimal gain = gain(z, decay);
        // v' = e^−z v + gain h F; x' = ∫ v dt = dt (gain v + (1 − gain)/z h F)
        BigDecimal kept = decay.multiply(big(v));
        BigDecimal pushed = gain.multiply(h).multiply(big(f));
        BigDecimal coasted = big(dt).multiply(gain).multiply(big(v));
        BigDecimal carried = big(dt).multiply(displacement(z, gain)).multiply(h).multiply(big(f));
        assertUlps(kept, pushed, unit.getVx(), ulps, "velocity");
        assertUlps(coasted, carried, unit.getX(), ulps, "displacement");
    }

    /** (1 − e^−z)/z, or for a very small z its series 1 − z/2 + z²/6 − z³/24. */
    private static BigDecimal gain(BigDecimal z, BigDecimal decay) {
        if (z.compareTo(big(1e-15)) > 0) return BigDecimal.ONE.subtract(decay).divide(z, DIGITS);
        return BigDecimal.ONE
                .subtract(z.divide(big(2), DIGITS))
                .add(z.pow(2).divide(big(6), DIGITS))
                .subtract(z.pow(3).divide(big(24), DIGITS));
    }

    /** (1 − gain)/z, or its series 1/2 − z/6 + z²/24 − z³/120. */
    private static BigDecimal displacement(BigDecimal z, BigDecimal gain) {
        if (z.compareTo(big(1e-15)) > 0) return BigDecimal.ONE.subtract(gain).divide(z, DIGITS);
        return big(0.5).subtract(z.divide(big(6), DIGITS))
                .add(z.pow(2).divide(big(24), DIGITS))
                .subtract(z.pow(3).divide(big(120), DIGITS));
    }

    private static BigDecimal exp(BigDecimal x) {
        return x.compareTo(big(-3000)) < 0 ? BigDecimal.ZERO : BigDecimalMath.exp(x, DIGITS);
    }

    /** Measures the error in ulp of the larger of the two terms, because their sum may cancel. */
    private static void assertUlps(BigDecimal a, BigDecimal b, double actual, double ulps, String what) {
        BigDecimal expected = a.add(b);
        double scale = Math.max(
                Math.abs(expected.doubleValue()),
                Math.max(a.abs().doubleValue(), b.abs().doubleValue()));
        double error = expected.subtract(big(actual)).abs().doubleValue();
        double allowed = Math.max(ulps * Math.ulp(scale), Range.REST);
        assertTrue(
                error <= allowed,
                () -> what + " " + actual + " instead of " + expected.doubleValue() + ": " + error / Math.ulp(scale)
                        + " ulp");
    }

    @Property
    void nStepsOfDtOverNAgreeWithOneStepOfDt(
            @ForAll("stiffness") double z,
            @ForAll("sizes") double v,
            @ForAll("sizes") double force,
            @ForAll @IntRange(min = 2, max = 1000) int n) {
        Unit one = new Unit(1).setFriction(z).setVelocity(v, -v);
        one.applyForce(force, force);
        one.integrate(1, Integrator.EXACT);
        Unit many = new Unit(1).setFriction(z).setVelocity(v, -v);
        for (int i = 0; i < n; i++) {
            many.applyForce(force, force);
            many.integrate(1.0 / n, Integrator.EXACT);
        }
        double scale = Math.abs(v) + Math.abs(force) / Math.max(1, z);
        assertEquals(one.getVx(), many.getVx(), 1e-12 * scale);
        assertEquals(one.getVy(), many.getVy(), 1e-12 * scale);
        assertEquals(one.getX(), many.getX(), 1e-12 * scale);
        assertEquals(one.getY(), many.getY(), 1e-12 * scale);
    }

    private static BigDecimal big(double v) {
        return new BigDecimal(v);
    }
}
