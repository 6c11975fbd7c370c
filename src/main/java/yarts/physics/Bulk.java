package yarts.physics;

import java.util.Objects;

/** All units of a table at once, as x0, y0, x1, y1, … in an array of the game's, in their order. */
final class Bulk {
    private Bulk() {}

    /** Between a position and the next, as far as alpha says; exactly the next one at 1. */
    static double between(double previous, double next, double alpha) {
        return alpha == 1 ? next : previous + (next - previous) * alpha;
    }

    static void copyPositions(Table table, float[] xy, int offset, double alpha) {
        check(table, xy.length, offset);
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            int j = offset + 2 * (c.origin + c.start);
            for (int i = c.start; i < c.end; i++, j += 2) {
                xy[j] = narrow(between(c.previousX[i], c.x[i], alpha));
                xy[j + 1] = narrow(between(c.previousY[i], c.y[i], alpha));
            }
        }
    }

    private static float narrow(double v) {
        return (float) Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, v));
    }

    static void copyPositions(Table table, double[] xy, int offset, double alpha) {
        check(table, xy.length, offset);
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            int j = offset + 2 * (c.origin + c.start);
            for (int i = c.start; i < c.end; i++, j += 2) {
                xy[j] = between(c.previousX[i], c.x[i], alpha);
                xy[j + 1] = between(c.previousY[i], c.y[i], alpha);
            }
        }
    }

    static void copyVelocities(Table table, double[] xy, int offset) {
        check(table, xy.length, offset);
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            int j = offset + 2 * (c.origin + c.start);
            for (int i = c.start; i < c.end; i++, j += 2) {
                xy[j] = c.vx[i];
                xy[j + 1] = c.vy[i];
            }
        }
    }

    static void applyForces(Table table, double[] xy, int offset) {
        check(table, xy.length, offset);
        int end = offset + 2 * table.size();
        for (int j = offset; j < end; j++) if (!Check.isPush(xy[j])) Check.push("xy[" + j + "]", xy[j]);
        for (int k = 0; k < table.blocks(); k++) {
            Columns c = table.block(k);
            int j = offset + 2 * (c.origin + c.start);
            for (int i = c.start; i < c.end; i++, j += 2) {
                c.fx[i] += xy[j];
                c.fy[i] += xy[j + 1];
            }
            for (int i = c.start; c.still && i < c.end; i++) if (c.frozen[i] != 0) c.clearForces(i);
            c.pushed = Columns.MANY;
        }
    }

    private static void check(Table table, int length, int offset) {
        Objects.checkFromIndexSize(offset, 2 * table.size(), length);
    }
}
