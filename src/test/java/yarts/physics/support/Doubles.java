package yarts.physics.support;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.Tuple;

/**
 * Doubles for properties, drawn as bit patterns. The patterns of positive doubles increase with the value, with an
 * equal number between each power of two and the next. So a uniform pattern is a value that is nearly uniform in its
 * logarithm.
 */
public final class Doubles {
    private Doubles() {}

    /** Any bit pattern: every magnitude, both signs, with additional zeros, infinities, NaN and limits. */
    public static Arbitrary<Double> any() {
        return Arbitraries.frequencyOf(
                Tuple.of(9, patterns(Long.MIN_VALUE, Long.MAX_VALUE, 0)), Tuple.of(1, special()));
    }

    /** Any finite double of every magnitude, including −0.0 and subnormal numbers. */
    public static Arbitrary<Double> finite() {
        return any().filter(Double::isFinite);
    }

    /** From min to max, both positive or zero: between 1 and 2 as often as between 2 and 4. Shrinks towards 1. */
    public static Arbitrary<Double> logUniform(double min, double max) {
        double simplest = Math.max(min, Math.min(max, 1));
        return patterns(bits(min), bits(max), bits(simplest));
    }

    /** Like {@link #logUniform} with either sign, and sometimes 0.0 or −0.0. */
    public static Arbitrary<Double> signedLogUniform(double min, double max) {
        Arbitrary<Double> positive = logUniform(min, max);
        return Arbitraries.frequencyOf(
                Tuple.of(8, positive), Tuple.of(8, positive.map(v -> -v)), Tuple.of(1, Arbitraries.of(0.0, -0.0)));
    }

    private static Arbitrary<Double> patterns(long from, long to, long target) {
        return Arbitraries.longs()
                .between(from, to)
                .withDistribution(RandomDistribution.uniform())
                .shrinkTowards(target)
                .edgeCases(edges -> edges.includeOnly(from, to, target))
                .map(Double::longBitsToDouble);
    }

    private static Arbitrary<Double> special() {
        return Arbitraries.of(
                0.0,
                -0.0,
                1.0,
                -1.0,
                Double.NaN,
                Double.POSITIVE_INFINITY,
                Double.NEGATIVE_INFINITY,
                Double.MIN_VALUE,
                -Double.MIN_VALUE,
                Double.MIN_NORMAL,
                -Double.MIN_NORMAL,
                Double.MAX_VALUE,
                -Double.MAX_VALUE,
                1e154,
                -1e154);
    }

    private static long bits(double v) {
        return Double.doubleToRawLongBits(v);
    }
}
