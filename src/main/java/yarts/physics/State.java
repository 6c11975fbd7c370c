package yarts.physics;

/**
 * All that a world's future depends on, and where its units are drawn: what a hash, a save and a restore are about. There
 * is one in a {@link World} and one in a {@link Snapshot}.
 */
final class State {
    final Table table = new Table();
    final Clock clock;
    Integrator integrator;
    /** How many units were ever added. */
    long lastId;
    /** Whether the last step is one to interpolate over as far as the clock's remainder goes. */
    boolean interpolating;

    State(Integrator integrator, Timestep timestep) {
        this.integrator = integrator;
        clock = new Clock(timestep);
    }

    /** Becomes what another is; without the frame that is in hand, if one is. */
    void set(State other) {
        table.copy(other.table);
        clock.set(other.clock);
        integrator = other.integrator;
        lastId = other.lastId;
        interpolating = other.interpolating;
    }

    /**
     * A hash of all this. The change of a single bit always shows, since each step can be undone; and a column of zeros
     * adds nothing, so that it can be left out.
     */
    long hash() {
        long h = Clock.mix(clock.hash(integrator.ordinal()), lastId);
        h = Clock.mix(Clock.mix(h, table.size()), interpolating ? 1 : 0);
        for (int k = 0; k < table.blocks(); k++) h = hash(h, table.block(k));
        return h;
    }

    private static long hash(long h, Columns c) {
        for (int i = c.start; i < c.end; i++) {
            long row = c.id[i] * 3 + mix(c.x[i]) * 5 + mix(c.y[i]) * 7 + mix(c.vx[i]) * 11 + mix(c.vy[i]) * 13;
            row += mix(c.mass[i]) * 17 + mix(c.friction[i]) * 19 + mix(c.maxSpeed[i]) * 23;
            row += mix(c.previousX[i]) * 29 + mix(c.previousY[i]) * 31;
            if (c.still) row += mix(c.frozen[i]) * 37;
            if (c.pushed != Columns.NONE) row += mix(c.fx[i]) * 41 + mix(c.fy[i]) * 43;
            if (c.pending != Columns.NONE) row += mix(c.pendingX[i]) * 47 + mix(c.pendingY[i]) * 53;
            h = Clock.mix(h, row);
        }
        return h;
    }

    private static long mix(double v) {
        long bits = Double.doubleToRawLongBits(v + 0.0) * 0x9E3779B97F4A7C15L; // -0.0 is 0.0
        bits = (bits ^ (bits >>> 32)) * 0x9E3779B97F4A7C15L; // and again: numbers of few digits have few bits
        return bits ^ (bits >>> 32);
    }
}
