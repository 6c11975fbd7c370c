package yarts.physics;

/** A step of a table, tile by tile. A tile is pushed, coasting or asleep; one that is asleep costs nothing. */
final class Stepper implements Crew.Work {
    /** The fewest tiles for a thread. */
    static final int LEAST = 32;

    /** Steps between two searches for tiles in which nothing moves. */
    private static final int PATIENCE = 16;

    /** The threads that do the work; null if the calling thread does it. */
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

    /** The step of one tile. Rows are independent of one another, so it does not matter which thread does which tile. */
    @Override
    public void run(int tile) {
        Table t = table;
        if (!t.pushed[tile] && (t.asleep[tile] || (steps % PATIENCE == 0 && fallsAsleep(t, tile)))) return;
        if (t.stale[tile]) Coefficients.renewTile(t, tile);
        int start = Table.start(tile), end = t.lanes(tile);
        if (t.pushed[tile]) Passes.step(t, dt, start, end);
        else Passes.coast(t, dt, start, end);
        if (t.still[tile]) keepFrozen(t, start, end);
        t.pushed[tile] = false;
        t.asleep[tile] = false;
    }

    /** Lets a tile sleep if nothing moves. It is drawn where it is, in both arrays of positions. */
    private static boolean fallsAsleep(Table t, int tile) {
        for (int i = Table.start(tile), end = t.end(tile); i < end; i++) {
            if ((t.vx[i] != 0 || t.vy[i] != 0) && t.frozen[i] == 0) return false;
        }
        t.settleTile(tile);
        t.asleep[tile] = true;
        return true;
    }

    /** Passes move frozen units, too: this undoes it in the new positions. */
    private static void keepFrozen(Table t, int start, int end) {
        for (int i = start; i < end; i++) if (t.frozen[i] != 0) t.settle(i);
    }
}
