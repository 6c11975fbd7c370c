package yarts.physics;

/**
 * Reads all units of a table or applies forces to them, by an array of the game: x0, y0, x1, y1, … in the order of the
 * rows.
 */
final strictfp class Bulk {
    private Bulk() {}

    /** The position at a fraction alpha of the step, from the previous one (0) to the next one (1, exactly). */
    static double between(double previous, double next, double alpha) {
        return alpha == 1 ? next : previous + (next - previous) * alpha;
    }

    static void copyPositions(Table t, float[] xy, int offset, double alpha) {
        check(t, xy.length, offset);
        for (int i = 0, j = offset; i < t.size; i++, j += 2) {
            xy[j] = narrow(between(t.previousX[i], t.x[i], alpha));
            xy[j + 1] = narrow(between(t.previousY[i], t.y[i], alpha));
        }
    }

    private static float narrow(double v) {
        return (float) Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, v));
    }

    static void copyPositions(Table t, double[] xy, int offset, double alpha) {
        check(t, xy.length, offset);
        for (int i = 0, j = offset; i < t.size; i++, j += 2) {
            xy[j] = between(t.previousX[i], t.x[i], alpha);
            xy[j + 1] = between(t.previousY[i], t.y[i], alpha);
        }
    }

    static void copyVelocities(Table t, double[] xy, int offset) {
        check(t, xy.length, offset);
        for (int i = 0, j = offset; i < t.size; i++, j += 2) {
            xy[j] = t.vx[i];
            xy[j + 1] = t.vy[i];
        }
    }

    static void applyForces(Table t, double[] xy, int offset) {
        check(t, xy.length, offset);
        int end = offset + 2 * t.size;
        for (int j = offset; j < end; j++) if (!Check.isPush(xy[j])) Check.push("xy[" + j + "]", xy[j]);
        for (int k = 0; k < t.tiles(); k++) {
            add(t.fx, t.fy, xy, offset, Table.start(k), t.end(k));
            t.pushed[k] = true;
        }
    }

    private static void add(double[] fx, double[] fy, double[] xy, int offset, int start, int end) {
        for (int i = start; i < end; i++) {
            fx[i] += xy[offset + 2 * i];
            fy[i] += xy[offset + 2 * i + 1];
        }
    }

    private static void check(Table t, int length, int offset) {
        int needed = 2 * t.size;
        if (offset < 0 || offset > length - needed) {
            throw new IndexOutOfBoundsException("xy must have 2 elements for each of " + t.size + " units, " + needed
                    + " from offset " + offset + ", but its length is " + length);
        }
    }
}
