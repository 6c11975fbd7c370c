package yarts.physics;

/** A step of a table, block by block, each in its own way: pushed, coasting, or asleep, which costs nothing. */
final class Stepper implements Crew.Work {
    /** Fewer blocks are done sooner than a thread wakes. */
    static final int LEAST = 32;

    /** Who does the blocks' work; null if the caller's thread does. */
    Crew crew;

    private final Coefficients coefficients = new Coefficients();
    private Table table;

    void step(Table table, double dt, Integrator integrator) {
        this.table = table;
        coefficients.set(table.size(), dt, integrator);
        if (crew == null) run(0, table.blocks());
        else crew.share(this, table.blocks());
    }

    /** The step of some blocks. Rows do not depend on one another, so it does not matter which thread does which. */
    @Override
    public void run(int start, int end) {
        for (int k = start; k < end; k++) step(table.block(k));
    }

    private void step(Columns c) {
        if (c.pushed == Columns.NONE) {
            if (c.asleep) return;
            if (!moves(c)) {
                c.settle();
                c.asleep = true;
                return;
            }
        }
        coefficients.renew(c);
        if (c.pushed == Columns.NONE) Passes.coast(c);
        else if (c.pushed == Columns.MANY) Passes.step(c);
        else stepOne(c, c.pushed);
        c.pushed = Columns.NONE;
        c.asleep = false;
    }

    /** A row that is pushed alone steps alone. The others coast, and leave no trace on it. */
    private static void stepOne(Columns c, int i) {
        Kernel.step(c, i);
        double x = c.x[i], y = c.y[i], vx = c.vx[i], vy = c.vy[i];
        double previousX = c.previousX[i], previousY = c.previousY[i];
        Passes.coast(c);
        c.x[i] = x;
        c.y[i] = y;
        c.vx[i] = vx;
        c.vy[i] = vy;
        c.previousX[i] = previousX;
        c.previousY[i] = previousY;
    }

    private static boolean moves(Columns c) {
        if (moves(c, c.mover)) return true;
        for (int i = c.start; i < c.end; i++) {
            if (moves(c, i)) {
                c.mover = i;
                return true;
            }
        }
        return false;
    }

    private static boolean moves(Columns c, int i) {
        return i < c.end && (c.vx[i] != 0 || c.vy[i] != 0) && c.frozen[i] == 0;
    }
}
