package yarts.physics;

/**
 * A step of all rows of a block, as a series of passes: loops with a part of {@link Kernel}'s formula each.
 *
 * <p>HotSpot vectorises a loop that is small (60 nodes of its graph) and has no branch; so there are several, over a block
 * that stays in the cache from pass to pass. It vectorises a loop no more, not even for the thousands of rounds that come
 * later, once it has seen it end after a few: so they run over a multiple of {@link Columns#LANES} rows. Where many loops
 * meet in one method, as they would where a step is inlined into a loop of the game, it leaves some of them slow; but it
 * does not inline a call that leads to many implementations. So each pass is an object behind an interface, and compiled
 * by itself.
 */
final class Passes {
    private Passes() {}

    /** A step of all rows. */
    static void step(Columns c) {
        run(PUSHED, c);
    }

    /** The same if there are no forces: nobody gets faster, so there is nothing to cap. */
    static void coast(Columns c) {
        run(COASTING, c);
    }

    /** A part of a step, for rows from one on. */
    private interface Pass {
        void run(Columns c, int i, int end);
    }

    /** Until the move, the new velocity waits in the force, which is used up by then. */
    private static final Pass[] PUSHED = {
        (c, i, end) -> push(c.vx, c.decay, c.gain, c.fx, i, end),
        (c, i, end) -> push(c.vy, c.decay, c.gain, c.fy, i, end),
        (c, i, end) -> cap(c.fx, c.fy, c.cap, i, end),
        (c, i, end) -> move(c.x, c.previousX, c.before, c.vx, c.after, c.fx, i, end),
        (c, i, end) -> move(c.y, c.previousY, c.before, c.vy, c.after, c.fy, i, end)
    };

    private static final Pass[] COASTING = {
        (c, i, end) -> coast(c.x, c.previousX, c.before, c.vx, c.after, c.decay, i, end),
        (c, i, end) -> coast(c.y, c.previousY, c.before, c.vy, c.after, c.decay, i, end)
    };

    private static void run(Pass[] passes, Columns c) {
        int end = c.lanes();
        for (Pass pass : passes) pass.run(c, c.start, end);
        c.swapPositions();
    }

    private static void push(double[] v, double[] decay, double[] gain, double[] force, int i, int end) {
        for (; i < end; i++) force[i] = Kernel.velocity(decay[i], v[i], gain[i], force[i]);
    }

    private static void cap(double[] vx, double[] vy, double[] cap, int i, int end) {
        for (; i < end; i++) {
            double left = Kernel.left(vx[i], vy[i], cap[i]);
            vx[i] *= left;
            vy[i] *= left;
        }
    }

    private static void move(
            double[] x, double[] moved, double[] before, double[] v, double[] after, double[] waiting, int i, int end) {
        for (; i < end; i++) {
            double next = Kernel.rest(waiting[i]);
            moved[i] = Kernel.position(x[i], before[i], v[i], after[i], next);
            v[i] = next;
            waiting[i] = 0;
        }
    }

    private static void coast(
            double[] x, double[] moved, double[] before, double[] v, double[] after, double[] decay, int i, int end) {
        for (; i < end; i++) {
            double now = v[i], next = Kernel.rest(Kernel.velocity(decay[i], now, 0, 0));
            moved[i] = Kernel.position(x[i], before[i], now, after[i], next);
            v[i] = next;
        }
    }
}
