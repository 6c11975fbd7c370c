package yarts.physics;

/**
 * A step of the rows of a tile, as a series of passes: short loops, each with a part of {@link Kernel}'s formula.
 *
 * <p>The passes have this form because of HotSpot:
 *
 * <ul>
 *   <li>It vectorises a loop only if the loop is short (60 nodes of its graph) and has no branch. So there are several
 *       loops, over a tile that stays in the cache from pass to pass.
 *   <li>It does not vectorise a loop that it has seen end after a few iterations, even if later runs are long. So loops
 *       cover a multiple of {@link Table#LANES} rows.
 *   <li>It does not vectorise all loops of a method with many loops, such as a step that was inlined into a game's
 *       loop. It does not inline a call with many implementations, however. So each pass is an object behind an
 *       interface, and is compiled on its own.
 * </ul>
 */
final strictfp class Passes {
    private Passes() {}

    /** A part of a step, for the rows from start (inclusive) to end (exclusive). */
    private interface Pass {
        void run(Table t, double dt, int start, int end);
    }

    /**
     * Forces and friction, speed cap, position. The force column contains the new velocity until the last passes. The
     * new positions replace the previous ones; the two columns are swapped when all tiles are done.
     */
    private static final Pass[] PUSHED = {
        (t, dt, start, end) -> push(t.vx, t.decay, t.gain, t.fx, start, end),
        (t, dt, start, end) -> push(t.vy, t.decay, t.gain, t.fy, start, end),
        (t, dt, start, end) -> cap(t.fx, t.fy, t.cap, start, end),
        (t, dt, start, end) -> move(t.x, t.previousX, dt, t.lag, t.vx, t.fx, start, end),
        (t, dt, start, end) -> move(t.y, t.previousY, dt, t.lag, t.vy, t.fy, start, end)
    };

    /** The same with motors. The column of the previous position contains their reach until the last passes. */
    private static final Pass[] MOTORED = {
        PUSHED[0],
        PUSHED[1],
        (t, dt, start, end) -> reach(t.gain, t.motorForce, t.previousX, start, end),
        (t, dt, start, end) -> motor(t.fx, t.fy, t.motorVx, t.motorVy, t.previousX, start, end),
        PUSHED[2],
        PUSHED[3],
        PUSHED[4]
    };

    /** No forces: no unit becomes faster, so the speed cap is not needed. */
    private static final Pass[] COASTING = {
        (t, dt, start, end) -> coast(t.x, t.previousX, dt, t.lag, t.vx, t.decay, start, end),
        (t, dt, start, end) -> coast(t.y, t.previousY, dt, t.lag, t.vy, t.decay, start, end)
    };

    /** Steps the rows of a tile with the fewest passes that give the same result, to the bit. */
    static void step(Table t, double dt, int tile) {
        int start = Table.start(tile), end = t.lanes(tile);
        if (t.motored[tile]) for (Pass pass : MOTORED) pass.run(t, dt, start, end);
        else if (t.pushed[tile]) for (Pass pass : PUSHED) pass.run(t, dt, start, end);
        else for (Pass pass : COASTING) pass.run(t, dt, start, end);
    }

    private static void push(double[] v, double[] decay, double[] gain, double[] force, int start, int end) {
        for (int i = start; i < end; i++) force[i] = Kernel.velocity(decay[i], v[i], gain[i], force[i]);
    }

    private static void reach(double[] gain, double[] force, double[] reach, int start, int end) {
        for (int i = start; i < end; i++) reach[i] = Kernel.reach(gain[i], force[i]);
    }

    private static void motor(double[] vx, double[] vy, double[] ux, double[] uy, double[] reach, int start, int end) {
        for (int i = start; i < end; i++) {
            double k = Kernel.share(vx[i], vy[i], ux[i], uy[i], reach[i]);
            vx[i] = Kernel.blend(vx[i], ux[i], k);
            vy[i] = Kernel.blend(vy[i], uy[i], k);
        }
    }

    private static void cap(double[] vx, double[] vy, double[] cap, int start, int end) {
        for (int i = start; i < end; i++) {
            double left = Kernel.left(vx[i], vy[i], cap[i]);
            vx[i] *= left;
            vy[i] *= left;
        }
    }

    private static void move(
            double[] x, double[] moved, double dt, double[] lag, double[] v, double[] capped, int start, int end) {
        for (int i = start; i < end; i++) {
            double next = Kernel.rest(capped[i]);
            moved[i] = Kernel.position(x[i], dt, lag[i], v[i], next);
            v[i] = next;
            capped[i] = 0;
        }
    }

    private static void coast(
            double[] x, double[] moved, double dt, double[] lag, double[] v, double[] decay, int start, int end) {
        for (int i = start; i < end; i++) {
            double now = v[i], next = Kernel.rest(decay[i] * now);
            moved[i] = Kernel.position(x[i], dt, lag[i], now, next);
            v[i] = next;
        }
    }
}
