package yarts.physics;

import java.util.Arrays;

/**
 * Distributes forces over frames and steps. There are three kinds of forces:
 *
 * <ul>
 *   <li>A force F that is applied between two calls acts for the elapsed time of the next call. The part of its impulse
 *       that belongs to time not yet covered by a step is pending.
 *   <li>A force that is applied in a before-step listener acts for the step that is about to run.
 *   <li>A force that is applied in an after-step listener acts for the next step. After the last step of a call, it
 *       waits for the next call.
 * </ul>
 *
 * <p>All are added to the force column f. A call that runs steps begins with f := share + waiting, where the share is
 * the force that the frame's impulse exerts in each step, and ends with waiting := f. A step uses f and clears it.
 */
final strictfp class Impulses {
    private Impulses() {}

    /** Ends a frame without a step: the forces of {@code elapsed} seconds become pending impulses. */
    static void hold(Table t, double elapsed) {
        for (int k = 0; k < t.tiles(); k++) {
            if (!t.pushed[k]) continue;
            hold(t.pendingX, t.fx, Table.start(k), t.lanes(k), elapsed);
            hold(t.pendingY, t.fy, Table.start(k), t.lanes(k), elapsed);
            t.pending[k] = true;
            t.pushed[k] = false;
        }
    }

    private static void hold(double[] pending, double[] f, int start, int end, double elapsed) {
        for (int i = start; i < end; i++) {
            pending[i] += f[i] * elapsed;
            f[i] = 0;
        }
    }

    /**
     * Begins a frame whose steps cover {@code covered} seconds. The waiting time was {@code before} seconds and is now
     * {@code after} seconds, so the forces F of this frame acted for covered − before + after. If more time waited than
     * the steps cover, {@code old} seconds of it remain, and the same fraction of the pending impulse P:
     *
     * <pre>{@code
     * old   = max(0, before − covered)
     * share = (P (1 − old/before) + F (covered − before + old)) / covered
     * P     = P old/before + F (after − old)
     * }</pre>
     *
     * The share is computed as F + (P (1 − old/before) − F (before − old)) / covered, so that it is exactly F without
     * waiting time, and if the waiting time is that of one frame with the same force. Variable steps that cover less
     * than a nanosecond do not change P.
     *
     * @param kept old/before, the fraction of P that stays pending
     * @param used before − old, the seconds of the waiting time that the steps cover
     * @param later after − old, the seconds of this frame that the steps do not cover
     * @param repeated whether there is more than one step
     */
    static void begin(Table t, double kept, double used, double later, double covered, boolean repeated) {
        double perSecond = 1 / covered;
        if (covered < 1e-9) { // 1 / covered may be infinite
            kept = 1;
            used = later = perSecond = 0;
        }
        for (int k = 0; k < t.tiles(); k++) {
            if (!t.pushed[k] && !t.pending[k]) continue;
            int start = Table.start(k), end = t.lanes(k);
            spread(t.pendingX, t.fx, start, end, kept, used, later, perSecond);
            spread(t.pendingY, t.fy, start, end, kept, used, later, perSecond);
            t.pending[k] = later > 0 || kept > 0;
            t.pushed[k] = true;
            if (!repeated) continue;
            System.arraycopy(t.fx, start, t.frameX, start, end - start);
            System.arraycopy(t.fy, start, t.frameY, start, end - start);
            t.framed[k] = true;
        }
        useWaiting(t);
    }

    private static void spread(
            double[] pending,
            double[] f,
            int start,
            int end,
            double kept,
            double used,
            double later,
            double perSecond) {
        for (int i = start; i < end; i++) {
            double force = f[i], impulse = pending[i];
            f[i] = force + (impulse * (1 - kept) - force * used) * perSecond;
            pending[i] = impulse * kept + force * later;
        }
    }

    /** Adds the waiting forces to those of the next step. */
    static void useWaiting(Table t) {
        for (int k = 0; k < t.tiles(); k++) {
            if (!t.waiting[k]) continue;
            int start = Table.start(k), end = t.lanes(k);
            add(t.fx, t.waitingX, start, end);
            add(t.fy, t.waitingY, start, end);
            Arrays.fill(t.waitingX, start, end, 0);
            Arrays.fill(t.waitingY, start, end, 0);
            t.waiting[k] = false;
            t.pushed[k] = true;
        }
    }

    /** Adds the frame's forces to those of its next step. */
    static void repeat(Table t) {
        for (int k = 0; k < t.tiles(); k++) {
            if (!t.framed[k]) continue;
            add(t.fx, t.frameX, Table.start(k), t.lanes(k));
            add(t.fy, t.frameY, Table.start(k), t.lanes(k));
            t.pushed[k] = true;
        }
    }

    private static void add(double[] f, double[] more, int start, int end) {
        for (int i = start; i < end; i++) f[i] += more[i];
    }

    /** Ends a call that had steps to run: forces that were applied after the last step wait for the next call. */
    static void end(Table t) {
        for (int k = 0; k < t.tiles(); k++) {
            int start = Table.start(k), end = t.lanes(k);
            if (t.framed[k]) {
                Arrays.fill(t.frameX, start, end, 0);
                Arrays.fill(t.frameY, start, end, 0);
                t.framed[k] = false;
            }
            if (!t.pushed[k]) continue;
            System.arraycopy(t.fx, start, t.waitingX, start, end - start);
            System.arraycopy(t.fy, start, t.waitingY, start, end - start);
            t.waiting[k] = true;
            discard(t, k);
        }
    }

    /** Discards the forces for the next step. */
    static void discard(Table t) {
        for (int k = 0; k < t.tiles(); k++) if (t.pushed[k]) discard(t, k);
    }

    private static void discard(Table t, int k) {
        Arrays.fill(t.fx, Table.start(k), t.lanes(k), 0);
        Arrays.fill(t.fy, Table.start(k), t.lanes(k), 0);
        t.pushed[k] = false;
    }
}
