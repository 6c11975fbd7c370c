package yarts.physics;

/**
 * The physics: one step of a block's rows, the same formula for one unit and for a million. A row has five coefficients,
 * into which {@link Coefficients} folds dt, the integrator, mass, friction and top speed:
 *
 * <pre>{@code
 * v' = decay v + gain F          decay(z), gain(z) dt/m of Integrator
 * v' = v' cap / |v'|             if |v'| > cap: the speed cap, which keeps the direction
 * x' = x + before v + after v'   before = dt (1 − weight(z)), after = dt weight(z)
 * F  = 0
 * }</pre>
 *
 * <p>Here it stands for one row; {@link Passes} does it for many. Where a branch would do, max(0, a) is written as
 * (a + |a|) / 2, which is exact, and cheaper than Math.max with its care for NaN and −0.0. Only + − * /, sqrt, abs, min
 * and max are used: the same bits everywhere. Of a sum's operands, one that is a sum is the first, and of a product's
 * likewise: TeaVM's JavaScript has a + (b + c) without the parentheses.
 */
final class Kernel {
    /** No unit is faster; in m/s. Its square, and that of what a step can add to it, do not overflow. */
    static final double FASTEST = 0x1p500;

    /** Velocity components below this are rest; in m/s. Its square is still a normal number. */
    static final double REST = 0x1p-500;

    /**
     * A speed above the cap is cut to the cap less this part of it; a speed at the cap is left alone. The rounding errors
     * of the cut, and of {@link #speed}, are less: what was cut is not above the cap, and is not cut again.
     */
    static final double MARGIN = 0x1p-49;

    /** What is over the cap at all, 2^-53 of it or more, times this is more than MARGIN. */
    private static final double STEEP = 0x1p60;

    /** Of the top speed: what is above this is at it. */
    private static final double AT_CAP = 1 - 2 * MARGIN;

    private static final double HALF_OVER_REST = 0.5 / REST;

    private Kernel() {}

    /** v' before cap and rest. */
    static double velocity(double decay, double v, double gain, double force) {
        return decay * v + gain * force;
    }

    /** x'. */
    static double position(double x, double before, double v, double after, double next) {
        return before * v + after * next + x;
    }

    /**
     * v, or less where v is below REST: there it is multiplied by v/REST, which takes it to 0 within a few steps, however
     * slowly it decays; and 0 is never −0.0. Arithmetic on the subnormal numbers in which v would end otherwise is tens
     * of times slower, and rounds 0.9 v to v.
     */
    static double rest(double v) {
        double a = 0.5 - Math.abs(v) * HALF_OVER_REST;
        return v - v * (a + Math.abs(a)); // a + |a| is max(0, 1 − |v|/REST): 0 for all but the slowest
    }

    /** |v|. In the range of velocities, squares neither overflow nor vanish. */
    static double speed(double vx, double vy) {
        return Math.sqrt(vx * vx + vy * vy);
    }

    /** The speed of a row; its top speed if it is so close to it that the cap's rounding errors may be all that is between. */
    static double speed(Columns c, int i) {
        double speed = speed(c.vx[i], c.vy[i]), most = c.maxSpeed[i];
        return speed >= most * AT_CAP ? most : speed;
    }

    /** The part that is left of each component under the cap: exactly 1 for a speed up to it. */
    static double left(double vx, double vy, double cap) {
        double speed = speed(vx, vy), over = speed - cap;
        over = 0.5 * (over + Math.abs(over));
        return cap / (over + Math.min(over * STEEP, speed * MARGIN) + cap);
    }

    /** The speed that a top speed comes to: the kernel takes neither 0 nor infinity. */
    static double cap(double maxSpeed) {
        return Math.max(REST, Math.min(maxSpeed, FASTEST));
    }

    /** Gives a row a velocity of any finite magnitude, as far as it may be. */
    static void accept(Columns c, int i, double vx, double vy) {
        double most = Math.max(Math.abs(vx), Math.abs(vy));
        double scale = most > FASTEST ? FASTEST / most : 1; // so that squares do not overflow
        vx *= scale;
        vy *= scale;
        double left = c.maxSpeed[i] < REST ? 0 : left(vx, vy, cap(c.maxSpeed[i]));
        c.vx[i] = restAtOnce(vx * left);
        c.vy[i] = restAtOnce(vy * left);
    }

    private static double restAtOnce(double v) {
        return Math.abs(v) < REST ? 0 : v;
    }

    /** A step of one row. */
    static void step(Columns c, int i) {
        double vx = c.vx[i], vy = c.vy[i];
        double nextX = velocity(c.decay[i], vx, c.gain[i], c.fx[i]);
        double nextY = velocity(c.decay[i], vy, c.gain[i], c.fy[i]);
        double left = left(nextX, nextY, c.cap[i]);
        c.vx[i] = rest(nextX * left);
        c.vy[i] = rest(nextY * left);
        c.settle(i);
        c.x[i] = position(c.x[i], c.before[i], vx, c.after[i], c.vx[i]);
        c.y[i] = position(c.y[i], c.before[i], vy, c.after[i], c.vy[i]);
        c.fx[i] = c.fy[i] = 0;
    }
}
