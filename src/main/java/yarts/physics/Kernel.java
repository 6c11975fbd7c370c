package yarts.physics;

import java.util.Arrays;

/**
 * The physics: one step of a range of rows, the same code for one unit and for a million.
 *
 * <pre>{@code
 * v' = decay v + gain F          decay = decay(z), gain = gain(z) dt/m of Integrator
 * v' = v' cap / max(|v'|, cap)   the speed cap: keeps the direction
 * x' = x + dt (lag v + lead v')  lag = 1 − weight(z), lead = weight(z)
 * F  = 0
 * }</pre>
 *
 * <p>HotSpot vectorises a loop when it is short, works on few arrays and has no branch. So a step is a series of such
 * passes, over blocks of rows small enough to stay in the first-level cache from pass to pass. Only + − * /, sqrt, abs,
 * min and max are used, and StrictMath: the same bits on every JVM.
 */
final class Kernel {
    /** Rows in a block; 11 arrays of 256 doubles are 22 KB of a cache of 32 KB. */
    private static final int BLOCK = 256;

    /** No unit is faster; in m/s. Its square, and that of what a step can add to it, do not overflow. */
    static final double FASTEST = 0x1p500;

    /** Velocity components below this are rest; in m/s. Its square is still a normal number. */
    static final double REST = 0x1p-500;

    /** The cap of a unit whose maxSpeed is 0; in m/s. So far below REST that {@link #rest} makes it 0 in one go. */
    static final double NO_SPEED = 0x1p-900;

    /** Swallows what is less than 2^-653, and alters nothing that is not far below REST. */
    private static final double GRAIN = 0x1p-600;

    private Kernel() {}

    static void step(Columns c, int from, int to, double dt, Integrator how) {
        for (int i = from; i < to; i += BLOCK) {
            int end = Math.min(i + BLOCK, to);
            if (how == Integrator.EULER) euler(c, i, end, dt);
            else average(c, i, end, dt);
        }
    }

    /** A step with lag 1: the position moves by the velocity the step starts with. */
    private static void euler(Columns c, int from, int to, double dt) {
        move(c.x, c.vx, from, to, dt);
        move(c.y, c.vy, from, to, dt);
        push(c.vx, c.decay, c.gain, c.fx, c.vx, from, to);
        push(c.vy, c.decay, c.gain, c.fy, c.vy, from, to);
        cap(c.vx, c.vy, c.cap, from, to);
        Arrays.fill(c.fx, from, to, 0);
        Arrays.fill(c.fy, from, to, 0);
    }

    /** A step that needs both velocities: the new one waits in the force, which is used up by then. */
    private static void average(Columns c, int from, int to, double dt) {
        push(c.vx, c.decay, c.gain, c.fx, c.fx, from, to);
        push(c.vy, c.decay, c.gain, c.fy, c.fy, from, to);
        cap(c.fx, c.fy, c.cap, from, to);
        move(c.x, c.lag, c.vx, c.lead, c.fx, from, to, dt);
        move(c.y, c.lag, c.vy, c.lead, c.fy, from, to, dt);
        System.arraycopy(c.fx, from, c.vx, from, to - from);
        System.arraycopy(c.fy, from, c.vy, from, to - from);
        Arrays.fill(c.fx, from, to, 0);
        Arrays.fill(c.fy, from, to, 0);
    }

    private static void move(double[] x, double[] v, int from, int to, double dt) {
        for (int i = from; i < to; i++) x[i] += dt * v[i];
    }

    private static void move(
            double[] x, double[] lag, double[] v, double[] lead, double[] next, int from, int to, double dt) {
        for (int i = from; i < to; i++) x[i] += dt * (lag[i] * v[i] + lead[i] * next[i]);
    }

    private static void push(double[] v, double[] decay, double[] gain, double[] f, double[] next, int from, int to) {
        for (int i = from; i < to; i++) next[i] = decay[i] * v[i] + gain[i] * f[i];
    }

    /**
     * The speed cap, and rest. The velocities' components must be below 2^510.
     *
     * <p>A speed above the cap c becomes c less 8 to 16 rounding errors, more than the arithmetic makes: no unit is
     * ever over its cap, and one exactly at it stays so.
     */
    static void cap(double[] vx, double[] vy, double[] cap, int from, int to) {
        for (int i = from; i < to; i++) {
            double a = vx[i], b = vy[i], c = cap[i];
            double s = Math.sqrt(a * a + b * b);
            double margin = Math.min(8 * Math.max(s - c, 0), c * 0x1p-50); // 0 up to the cap
            double k = (c - margin) / Math.max(s, c); // 1 up to the cap
            vx[i] = rest(a * k);
            vy[i] = rest(b * k);
        }
    }

    /**
     * v, or less where v is below REST: there it is multiplied by v/REST, which takes it to 0 within a few steps, however
     * slowly it decays, and without a branch. What GRAIN swallows is 0 at once, and never −0.0. Arithmetic on the
     * subnormal numbers in which v would end otherwise is tens of times slower, and rounds 0.9 v to v.
     */
    private static double rest(double v) {
        return v * Math.min(1, Math.abs(v) * (1 / REST)) + GRAIN - GRAIN;
    }

    static void coefficients(Columns c, int from, int to, double dt, Integrator how) {
        double[] mass = c.mass, friction = c.friction, decay = c.decay, gain = c.gain, lag = c.lag, lead = c.lead;
        switch (how) {
            case EULER:
                for (int i = from; i < to; i++) {
                    double h = dt / mass[i], z = friction[i] * h;
                    decay[i] = Math.max(0, 1 - z);
                    gain[i] = h / Math.max(1, z);
                }
                break;
            case MIDPOINT:
                for (int i = from; i < to; i++) {
                    double h = dt / mass[i], half = friction[i] * h / 2;
                    decay[i] = Math.max(0, (1 - half) / (1 + half));
                    gain[i] = h / Math.max(1 + half, 2 * half);
                }
                Arrays.fill(lag, from, to, 0.5);
                Arrays.fill(lead, from, to, 0.5);
                break;
            case EXACT:
                for (int i = from; i < to; i++) {
                    double h = dt / mass[i], z = friction[i] * h;
                    double grown = -StrictMath.expm1(-z); // 1 − e^−z
                    decay[i] = z < NO_DECAY ? StrictMath.exp(-z) : 0;
                    gain[i] = z > 0 ? h * (grown / z) : h;
                    lag[i] = lag(z);
                    lead[i] = 1 - lag[i];
                }
                break;
        }
    }

    /** From this z on even FASTEST decays to rest in one step, and e^−z would be subnormal soon after. */
    private static final double NO_DECAY = 700;

    /**
     * 1 − weight(z) = 1/z − 1/(e^z − 1): 1/2 at 0, and close to 1/z for large z. Below 1, where the difference would
     * cancel, its series 1/2 − Σ B(2k) z^(2k−1) / (2k)!, with the Bernoulli numbers B; the terms left out come to less
     * than 6e-18.
     */
    static double lag(double z) {
        if (z >= 1) return 1 / z - 1 / StrictMath.expm1(z);
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
