package yarts.physics;

/**
 * The physics: one step of a range of rows, the same code for one unit and for a million.
 *
 * <pre>{@code
 * v' = decay v + gain F             decay = decay(z), gain = gain(z) dt/m of Integrator
 * v' = v' cap / max(|v'|, cap)      the speed cap: keeps the direction
 * x' = x + dt (v' + lag (v − v'))   lag = 1 − weight(z)
 * F  = 0
 * }</pre>
 *
 * <p>HotSpot vectorises a loop that is small (60 nodes of its graph) and has no branch. So a step is a series of such
 * passes, and {@link Columns} has them run over blocks of rows that stay in the cache from pass to pass. Where a branch
 * would do, max(0, a) is written as (a + |a|) / 2, which is exact, and several times cheaper than Math.max with its care
 * for NaN and −0.0. Only + − * /, sqrt, abs, min and max are used, and StrictMath: the same bits on every JVM.
 */
final class Kernel {
    /** No unit is faster; in m/s. Its square, and that of what a step can add to it, do not overflow. */
    static final double FASTEST = 0x1p500;

    /** Velocity components below this are rest; in m/s. Its square is still a normal number. */
    static final double REST = 0x1p-500;

    private static final double HALF_OVER_REST = 0.5 / REST;

    /**
     * Rows are calm if none is above its cap, each velocity component is 0 or at least CALM, and each decay is at least
     * CALM_DECAY. Then, for so many steps without forces, neither the cap nor rest would change anything, and they are
     * left out: no velocity grows, and none gets below REST.
     */
    private static final byte CALM_STEPS = 60;

    /** In place of a number of steps: nothing is known, but nobody has disturbed the rows since the last step. */
    private static final byte LOOK = 127;

    private static final double CALM_DECAY = 0.5, CALM = REST * 0x1p60;

    /**
     * Fewer rows are stepped one by one. Passes take longer then; and where HotSpot has seen loops end after a few rounds,
     * it vectorises them no more, not even for the thousands that come later.
     */
    static final int FEW = 16;

    private Kernel() {}

    /**
     * A part of a step, for some rows. Where many loops meet in one method, as they would where a step is inlined into a
     * loop of the game, HotSpot leaves some of them slow; but it does not inline a call that leads to many
     * implementations. So each pass is compiled by itself.
     */
    private interface Pass {
        void run(Columns c, int from, int to, double dt);
    }

    // EULER moves by the velocity that the step starts with. The others need the new one, too: until the move, it waits
    // in the force, which is used up by then.
    private static final Pass CAP = (c, from, to, dt) -> cap(c.vx, c.vy, c.cap, from, to);
    private static final Pass CAP_NEXT = (c, from, to, dt) -> cap(c.fx, c.fy, c.cap, from, to);

    private static final Pass
            MOVE_THEN_PUSH_X = (c, from, to, dt) -> moveThenPush(c.x, c.vx, c.decay, c.gain, c.fx, from, to, dt),
            MOVE_THEN_PUSH_Y = (c, from, to, dt) -> moveThenPush(c.y, c.vy, c.decay, c.gain, c.fy, from, to, dt),
            COAST_X = (c, from, to, dt) -> coast(c.x, c.vx, c.decay, from, to, dt),
            COAST_Y = (c, from, to, dt) -> coast(c.y, c.vy, c.decay, from, to, dt),
            GLIDE_X = (c, from, to, dt) -> glide(c.x, c.vx, c.decay, from, to, dt),
            GLIDE_Y = (c, from, to, dt) -> glide(c.y, c.vy, c.decay, from, to, dt);
    private static final Pass PUSH_X = (c, from, to, dt) -> push(c.vx, c.decay, c.gain, c.fx, from, to),
            PUSH_Y = (c, from, to, dt) -> push(c.vy, c.decay, c.gain, c.fy, from, to),
            MOVE_BY_MEAN_X = (c, from, to, dt) -> moveByMean(c.x, c.vx, c.fx, from, to, dt / 2),
            MOVE_BY_MEAN_Y = (c, from, to, dt) -> moveByMean(c.y, c.vy, c.fy, from, to, dt / 2),
            COAST_BY_MEAN_X = (c, from, to, dt) -> coastByMean(c.x, c.vx, c.decay, from, to, dt / 2),
            COAST_BY_MEAN_Y = (c, from, to, dt) -> coastByMean(c.y, c.vy, c.decay, from, to, dt / 2),
            GLIDE_BY_MEAN_X = (c, from, to, dt) -> glideByMean(c.x, c.vx, c.decay, from, to, dt / 2),
            GLIDE_BY_MEAN_Y = (c, from, to, dt) -> glideByMean(c.y, c.vy, c.decay, from, to, dt / 2);
    private static final Pass MOVE_X = (c, from, to, dt) -> move(c.x, c.lag, c.vx, c.fx, from, to, dt),
            MOVE_Y = (c, from, to, dt) -> move(c.y, c.lag, c.vy, c.fy, from, to, dt),
            COAST_EXACTLY_X = (c, from, to, dt) -> coastExactly(c.x, c.lag, c.vx, c.decay, from, to, dt),
            COAST_EXACTLY_Y = (c, from, to, dt) -> coastExactly(c.y, c.lag, c.vy, c.decay, from, to, dt),
            GLIDE_EXACTLY_X = (c, from, to, dt) -> glideExactly(c.x, c.lag, c.vx, c.decay, from, to, dt),
            GLIDE_EXACTLY_Y = (c, from, to, dt) -> glideExactly(c.y, c.lag, c.vy, c.decay, from, to, dt);

