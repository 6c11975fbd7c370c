package yarts.physics;

/** A step of a table, tile by tile. A tile is pushed, coasting or asleep; one that is asleep costs nothing. */
final class Stepper implements Crew.Work {
    /** The fewest tiles for a thread. */
    static final int LEAST = 32;

    /** Steps between two searches for tiles in which nothing moves, or without motors. */
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
        boolean pushed = t.pushed[tile];
        if (!pushed && t.asleep[tile]) return;
        if (steps % PATIENCE == 0) {
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

    /** Lets a tile sleep if nothing moves or has a motor that would move it. Both arrays of positions must be equal then. */
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

    /** Passes move frozen units, too: this undoes it in the new positions. */
    private static void keepFrozen(Table t, int tile) {
        for (int i = Table.start(tile), end = t.end(tile); i < end; i++) if (t.frozen[i] != 0) t.settle(i);
    }
}
