package yarts.physics;

/** Steps a table, tile by tile. A tile has forces or motors, coasts, or is asleep; a sleeping tile is skipped. */
final class Stepper implements Crew.Work {
    /** The minimum number of tiles for a thread. */
    static final int MIN_TILES = 32;

    /** The number of steps between two searches for tiles without motion or without motors. */
    private static final int SEARCH_INTERVAL = 16;

    /** The threads that share the work; null if the calling thread does it alone. */
    Crew crew;

    private Table table;
    private double dt;
    private int steps;

    void step(Table table, double dt, Integrator integrator) {
        this.table = table;
        this.dt = dt;
        steps++;
        Coefficients.prepare(table, dt, integrator);
        int tiles = table.tiles();
        if (crew != null) crew.share(this, tiles);
        else for (int k = 0; k < tiles; k++) run(k);
        table.swapPositions();
    }

    /** Steps one tile. Rows do not depend on one another, so any thread can step any tile. */
    @Override
    public void run(int tile) {
        Table t = table;
        boolean pushed = t.pushed[tile];
        if (!pushed && t.asleep[tile]) return;
        if (steps % SEARCH_INTERVAL == 0) {
            if (t.motored[tile]) t.motored[tile] = hasMotors(t, tile);
            if (!pushed && fallsAsleep(t, tile)) return;
        }
        if (t.stale[tile]) Coefficients.renewTile(t, tile);
        Passes.step(t, dt, tile);
        if (t.still[tile]) keepFrozen(t, tile);
        t.pushed[tile] = false;
        t.asleep[tile] = false;
    }

    private static boolean hasMotors(Table t, int tile) {
        for (int i = Table.start(tile), end = t.end(tile); i < end; i++) if (t.hasMotor(i)) return true;
        return false;
    }

    /**
     * Lets a tile sleep if no row moves and no motor would move one. Makes its previous positions equal to its
     * positions.
     */
    private static boolean fallsAsleep(Table t, int tile) {
        for (int i = Table.start(tile), end = t.end(tile); i < end; i++) {
            if (t.frozen[i] == 0 && (moves(t, i) || drives(t, i))) return false;
        }
        t.settleTile(tile);
        t.asleep[tile] = true;
        return true;
    }

    private static boolean moves(Table t, int i) {
        return t.vx[i] != 0 || t.vy[i] != 0;
    }

    private static boolean drives(Table t, int i) {
        return t.motorForce[i] > 0 && (t.motorVx[i] != 0 || t.motorVy[i] != 0) && t.maxSpeed[i] > 0;
    }

    /** Restores the positions of frozen units, because the passes have moved them, too. */
    private static void keepFrozen(Table t, int tile) {
        for (int i = Table.start(tile), end = t.end(tile); i < end; i++) if (t.frozen[i] != 0) t.settle(i);
    }
}
