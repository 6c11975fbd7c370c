package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Compares the velocity after the motor with v + (u − v) min(1, reach/|u − v|) in 50 digits. An ulp is that of the
 * greater of |u| and |v|. The long test prints the largest error of a million points, which
 * docs/maintainers/quality.md lists.
 */
class MotorAccuracyTest {
    private static final MathContext DIGITS = new MathContext(50);

    /** The allowed error; in ulp. */
    private static final double MOST = 4;

    @Test
    void theMotorIsWithinFourUlp() {
        assertWithin(3000, 1);
    }

    @Test
    @Tag("long")
    void theMotorIsWithinFourUlpAtAMillionPoints() {
        System.out.println("worst of the motor in ulp: " + assertWithin(1_000_000, 2));
    }

    private static double assertWithin(int points, long seed) {
        double worst = IntStream.range(0, points)
                .parallel()
                .mapToDouble(i -> error(new SplittableRandom(seed * 1_000_000_007L + i)))
                .max()
                .getAsDouble();
        assertTrue(worst <= MOST, worst + " ulp");
        return worst;
    }

    /** At a random point. The two velocities are often near each other, and the reach often near their distance. */
    private static double error(SplittableRandom random) {
        double vx = number(random, 1e-6, 1e6), vy = number(random, 1e-6, 1e6);
        boolean near = random.nextInt(3) == 0;
        double ux = near ? vx * (1 + number(random, 1e-15, 1)) : number(random, 1e-6, 1e6);
        double uy = near ? vy * (1 + number(random, 1e-15, 1)) : number(random, 1e-6, 1e6);
        double part = random.nextInt(3) == 0 ? 1 + number(random, 1e-16, 1e-3) : Math.abs(number(random, 1e-9, 2));
        double reach = Math.hypot(ux - vx, uy - vy) * part;

        double k = Kernel.share(vx, vy, ux, uy, reach);
        double nextX = Kernel.blend(vx, ux, k), nextY = Kernel.blend(vy, uy, k);

        BigDecimal dx = big(ux).subtract(big(vx)), dy = big(uy).subtract(big(vy));
        BigDecimal distance = dx.multiply(dx).add(dy.multiply(dy)).sqrt(DIGITS);
        BigDecimal share = big(reach).compareTo(distance) >= 0
                ? BigDecimal.ONE
                : big(reach).divide(distance, DIGITS);
        double ulp = Math.ulp(Math.max(Math.hypot(ux, uy), Math.hypot(vx, vy)));
        return Math.max(difference(vx, dx, share, nextX), difference(vy, dy, share, nextY)) / ulp;
    }

    private static double difference(double v, BigDecimal change, BigDecimal share, double next) {
        return big(v).add(change.multiply(share)).subtract(big(next)).abs().doubleValue();
    }

    private static BigDecimal big(double v) {
        return new BigDecimal(v);
    }

    /** Nearly uniform in the logarithm, of either sign. */
    private static double number(SplittableRandom random, double from, double to) {
        double size = from * StrictMath.exp(random.nextDouble() * StrictMath.log(to / from));
        return random.nextBoolean() ? size : -size;
    }
}
