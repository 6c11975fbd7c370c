package yarts.physics;

import java.util.Arrays;

/**
 * How forces act over frames and ticks. A force F that is applied once a frame acts for the time that the frame takes.
 * The part of its impulse that falls in the clock's remainder, which no step has covered yet, is pending.
 */
final class Impulses {
    private Impulses() {}

    /** A frame in which no step fell due, and which left the remainder longer by {@code elapsed} seconds. */
    static void hold(Table table, double elapsed) {
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            if (c.pushed == Columns.NONE) continue;
            hold(c.pendingX, c.fx, c.start, c.lanes(), elapsed);
            hold(c.pendingY, c.fy, c.start, c.lanes(), elapsed);
            c.pending = Columns.join(c.pending, c.pushed);
            c.pushed = Columns.NONE;
        }
    }

    private static void hold(double[] pending, double[] f, int i, int end, double elapsed) {
        for (; i < end; i++) {
            pending[i] += f[i] * elapsed;
            f[i] = 0;
        }
    }

    /**
     * A frame whose steps cover {@code covered} seconds. The remainder was {@code before} and is {@code after}, so the
     * forces F of this frame acted for covered − before + after. Of their impulse F·after is for later; the rest, with
     * what is pending, is spread evenly over the steps: (pending + F (covered − before)) / covered, written so that a
     * constant force is passed on to the bit.
     *
     * @param repeated whether there is more than one step
     */
    static void spread(Table table, double before, double after, double covered, boolean repeated) {
        double perSecond = 1 / Math.max(covered, 1e-9); // less, of variable steps only, would overflow
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            int pushed = Columns.join(c.pushed, c.pending);
            if (pushed == Columns.NONE) continue;
            int start = c.start, end = c.lanes();
            spread(c.pendingX, c.fx, start, end, before, after, perSecond);
            spread(c.pendingY, c.fy, start, end, before, after, perSecond);
            c.pending = after > 0 ? c.pushed : Columns.NONE;
            c.pushed = pushed;
            if (!repeated) continue;
            c.framed = pushed;
            System.arraycopy(c.fx, start, c.frameX, start, end - start);
            System.arraycopy(c.fy, start, c.frameY, start, end - start);
        }
    }

    private static void spread(
            double[] pending, double[] f, int i, int end, double before, double after, double perSecond) {
        for (; i < end; i++) {
            double force = f[i];
            f[i] = force + (pending[i] - force * before) * perSecond;
            pending[i] = force * after;
        }
    }

    /** The frame's forces act in its next step, too. */
    static void repeat(Table table) {
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            if (c.framed == Columns.NONE) continue;
            add(c.fx, c.frameX, c.start, c.lanes());
            add(c.fy, c.frameY, c.start, c.lanes());
            c.pushed = Columns.join(c.pushed, c.framed);
        }
    }

    private static void add(double[] f, double[] frame, int i, int end) {
        for (; i < end; i++) f[i] += frame[i];
    }

    /** The frame's last step is over, or will not come. */
    static void endFrame(Table table) {
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            if (c.framed == Columns.NONE) continue;
            Arrays.fill(c.frameX, c.start, c.lanes(), 0);
            Arrays.fill(c.frameY, c.start, c.lanes(), 0);
            c.framed = Columns.NONE;
        }
    }

    /** Drops the forces for the next step. */
    static void drop(Table table) {
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            if (c.pushed == Columns.NONE) continue;
            Arrays.fill(c.fx, c.start, c.end, 0);
            Arrays.fill(c.fy, c.start, c.end, 0);
            c.pushed = Columns.NONE;
        }
    }

    /** The remainder's length is another: what is pending was, and is to be, of the same forces. */
    static void scale(Table table, double factor) {
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            for (int i = c.start; i < c.end; i++) {
                c.pendingX[i] = c.pendingX[i] * factor + 0.0; // 0 rather than −0.0
                c.pendingY[i] = c.pendingY[i] * factor + 0.0;
            }
        }
    }
}
