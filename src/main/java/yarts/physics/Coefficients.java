package yarts.physics;

import java.util.Arrays;

/**
 * Computes the decay, gain and lag of {@link Kernel} for a dt and an {@link Integrator}. A table keeps them from step
 * to step. A change of dt or integrator marks all tiles as stale, and a step computes stale tiles again. A change of
 * one row computes this row again.
 */
final strictfp class Coefficients {
    private Coefficients() {}

    /** Prepares for a step: marks all tiles as stale if their coefficients are for another dt or integrator. */
    static void prepare(Table t, double dt, Integrator integrator) {
        if (dt == t.dt && integrator == t.integrator) return;
        t.dt = dt;
        t.integrator = integrator;
        Arrays.fill(t.stale, true);
    }

    /** Computes a row again, after a change of its mass, friction, top speed or frozen state. */
    static void renewRow(Table t, int i) {
        if (!t.stale[Table.tile(i)]) setRow(t, i, t.dt, t.integrator);
    }

    /** Computes a row for any dt and integrator, independent of those of the table. */
    static void setRow(Table t, int i, double dt, Integrator integrator) {
        switch (integrator) {
            case EULER:
                euler(t, i, dt);
                break;
            case SEMI_IMPLICIT:
                semiImplicit(t, i, dt);
                break;
            case MIDPOINT:
                midpoint(t, i, dt);
                break;
            case EXACT:
                stiffness(t, i, dt);
                exact(t, i);
                break;
        }
        hold(t, i);
    }

    /** Computes a stale tile, in short loops without branches, which HotSpot vectorises. */
    static void renewTile(Table t, int tile) {
        int start = Table.start(tile), end = t.lanes(tile);
        double dt = t.dt;
        switch (t.integrator) {
            case EULER:
                for (int i = start; i < end; i++) euler(t, i, dt);
                break;
            case SEMI_IMPLICIT:
                for (int i = start; i < end; i++) semiImplicit(t, i, dt);
                break;
            case MIDPOINT:
                for (int i = start; i < end; i++) midpoint(t, i, dt);
                break;
            case EXACT:
                for (int i = start; i < end; i++) stiffness(t, i, dt);
                if (allSmall(t, start, end)) {
                    for (int i = start; i < end; i++) small(t, i);
                    for (int i = start; i < end; i++) t.lag[i] = Exponential.lag(t.lag[i]);
                } else {
                    for (int i = start; i < end; i++) exact(t, i);
                }
                break;
        }
        if (t.still[tile]) for (int i = start; i < end; i++) hold(t, i);
        t.stale[tile] = false;
    }

    /**
     * Lets a frozen unit keep its velocity, and lets no force accelerate it or a unit with a top speed of 0. The cap
     * alone would let a velocity pass whose square underflows.
     */
    private static void hold(Table t, int i) {
        if (t.frozen[i] != 0) t.decay[i] = 1;
        if (t.frozen[i] != 0 || t.maxSpeed[i] == 0) t.gain[i] = 0;
    }

    private static void euler(Table t, int i, double dt) {
        double h = dt / t.mass[i], z = t.friction[i] * h;
        t.decay[i] = Math.max(0, 1 - z);
        t.gain[i] = h / Math.max(1, z);
        t.lag[i] = 1;
    }

    private static void semiImplicit(Table t, int i, double dt) {
        double h = dt / t.mass[i], z = t.friction[i] * h;
        t.decay[i] = 1 / (1 + z);
        t.gain[i] = h / (1 + z);
        t.lag[i] = 0;
    }

    private static void midpoint(Table t, int i, double dt) {
        double h = dt / t.mass[i], half = t.friction[i] * h / 2;
        t.decay[i] = Math.max(0, (1 - half) / (1 + half));
        t.gain[i] = h / Math.max(1 + half, 2 * half);
        t.lag[i] = 0.5;
    }

    /** The first part of EXACT: stores dt/m as the gain, and z in the column of the lag. */
    private static void stiffness(Table t, int i, double dt) {
        t.gain[i] = dt / t.mass[i];
        t.lag[i] = t.friction[i] * t.gain[i];
    }

    private static boolean allSmall(Table t, int start, int end) {
        for (int i = start; i < end; i++) if (t.lag[i] >= Exponential.SMALL) return false;
        return true;
    }

    /** The second part of EXACT, for z below SMALL, without the lag. */
    private static void small(Table t, int i) {
        double z = t.lag[i], gain = Exponential.gain(z);
        t.decay[i] = 1 - z * gain;
        t.gain[i] *= gain;
    }

    /**
     * The second part of EXACT, for any z. Below SMALL, the result is the same to the bit as in the vectorised loops.
     */
    private static void exact(Table t, int i) {
        double z = t.lag[i];
        if (z < Exponential.SMALL) {
            small(t, i);
        } else {
            t.decay[i] = Exponential.decay(z);
            t.gain[i] = (1 - t.decay[i]) / z * t.gain[i];
        }
        t.lag[i] = Exponential.lag(z, t.decay[i]);
    }
}