    /** By integrator: any step; one without forces, no row above its cap; and one without forces, all rows calm. */
    private static final Pass[][][] STEPS = {
        {
            {MOVE_THEN_PUSH_X, MOVE_THEN_PUSH_Y, CAP},
            {COAST_X, COAST_Y},
            {GLIDE_X, GLIDE_Y}
        },
        {
            {PUSH_X, PUSH_Y, CAP_NEXT, MOVE_BY_MEAN_X, MOVE_BY_MEAN_Y},
            {COAST_BY_MEAN_X, COAST_BY_MEAN_Y},
            {GLIDE_BY_MEAN_X, GLIDE_BY_MEAN_Y}
        },
        {
            {PUSH_X, PUSH_Y, CAP_NEXT, MOVE_X, MOVE_Y},
            {COAST_EXACTLY_X, COAST_EXACTLY_Y},
            {GLIDE_EXACTLY_X, GLIDE_EXACTLY_Y}
        }
    };

    /** A step of rows of one block. */
    static void step(Columns c, int from, int to, double dt, Integrator how) {
        if (to - from < FEW) {
            for (int i = from; i < to; i++) stepRow(c, i, dt, how);
            return;
        }
        int block = from / Columns.BLOCK, calm = c.forced ? 0 : c.calm[block];
        boolean unknown = calm == 0 || calm == LOOK;
        for (Pass pass : STEPS[how.ordinal()][unknown ? 0 : calm < 0 ? 1 : 2]) pass.run(c, from, to, dt);
        if (calm == 0) c.calm[block] = c.forced ? 0 : LOOK; // but not yet: it may be disturbed before every step
        else c.calm[block] = (byte) (calm == LOOK ? calm(c, from, to) : calm - Integer.signum(calm));
    }

    /** The same step of one row, whatever is known of its block. */
    static void stepRow(Columns c, int i, double dt, Integrator how) {
        double vx = c.vx[i], vy = c.vy[i];
        c.vx[i] = rest(c.decay[i] * vx + c.gain[i] * c.fx[i]);
        c.vy[i] = rest(c.decay[i] * vy + c.gain[i] * c.fy[i]);
        if (isAbove(c.vx, c.vy, c.cap, i)) cap(c.vx, c.vy, c.cap, i);
        c.x[i] += shift(how, c.lag[i], vx, c.vx[i], dt);
        c.y[i] += shift(how, c.lag[i], vy, c.vy[i], dt);
        c.fx[i] = c.fy[i] = 0;
    }

    private static double shift(Integrator how, double lag, double v, double next, double dt) {
        if (how == Integrator.EULER) return dt * v; // lag is 1
        return how == Integrator.MIDPOINT ? dt / 2 * (v + next) : dt * between(lag, v, next);
    }

    private static double between(double lag, double v, double next) {
        return next + lag * (v - next);
    }

    /** For how many steps without forces rows are calm; negative, if it is that many until it is worth to look again. */
    private static int calm(Columns c, int from, int to) {
        if (anyAbove(c.vx, c.vy, c.cap, from, to)) return 0;
        for (int i = from; i < to; i++) {
            if (slow(c.vx[i]) || slow(c.vy[i]) || c.decay[i] < CALM_DECAY) return -CALM_STEPS;
        }
        return CALM_STEPS;
    }

    private static boolean slow(double v) {
        return Math.abs(v) < CALM && v != 0;
    }

    /** Whether rows that were calm are so no longer, since their decay is another. */
    static boolean disturbed(double[] decay, int from, int to) {
        for (int i = from; i < to; i++) if (decay[i] < CALM_DECAY) return true;
        return false;
    }

