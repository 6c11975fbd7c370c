package yarts.physics;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/**
 * A table of units: a row a unit, an array a quantity. A world has one table for all its units. Units outside a world
 * share small tables, {@link #NURSERY} rows each: making a unit takes a row and no arrays, and a table goes when the
 * last of its units does. Rows share nothing but the flags, which are constant there, so threads do not disturb each
 * other's units.
 *
 * <p>Whenever {@link #how} is set, the coefficients of every row in use are those of (mass, friction, {@link #dt},
 * how).
 */
final class Columns {
    private static final int COUNT = 19;

    private static final int NURSERY = 32;
    private static final AtomicReference<Columns> nursery = new AtomicReference<>(new Columns(null, NURSERY));

    /** Relative; twice the rounding errors that the speed cap and Unit.getSpeed make. */
    private static final double MARGIN = 0x1p-49;

    /** The cap where there is none. */
    static final double TOP = Kernel.FASTEST * (1 - MARGIN);

    /** The world whose table this is, or null. */
    final World world;

    double[] x, y, vx, vy;
    /** The force for the next step. */
    double[] fx, fy;
    /** The force that a frame gives to each of its steps; valid while World.advance runs them. */
    double[] frameX, frameY;
    /** The impulse of forces that acted during the clock's remainder, which no step has covered yet. */
    double[] carryX, carryY;
    /** The position before the last step, to interpolate from. */
    double[] previousX, previousY;

    double[] mass, friction, maxSpeed;
    /** The maxSpeed less {@link #MARGIN}, and never 0 nor infinite, to spare the kernel branches. */
    double[] cap;
    /** The coefficients of a step: decay(z), gain(z) dt/m and 1 − weight(z), as in {@link Integrator}. */
    double[] decay, gain, lag;

    /** Whether any row may have a force for the next step; if not, fx and fy are 0 throughout. */
    boolean forced;
    /** Whether any row may have an impulse carried; if not, carryX and carryY are 0 throughout. */
    private boolean carried;
    /** Whether the frame in hand has forces; if not, frameX and frameY mean nothing. */
    private boolean framed;
    /** Whether any row may have a maxSpeed below rest. */
    private boolean pinned;
    /** For the kernel to work in. */
    final double[] scratch;

    /** How many rows of a nursery are taken. */
    private final AtomicInteger taken = new AtomicInteger();

    private double[][] all;
    private Integrator how;
    private double dt;

    Columns(World world, int capacity) {
        this.world = world;
        forced = carried = pinned = world == null;
        scratch = world == null ? null : new double[Kernel.BLOCK];
        use(new double[COUNT][capacity]);
    }

    /** Gives a unit a row outside any world, all zero. */
    static void adopt(Unit unit) {
        while (true) {
            Columns table = nursery.get();
            int row = table.taken.getAndIncrement();
            if (row < NURSERY) {
                unit.columns = table;
                unit.row = row;
                return;
            }
            nursery.compareAndSet(table, new Columns(null, NURSERY));
        }
    }

    private void use(double[][] a) {
        all = a;
        int i = 0;
        x = a[i++];
        y = a[i++];
        vx = a[i++];
        vy = a[i++];
        fx = a[i++];
        fy = a[i++];
        frameX = a[i++];
        frameY = a[i++];
        carryX = a[i++];
        carryY = a[i++];
        previousX = a[i++];
        previousY = a[i++];
        mass = a[i++];
        friction = a[i++];
        maxSpeed = a[i++];
        cap = a[i++];
        decay = a[i++];
        gain = a[i++];
        lag = a[i++];
    }

    int capacity() {
        return x.length;
    }

    void grow() {
        double[][] grown = new double[COUNT][];
        for (int k = 0; k < COUNT; k++) grown[k] = Arrays.copyOf(all[k], 2 * capacity());
        use(grown);
    }

