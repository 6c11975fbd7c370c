package yarts.physics;

import java.util.Arrays;

/** Works out what {@link Kernel} takes: the coefficients of rows, for a dt and an {@link Integrator}. */
final class Coefficients {
    private double dt = -1;
    private Integrator integrator;
    /** The shares of every row, where they do not depend on the row: the same arrays for all blocks stay in the cache. */
    private final double[] before = new double[Columns.SHARED], after = new double[Columns.SHARED];

    private int rows;

    /** What follows is to be for a table of so many rows, a dt and an integrator. */
    void set(int size, double dt, Integrator integrator) {
        int wanted = Math.min(Columns.lanes(size), Columns.SHARED);
        if (dt == this.dt && integrator == this.integrator && wanted <= rows) return;
        this.dt = dt;
        this.integrator = integrator;
        rows = wanted;
        Arrays.fill(before, 0, rows, integrator == Integrator.MIDPOINT ? dt / 2 : dt);
        Arrays.fill(after, 0, rows, integrator == Integrator.MIDPOINT ? dt / 2 : 0);
    }

    /** Those of all rows of a block, unless it has them. */
    void renew(Columns c) {
        if (c.dt == dt && c.integrator == integrator.ordinal()) return;
        int start = c.start, end = c.lanes();
        c.own();
        switch (integrator) {
            case EULER:
                for (int i = start; i < end; i++) euler(c, i, dt);
                break;
            case MIDPOINT:
                for (int i = start; i < end; i++) midpoint(c, i, dt);
                break;
            case EXACT:
                for (int i = start; i < end; i++) stiffness(c, i, dt);
                if (allSmall(c)) {
                    for (int i = start; i < end; i++) small(c, i);
                    for (int i = start; i < end; i++) share(c, i, dt, Exponential.lag(c.after[i]));
                } else {
                    for (int i = start; i < end; i++) exact(c, i, dt);
                }
                break;
        }
        if (integrator != Integrator.EXACT) {
            if (c.still) {
                System.arraycopy(before, start, c.before, start, end - start);
                System.arraycopy(after, start, c.after, start, end - start);
            } else {
                c.before = before;
                c.after = after;
            }
        }
        if (c.dt < 0) for (int i = start; i < end; i++) c.cap[i] = Kernel.cap(c.maxSpeed[i]);
        for (int i = start; c.still && i < end; i++) still(c, i);
        c.dt = dt;
        c.integrator = integrator.ordinal();
    }

    /** Those of one row, whatever the rest of the block has. */
    static void renew(Columns c, int i, double dt, Integrator integrator) {
        c.own();
        switch (integrator) {
            case EULER:
                euler(c, i, dt);
                c.before[i] = dt;
                c.after[i] = 0;
                break;
            case MIDPOINT:
                midpoint(c, i, dt);
                c.before[i] = c.after[i] = dt / 2;
                break;
            case EXACT:
                stiffness(c, i, dt);
                exact(c, i, dt);
                break;
        }
        c.cap[i] = Kernel.cap(c.maxSpeed[i]);
        still(c, i);
        c.renew();
    }

    private static void euler(Columns c, int i, double dt) {
        double h = dt / c.mass[i], z = c.friction[i] * h;
        c.decay[i] = Math.max(0, 1 - z);
        c.gain[i] = h / Math.max(1, z);
    }

    private static void midpoint(Columns c, int i, double dt) {
        double h = dt / c.mass[i], half = c.friction[i] * h / 2;
        c.decay[i] = Math.max(0, (1 - half) / (1 + half));
        c.gain[i] = h / Math.max(1 + half, 2 * half);
    }

    /** The first part of EXACT: dt/m, and z in place of a share. */
    private static void stiffness(Columns c, int i, double dt) {
        c.gain[i] = dt / c.mass[i];
        c.after[i] = c.friction[i] * c.gain[i];
    }

    private static boolean allSmall(Columns c) {
        for (int i = c.start; i < c.end; i++) if (c.after[i] >= Exponential.SMALL) return false;
        return true;
    }

    private static void small(Columns c, int i) {
        double z = c.after[i], gain = Exponential.gain(z);
        c.decay[i] = 1 - z * gain;
        c.gain[i] *= gain;
    }

    /** The second part of EXACT: by the same arithmetic as where all are small, or for larger z by exp. */
    private static void exact(Columns c, int i, double dt) {
        double z = c.after[i];
        if (z < Exponential.SMALL) {
            small(c, i);
        } else {
            c.decay[i] = Exponential.decay(z);
            c.gain[i] = (1 - c.decay[i]) / z * c.gain[i]; // in the order that Kernel asks for
        }
        share(c, i, dt, Exponential.lag(z, c.decay[i]));
    }

    private static void share(Columns c, int i, double dt, double lag) {
        c.before[i] = dt * lag;
        c.after[i] = dt * (1 - lag);
    }

    /** A frozen unit keeps its velocity and its place; one with a top speed below rest has no velocity. */
    private static void still(Columns c, int i) {
        if (c.frozen[i] != 0) {
            c.decay[i] = 1;
            c.gain[i] = c.before[i] = c.after[i] = 0;
        } else if (c.maxSpeed[i] < Kernel.REST) {
            c.decay[i] = c.gain[i] = 0;
        }
    }
}
