package yarts.physics;

/**
 * The exponential function and the coefficients of {@link Integrator#EXACT} for z ≥ 0, within 5 ulp. Only + − * / are
 * used, so the bits are the same on every platform. (StrictMath differs where Java is translated to another language.)
 */
final strictfp class Exponential {
    /** Below this z, the gain and the decay are computed from the series of {@link #gain}, which can be vectorised. */
    static final double SMALL = 0.5;

    /**
     * From this z on, the decay is 0: e^−z is below 1e-304, so its product with any velocity is below {@link
     * Kernel#REST}.
     */
    private static final double ZERO_FROM = 700;

    private static final double LOG2_E = 0x1.71547652b82fep0;
    /** ln 2 as a sum of two numbers. The first has so few digits that its product with n is exact. */
    private static final double LN2 = 0x1.62e42feep-1, LN2_REST = 0x1.a39ef35793c76p-33;
    /** Its addition and subtraction round a number to an integer. */
    private static final double INTEGER = 0x1.8p52;

    private static final int BIAS = 1023, MANTISSA = 52;

    private Exponential() {}

    /** e^−z = 2^−n e^−r, with r = z − n ln 2 between −0.35 and 0.35. */
    static double decay(double z) {
        if (z >= ZERO_FROM) return 0;
        double n = z * LOG2_E + INTEGER - INTEGER;
        double r = z - n * LN2 - n * LN2_REST;
        return (1 - r * gain(r)) * Double.longBitsToDouble((long) (BIAS - (int) n) << MANTISSA);
    }

    /** (1 − e^−z)/z = Σ (−z)^k / (k + 1)!, for z from −0.5 to 0.5; the omitted terms are below 2e-18. */
    static double gain(double z) {
        double sum = 1 / 1307674368000.0;
        sum = 1 / 87178291200.0 - z * sum;
        sum = 1 / 6227020800.0 - z * sum;
        sum = 1 / 479001600.0 - z * sum;
        sum = 1 / 39916800.0 - z * sum;
        sum = 1 / 3628800.0 - z * sum;
        sum = 1 / 362880.0 - z * sum;
        sum = 1 / 40320.0 - z * sum;
        sum = 1 / 5040.0 - z * sum;
        sum = 1 / 720.0 - z * sum;
        sum = 1 / 120.0 - z * sum;
        sum = 1 / 24.0 - z * sum;
        sum = 1 / 6.0 - z * sum;
        sum = 1 / 2.0 - z * sum;
        return 1 - z * sum;
    }

    /** 1/z − 1/(e^z − 1), given the decay e^−z. */
    static double lag(double z, double decay) {
        return z < 1 ? lag(z) : 1 / z - decay / (1 - decay);
    }

    /**
     * The same for z below 1, where the difference would lose digits by cancellation: the series
     * 1/2 − Σ B(2k) z^(2k−1) / (2k)!, with the Bernoulli numbers B; the omitted terms are below 6e-18.
     */
    static double lag(double z) {
        double s = z * z;
        double sum = -174611 / 802857662698291200000.0;
        sum = sum * s + 43867 / 5109094217170944000.0;
        sum = sum * s - 3617 / 10670622842880000.0;
        sum = sum * s + 1 / 74724249600.0;
        sum = sum * s - 691 / 1307674368000.0;
        sum = sum * s + 1 / 47900160.0;
        sum = sum * s - 1 / 1209600.0;
        sum = sum * s + 1 / 30240.0;
        sum = sum * s - 1 / 720.0;
        sum = sum * s + 1 / 12.0;
        return 0.5 - z * sum;
    }
}