    /** Row i of this table becomes row j of another, which may be this one. */
    void copyRow(int i, Columns to, int j) {
        for (int k = 0; k < COUNT; k++) to.all[k][j] = all[k][i];
        if (to != this) {
            to.frameX[j] = to.frameY[j] = 0; // what a frame of another table gave its steps
            to.forced |= to.fx[j] != 0 || to.fy[j] != 0;
            to.carried |= to.carryX[j] != 0 || to.carryY[j] != 0;
            to.settle(j);
            to.update(j);
        }
    }

    /** The unit is where it is: nothing to interpolate from. */
    void settle(int i) {
        previousX[i] = x[i];
        previousY[i] = y[i];
    }

    void clearForces(int i) {
        fx[i] = fy[i] = frameX[i] = frameY[i] = carryX[i] = carryY[i] = 0;
    }

    /** Follows a change of a row's mass, friction or maxSpeed. */
    void update(int i) {
        cap[i] = Math.max(Kernel.REST, Math.min(maxSpeed[i] * (1 - MARGIN), TOP));
        pinned |= maxSpeed[i] < Kernel.REST;
        if (how != null) coefficients(i, i + 1, dt, how);
    }

    private void coefficients(int from, int to, double dt, Integrator how) {
        Kernel.coefficients(this, from, to, dt, how);
        if (!pinned) return;
        for (int i = from; i < to; i++) {
            if (maxSpeed[i] < Kernel.REST) decay[i] = gain[i] = 0; // nothing moves it
        }
    }

    /** Steps every one of the first n rows. */
    void stepAll(int n, double dt, Integrator how) {
        if (dt != this.dt || how != this.how) {
            this.dt = dt;
            this.how = how;
            coefficients(0, n, dt, how);
        }
        Kernel.step(this, 0, n, dt, how);
        forced = false;
    }

    /** Steps row i alone, whatever step the table's coefficients are for. */
    void stepOne(int i, double dt, Integrator how) {
        coefficients(i, i + 1, dt, how);
        Kernel.step(this, i, i + 1, dt, how);
        update(i);
        settle(i);
    }

    /**
     * A frame in which no step fell due, and which left the clock's remainder longer by {@code elapsed}: the forces'
     * impulse waits for the step that will cover that time.
     */
    void carry(int n, double elapsed) {
        if (!forced) return;
        carry(carryX, fx, n, elapsed);
        carry(carryY, fy, n, elapsed);
        forced = false;
        carried = true;
    }

    private static void carry(double[] carry, double[] f, int n, double elapsed) {
        for (int i = 0; i < n; i++) {
            carry[i] += f[i] * elapsed;
            f[i] = 0;
        }
    }

    /**
     * A frame whose steps cover {@code covered} seconds. The remainder was {@code before} and is {@code after}, so the
     * forces F of this frame acted for covered − before + after. Of their impulse F·after is for later; the rest, with
     * what was carried, is spread evenly over the steps: (carry + F (covered − before)) / covered, written so that a
     * constant force is passed on to the bit.
     */
    void spread(int n, double before, double after, double covered) {
        framed = forced || carried;
        if (!framed) return;
        spread(carryX, frameX, fx, n, before, after, covered);
        spread(carryY, frameY, fy, n, before, after, covered);
        carried = forced;
        forced = true;
    }

    private static void spread(
            double[] carry, double[] frame, double[] f, int n, double before, double after, double covered) {
        for (int i = 0; i < n; i++) {
            double force = f[i];
            frame[i] = force + (carry[i] - force * before) / covered;
            carry[i] = force * after;
            f[i] = frame[i];
        }
    }

    /** The frame's forces, for its next step. */
    void repeatFrame(int n) {
        if (!framed) return;
        System.arraycopy(frameX, 0, fx, 0, n);
        System.arraycopy(frameY, 0, fy, 0, n);
        forced = true;
    }

    void dropStepForces(int n) {
        if (!forced) return;
        Arrays.fill(fx, 0, n, 0);
        Arrays.fill(fy, 0, n, 0);
        forced = false;
    }

    /** The positions from which to interpolate are the present ones. */
    void settleAll(int n) {
        System.arraycopy(x, 0, previousX, 0, n);
        System.arraycopy(y, 0, previousY, 0, n);
    }
}