    private static void moveThenPush(
            double[] x, double[] v, double[] decay, double[] gain, double[] f, int from, int to, double dt) {
        for (int i = from; i < to; i++) {
            x[i] += dt * v[i];
            v[i] = rest(decay[i] * v[i] + gain[i] * f[i]);
            f[i] = 0;
        }
    }

    private static void coast(double[] x, double[] v, double[] decay, int from, int to, double dt) {
        for (int i = from; i < to; i++) {
            x[i] += dt * v[i];
            v[i] = rest(decay[i] * v[i]);
        }
    }

    private static void glide(double[] x, double[] v, double[] decay, int from, int to, double dt) {
        for (int i = from; i < to; i++) {
            x[i] += dt * v[i];
            v[i] = decay[i] * v[i];
        }
    }

    private static void push(double[] v, double[] decay, double[] gain, double[] f, int from, int to) {
        for (int i = from; i < to; i++) f[i] = rest(decay[i] * v[i] + gain[i] * f[i]);
    }

    private static void moveByMean(double[] x, double[] v, double[] next, int from, int to, double half) {
        for (int i = from; i < to; i++) {
            x[i] += half * (v[i] + next[i]);
            v[i] = next[i];
            next[i] = 0;
        }
    }

    private static void move(double[] x, double[] lag, double[] v, double[] next, int from, int to, double dt) {
        for (int i = from; i < to; i++) {
            x[i] += dt * between(lag[i], v[i], next[i]);
            v[i] = next[i];
            next[i] = 0;
        }
    }

    private static void coastByMean(double[] x, double[] v, double[] decay, int from, int to, double half) {
        for (int i = from; i < to; i++) {
            double next = rest(decay[i] * v[i]);
            x[i] += half * (v[i] + next);
            v[i] = next;
        }
    }

    private static void glideByMean(double[] x, double[] v, double[] decay, int from, int to, double half) {
        for (int i = from; i < to; i++) {
            double next = decay[i] * v[i];
            x[i] += half * (v[i] + next);
            v[i] = next;
        }
    }

    private static void coastExactly(
            double[] x, double[] lag, double[] v, double[] decay, int from, int to, double dt) {
        for (int i = from; i < to; i++) {
            double next = rest(decay[i] * v[i]);
            x[i] += dt * between(lag[i], v[i], next);
            v[i] = next;
        }
    }

    private static void glideExactly(
            double[] x, double[] lag, double[] v, double[] decay, int from, int to, double dt) {
        for (int i = from; i < to; i++) {
            double next = decay[i] * v[i];
            x[i] += dt * between(lag[i], v[i], next);
            v[i] = next;
        }
    }

    /**
     * v, or less where v is below REST: there it is multiplied by v/REST, which takes it to 0 within a few steps, however
     * slowly it decays; and 0 is never −0.0. Arithmetic on the subnormal numbers in which v would end otherwise is tens
     * of times slower, and rounds 0.9 v to v.
     */
    private static double rest(double v) {
        double a = 0.5 - Math.abs(v) * HALF_OVER_REST;
        return v - v * (a + Math.abs(a)); // a + |a| is max(0, 1 − |v|/REST): 0 for all but the slowest
    }

    /** The speed cap for rows. If none is above it they are left alone, which is the same to the bit. */
    private static void cap(double[] vx, double[] vy, double[] cap, int from, int to) {
        if (!anyAbove(vx, vy, cap, from, to)) return;
        for (int i = from; i < to; i++) cap(vx, vy, cap, i);
    }

    private static boolean anyAbove(double[] vx, double[] vy, double[] cap, int from, int to) {
        for (int i = from; i < to; i++) if (isAbove(vx, vy, cap, i)) return true;
        return false;
    }

    private static boolean isAbove(double[] vx, double[] vy, double[] cap, int i) {
        return vx[i] * vx[i] + vy[i] * vy[i] > cap[i] * cap[i];
    }

    /**
     * The speed cap. The velocity's components must be below 2^510. With cap a few rounding errors below maxSpeed, more
     * than are made here, no unit is ever over its maxSpeed.
     */
    static void cap(double[] vx, double[] vy, double[] cap, int i) {
        double a = vx[i], b = vy[i], c = cap[i];
        double over = Math.sqrt(a * a + b * b) - c;
        double k = c / (c + 0.5 * (over + Math.abs(over))); // 1 up to the cap, exactly
        vx[i] = a * k * 0x1p-52 * 0x1p52; // 0 rather than subnormal, and else the same
        vy[i] = b * k * 0x1p-52 * 0x1p52;
    }
}
