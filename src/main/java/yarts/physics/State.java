package yarts.physics;

/**
 * Everything that the future steps of a world and the interpolated positions depend on. Hash, save and restore cover
 * exactly this. A {@link World} has one state, and a {@link Snapshot} has another.
 */
final strictfp class State {
    Table table = new Table(0);
    final Clock clock;
    Integrator integrator;
    /** The last id that was given to a unit. */
    long lastId;
    /**
     * The last id that was given to a unit before the last step. Units with higher ids did not take part in this step.
     */
    long lastSteppedId;
    /**
     * Whether advance with fixed steps has run the last step. If so, and if the timestep is still fixed, units are drawn
     * at the alpha of the clock.
     */
    boolean interpolating;

    State(Integrator integrator, Timestep timestep) {
        this.integrator = integrator;
        clock = new Clock(timestep);
    }

    /** Copies another state, outside of any step. If memory runs out, this state is unchanged. */
    void copy(State other) {
        table.copy(other.table);
        clock.copy(other.clock);
        integrator = other.integrator;
        lastId = other.lastId;
        lastSteppedId = other.lastSteppedId;
        interpolating = other.interpolating;
    }

    /**
     * A hash of the whole state. A change of a single bit always changes it, because each round can be inverted. A
     * column of zeros contributes 0, so it can be omitted.
     */
    long hash() {
        long h = Clock.mix(Clock.mix(clock.hash(integrator.code), lastId), lastSteppedId);
        h = Clock.mix(Clock.mix(h, table.size), interpolating ? 1 : 0);
        for (int k = 0; k < table.tiles(); k++) h = hash(h, table, k);
        return h;
    }

    private static long hash(long h, Table t, int k) {
        boolean still = t.still[k], motored = t.motored[k];
        boolean pushed = t.pushed[k], pending = t.pending[k], waiting = t.waiting[k];
        for (int i = Table.start(k), end = t.end(k); i < end; i++) {
            long row = t.id[i] * 3 + mix(t.x[i]) * 5 + mix(t.y[i]) * 7 + mix(t.vx[i]) * 11 + mix(t.vy[i]) * 13;
            row += mix(t.mass[i]) * 17 + mix(t.friction[i]) * 19 + mix(t.maxSpeed[i]) * 23;
            row += mix(t.previousX[i]) * 29 + mix(t.previousY[i]) * 31;
            if (still) row += mix(t.frozen[i]) * 37;
            if (pushed) row += mix(t.fx[i]) * 41 + mix(t.fy[i]) * 43;
            if (pending) row += mix(t.pendingX[i]) * 47 + mix(t.pendingY[i]) * 53;
            if (motored) row += mix(t.motorVx[i]) * 67 + mix(t.motorVy[i]) * 71 + mix(t.motorForce[i]) * 73;
            if (waiting) row += mix(t.waitingX[i]) * 59 + mix(t.waitingY[i]) * 61;
            h = Clock.mix(h, row);
        }
        return h;
    }

    private static long mix(double v) {
        long bits = Double.doubleToRawLongBits(v + 0.0) * 0x9E3779B97F4A7C15L; // -0.0 is 0.0
        bits = (bits ^ (bits >>> 32)) * 0x9E3779B97F4A7C15L; // again, because numbers with few digits have few bits
        return bits ^ (bits >>> 32);
    }
}
