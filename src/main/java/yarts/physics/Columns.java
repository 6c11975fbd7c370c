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
    /** Where in {@link #all} what follows from the state begins, then the forces and so on, and the end. */
    private static final int COEFFICIENTS = 7, FORCES = 11, CARRIES = 13, PREVIOUS = 15, FRAMES = 17, COUNT = 19;

    /** The names of {@link #state}. */
    static final String[] STATE = {
        "x", "y", "vx", "vy", "mass", "friction", "maxSpeed", "fx", "fy", "carryX", "carryY", "previousX", "previousY"
    };

    /** Rows in a block; the 5 arrays of a pass are 20 KB of a cache of 32 KB, and going from pass to pass costs little. */
    static final int BLOCK = 512;

    private static final int NURSERY = 32;
    private static final AtomicReference<Columns> nursery = new AtomicReference<>(new Columns(null, NURSERY));

    /** Relative; twice the rounding errors that the speed cap and Unit.getSpeed make. */
    private static final double MARGIN = 0x1p-49;

    /** The cap where there is none. */
    static final double TOP = Kernel.FASTEST * (1 - MARGIN);

    /** The world whose table this is, or null. */
    final World world;

    /** What the world that the unit was added to numbered it: 1, 2, 3 and so on; 0 if it was never in any. */
    long[] id = {};

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
    /** See {@link Coefficients}. */
    double[] decay, gain, lag;

    /** Whether any row may have a force for the next step; if not, fx and fy are 0 throughout. */
    boolean forced;
    /** Whether any row may have an impulse carried; if not, carryX and carryY are 0 throughout. */
    private boolean carried;
    /** Whether the frame in hand has forces; if not, frameX and frameY mean nothing. */
    private boolean framed;
    /** Whether any row may have a maxSpeed below rest. */
    private boolean pinned;
    /**
     * By block of a world's table, what Kernel knows: if positive, for how many more steps without forces its rows are
     * calm, or that Kernel is to find out; if negative, that none is above its cap; 0 if nothing.
     */
    byte[] calm;
    /** How many rows of a nursery are taken. */
    private final AtomicInteger taken = new AtomicInteger();

    private double[][] all;
    private Integrator how;
    private double dt;

    /** What a step has to do besides: renew the coefficients, keep the positions, spread a frame's forces. */
    private boolean renew, settle, spread;
    /** How to spread them; see {@link #spread}. */
    private double before, after, perSecond;

    private boolean repeated;

    Columns(World world, int capacity) {
        this.world = world;
        forced = carried = pinned = world == null;
        resize(capacity);
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

    private void resize(int capacity) {
        double[][] a = new double[COUNT][];
        for (int k = 0; k < COUNT; k++) {
            // Not all of one size: arrays that begin at the same place of a page crowd one another out of the cache.
            int length = capacity + k * Math.min(capacity / 64, 24);
            a[k] = all == null ? new double[length] : Arrays.copyOf(all[k], length);
        }
        all = a;
        id = Arrays.copyOf(id, capacity);
        calm = new byte[capacity / BLOCK + 1];
        int i = 0;
        x = a[i++];
        y = a[i++];
        vx = a[i++];
        vy = a[i++];
        mass = a[i++];
        friction = a[i++];
        maxSpeed = a[i++];
        cap = a[i++];
        decay = a[i++];
        gain = a[i++];
        lag = a[i++];
        fx = a[i++];
        fy = a[i++];
        carryX = a[i++];
        carryY = a[i++];
        previousX = a[i++];
        previousY = a[i++];
        frameX = a[i++];
        frameY = a[i++];
    }

    int capacity() {
        return x.length;
    }

    /** Makes room for n rows. */
    void reserve(int n) {
        if (n > capacity()) resize(Math.max(n, 2 * capacity()));
    }

    /** All that a unit's future depends on. The other columns follow from these, or last for a frame. */
    double[][] state() {
        return new double[][] {x, y, vx, vy, mass, friction, maxSpeed, fx, fy, carryX, carryY, previousX, previousY};
    }

    /** Row i of this table becomes row j of another, which may be this one. */
    void copyRow(int i, Columns to, int j) {
        to.id[j] = id[i];
        to.disturb(j);
        copyCells(i, to, j, 0, to == this ? FORCES : COEFFICIENTS, true);
        copyCells(i, to, j, FORCES, CARRIES, forced);
        copyCells(i, to, j, CARRIES, PREVIOUS, carried);
        copyCells(i, to, j, FRAMES, COUNT, to == this && framed);
        if (to == this) {
            copyCells(i, to, j, PREVIOUS, FRAMES, true);
        } else {
            to.forced |= to.fx[j] != 0 || to.fy[j] != 0;
            to.carried |= to.carryX[j] != 0 || to.carryY[j] != 0;
            to.settle(j, j + 1);
            to.update(j);
        }
    }

    private void copyCells(int i, Columns to, int j, int first, int end, boolean used) {
        for (int k = first; k < end; k++) to.all[k][j] = used ? all[k][i] : 0;
    }

    /** The first n rows of another table become those of this one; without the frame that is in hand, if one is. */
    void copyRows(int n, Columns to, boolean interpolating) {
        to.reserve(n);
        Arrays.fill(to.calm, (byte) 0);
        System.arraycopy(id, 0, to.id, 0, n);
        copy(0, FORCES, n, to, true);
        copy(FORCES, CARRIES, n, to, forced);
        copy(CARRIES, PREVIOUS, n, to, carried);
        if (interpolating) copy(PREVIOUS, FRAMES, n, to, true);
        else to.settle(0, n);
        to.forced = forced;
        to.carried = carried;
        to.pinned = pinned;
        to.dt = dt;
        to.how = how;
    }

    private void copy(int first, int end, int n, Columns to, boolean used) {
        for (int k = first; k < end; k++) {
            if (used) System.arraycopy(all[k], 0, to.all[k], 0, n);
            else Arrays.fill(to.all[k], 0, n, 0);
        }
    }

    /** Refuses a row whose state was written from outside, if no unit can have come to it. */
    void check(int i) {
        Check.finite("x", x[i]);
        Check.finite("y", y[i]);
        Check.finite("x - previousX", x[i] - Check.finite("previousX", previousX[i])); // or they cannot be
        Check.finite("y - previousY", y[i] - Check.finite("previousY", previousY[i])); // interpolated
        Check.mass(mass[i]);
        Check.friction(friction[i]);
        double most = Math.min(Check.maxSpeed(maxSpeed[i]), Kernel.FASTEST);
        if (most < Kernel.REST) most = 0;
        Check.velocity("vx", vx[i], most);
        Check.velocity("vy", vy[i], most);
        double speed = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
        if (!(speed <= most)) throw Check.refused("speed", "at most " + most + " m/s", speed);
        Check.held("fx", fx[i]);
        Check.held("fy", fy[i]);
        Check.held("carryX", carryX[i]);
        Check.held("carryY", carryY[i]);
    }

    /** Works out what follows from the state of the first n rows, which was written from outside. */
    void follow(int n) {
        forced = carried = pinned = true;
        for (int i = 0; i < n; i++) update(i);
    }

    /**
     * A hash of the order and state of the first n rows, that goes on from h. The change of a single bit always shows,
     * since each step can be undone; and a column of zeros adds nothing, so that it can be left out.
     */
    long hash(long h, int n, boolean interpolating) {
        for (int i = 0; i < n; i++) {
            long row = id[i] * 3 + mix(x[i]) * 5 + mix(y[i]) * 7 + mix(vx[i]) * 11 + mix(vy[i]) * 13;
            row += mix(mass[i]) * 17 + mix(friction[i]) * 19 + mix(maxSpeed[i]) * 23;
            if (forced) row += mix(fx[i]) * 29 + mix(fy[i]) * 31;
            if (carried) row += mix(carryX[i]) * 37 + mix(carryY[i]) * 41;
            if (interpolating) row += mix(previousX[i]) * 43 + mix(previousY[i]) * 47;
            h = Clock.mix(h, row);
        }
        return h;
    }

    private static long mix(double v) {
        long bits = Double.doubleToRawLongBits(v + 0.0) * 0x9E3779B97F4A7C15L; // -0.0 is 0.0
        return bits ^ (bits >>> 32);
    }

    /** The rows' units are where they are: nothing to interpolate from. */
    void settle(int from, int to) {
        System.arraycopy(x, from, previousX, from, to - from);
        System.arraycopy(y, from, previousY, from, to - from);
    }

    /** Follows a change of a row's velocity, cap or decay. */
    void disturb(int i) {
        calm[i / BLOCK] = 0;
    }

    void clearForces(int i) {
        fx[i] = fy[i] = frameX[i] = frameY[i] = carryX[i] = carryY[i] = 0;
    }

    /** Follows a change of a row's mass, friction or maxSpeed. */
    void update(int i) {
        cap[i] = Math.max(Kernel.REST, Math.min(maxSpeed[i] * (1 - MARGIN), TOP));
        pinned |= maxSpeed[i] < Kernel.REST;
        disturb(i);
        if (how != null) coefficients(i, i + 1, dt, how);
    }

    private void coefficients(int from, int to, double dt, Integrator how) {
        Coefficients.of(this, from, to, dt, how);
        for (int i = from; pinned && i < to; i++) {
            if (maxSpeed[i] < Kernel.REST) decay[i] = gain[i] = 0; // nothing moves it
        }
    }

    /**
     * Steps every one of the first n rows, on the threads of a team unless that is null.
     *
     * @param interpolated whether to keep the positions before the step
     */
    void stepAll(int n, double dt, Integrator how, boolean interpolated, Team team) {
        renew = dt != this.dt || how != this.how;
        settle = interpolated;
        this.dt = dt;
        this.how = how;
        if (team == null) stepRows(0, n);
        else team.step(this, n);
        forced = spread = false;
    }

    /** The part of stepAll that is done for each row; in blocks that stay in the first-level cache from pass to pass. */
    void stepRows(int from, int to) {
        for (int i = from; i < to; i += BLOCK) {
            int end = Math.min(i + BLOCK, to);
            if (renew) renew(i, end);
            if (spread) spreadRows(i, end);
            if (settle) settle(i, end);
            Kernel.step(this, i, end, dt, how);
        }
    }

    private void renew(int from, int to) {
        coefficients(from, to, dt, how);
        if (calm[from / BLOCK] > 0 && Kernel.disturbed(decay, from, to)) disturb(from);
    }

    /** Steps row i alone, whatever step the table's coefficients are for. */
    void stepOne(int i, double dt, Integrator how) {
        coefficients(i, i + 1, dt, how);
        Kernel.stepRow(this, i, dt, how);
        update(i);
        settle(i, i + 1);
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
        if (n < Kernel.FEW) for (int i = 0; i < n; i++) carryRow(carry, f, i, elapsed);
        else for (int i = 0; i < n; i++) carryRow(carry, f, i, elapsed); // a loop that is always long: see FEW
    }

    private static void carryRow(double[] carry, double[] f, int i, double elapsed) {
        carry[i] += f[i] * elapsed;
        f[i] = 0;
    }

    /**
     * A frame whose steps cover {@code covered} seconds. The remainder was {@code before} and is {@code after}, so the
     * forces F of this frame acted for covered − before + after. Of their impulse F·after is for later; the rest, with
     * what was carried, is spread evenly over the steps: (carry + F (covered − before)) / covered, written so that a
     * constant force is passed on to the bit. It is done with the next step, or by {@link #spreadAll} before.
     *
     * @param repeated whether there is more than one step
     */
    void spread(double before, double after, double covered, boolean repeated) {
        framed = spread = forced || carried;
        this.before = before;
        this.after = after;
        perSecond = 1 / Math.max(covered, 1e-9); // less, of variable steps only, would overflow
        this.repeated = repeated;
        carried = after > 0 && forced;
        forced |= framed;
    }

    void spreadAll(int n) {
        if (spread) spreadRows(0, n);
        spread = false;
    }

    private void spreadRows(int from, int to) {
        spread(carryX, fx, from, to, before, after, perSecond);
        spread(carryY, fy, from, to, before, after, perSecond);
        if (!repeated) return;
        System.arraycopy(fx, from, frameX, from, to - from);
        System.arraycopy(fy, from, frameY, from, to - from);
    }

    private static void spread(
            double[] carry, double[] f, int from, int to, double before, double after, double perSecond) {
        if (to - from < Kernel.FEW) {
            for (int i = from; i < to; i++) spreadRow(carry, f, i, before, after, perSecond);
        } else {
            for (int i = from; i < to; i++) spreadRow(carry, f, i, before, after, perSecond);
        }
    }

    private static void spreadRow(double[] carry, double[] f, int i, double before, double after, double perSecond) {
        double force = f[i];
        f[i] = force + (carry[i] - force * before) * perSecond;
        carry[i] = force * after;
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
}
