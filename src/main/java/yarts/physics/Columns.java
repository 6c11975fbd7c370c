package yarts.physics;

import java.util.Arrays;

/**
 * A block of up to {@link #BLOCK} units: a row a unit, an array a quantity. There is no physics here.
 *
 * <p>A {@link Table} is a list of blocks, some of which share their arrays, each with rows of its own: processors read
 * ahead better in long arrays. Units outside a world share small blocks. Loops may run over a row that is not in use: it
 * is at rest. Rows share nothing but the fields about the block, of which only {@link #still} means anything outside a
 * world, and is only ever set; so threads do not disturb each other's lone units.
 */
final class Columns {
    /** Most rows. What a pass over them touches stays in a first-level cache of 32 KB. */
    static final int BLOCK = 512;

    /** Most rows of blocks that share their arrays. */
    static final int SHARED = 8 * BLOCK;

    /** Loops run over a multiple of this many rows, the last of which nobody may use; see {@link Passes}. */
    static final int LANES = 32;

    /** In place of the number of a row. */
    static final int NONE = -1, MANY = SHARED;

    /** The names of {@link #state}. */
    static final String[] STATE = {
        "x",
        "y",
        "vx",
        "vy",
        "mass",
        "friction",
        "maxSpeed",
        "frozen",
        "fx",
        "fy",
        "pendingX",
        "pendingY",
        "previousX",
        "previousY"
    };

    /** Places in {@link #all}; where the state ends, which is what else follows from; and the end. */
    private static final int X = 0, Y = 1, MASS = 4, PREVIOUS_X = 12, PREVIOUS_Y = 13, FOLLOWING = 14, COUNT = 21;

    /** What the world gave the unit when it was added: 1, 2, 3 and so on; 0 if it was never in any. */
    long[] id;

    double[] x, y, vx, vy, mass, friction, maxSpeed;
    /** 1 if frozen, or 0. */
    double[] frozen;
    /** The force for the next step. */
    double[] fx, fy;
    /** The impulse of forces that acted during the clock's remainder, which no step has covered yet. */
    double[] pendingX, pendingY;
    /** The position before the last step, to interpolate from. */
    double[] previousX, previousY;

    /** The coefficients of {@link Kernel}; they follow from the state, for one dt and integrator. */
    double[] decay, gain, cap;
    /** Two more, which many blocks may have in common: these are not to be written. */
    double[] before, after;

    /** The force that a frame gives to each of its steps, while these run. */
    double[] frameX, frameY;

    /** The index in the table of what the arrays begin with. */
    final int origin;
    /** The first row, and the end of those in use. */
    final int start;

    int end;

    /** Which row may have a force for the next step: its number, or {@link #NONE}, or {@link #MANY}. */
    int pushed = NONE;
    /** Which may have a pending impulse. */
    int pending = NONE;
    /** Which may have a force of the frame in hand; where none has, frameX and frameY are 0. */
    int framed = NONE;

    /** Whether there may be a row that is frozen, or whose top speed is below rest; once true, it is so for good. */
    boolean still;
    /** Whether nothing moves, pushes or has moved in the last step, so that a step would change nothing. */
    boolean asleep;
    /** A row that moved when it was last looked at: where to look first. */
    int mover;
    /** What the coefficients are for; a negative dt if for nothing. */
    double dt = -1;

    int integrator;

    private double[][] all;

    /** The rows from one on, in the arrays of another block. */
    Columns(Columns other, int start) {
        origin = other.origin;
        this.start = end = mover = start;
        use(other.all.clone(), other.id);
    }

    /** The first rows of new arrays. */
    Columns(int origin, int capacity) {
        this.origin = origin;
        start = 0;
        use(arrays(capacity), new long[capacity]);
    }

    private static double[][] arrays(int capacity) {
        // Up to a cache line more: arrays that begin at the same place of a page crowd one another out.
        double[][] arrays = new double[COUNT][capacity + Math.min(capacity / 64, 8)];
        Arrays.fill(arrays[MASS], 1);
        return arrays;
    }

    /** Has the rows in arrays of their own, with room for more. */
    void grow(int capacity) {
        move(arrays(capacity), new long[capacity]);
    }

    /** Has the rows in the arrays of another block, too. */
    void share(Columns other) {
        move(other.all.clone(), other.id);
    }

    private void move(double[][] arrays, long[] ids) {
        for (int k = 0; k < COUNT; k++) System.arraycopy(all[k], start, arrays[k], start, end - start);
        System.arraycopy(id, start, ids, start, end - start);
        use(arrays, ids);
        dt = -1;
    }

    private void use(double[][] arrays, long[] ids) {
        all = arrays;
        id = ids;
        int i = 0;
        x = all[i++];
        y = all[i++];
        vx = all[i++];
        vy = all[i++];
        mass = all[i++];
        friction = all[i++];
        maxSpeed = all[i++];
        frozen = all[i++];
        fx = all[i++];
        fy = all[i++];
        pendingX = all[i++];
        pendingY = all[i++];
        previousX = all[i++];
        previousY = all[i++];
        decay = all[i++];
        gain = all[i++];
        cap = all[i++];
        frameX = all[i++];
        frameY = all[i];
    }

    /** Has shares of its own. */
    void own() {
        before = all[COUNT - 2];
        after = all[COUNT - 1];
    }

    int capacity() {
        return id.length;
    }

    /** Where a loop over all rows ends. */
    int lanes() {
        return start + lanes(end - start);
    }

    static int lanes(int rows) {
        return (rows + LANES - 1) / LANES * LANES;
    }

    /** All that a unit's future depends on, and where it is drawn. */
    double[][] state() {
        return Arrays.copyOf(all, FOLLOWING);
    }

    /** Follows a force on a row. */
    void push(int i) {
        int p = pushed;
        if (p != i && p != MANY) pushed = join(p, i);
    }

    static int join(int a, int b) {
        return a == b || b == NONE ? a : a == NONE ? b : MANY;
    }

    /** Follows a change after which a row may move. */
    void wake(int i) {
        asleep = false;
        mover = i;
    }

    /** Follows a change of what the coefficients follow from. */
    void renew() {
        dt = -1;
        asleep = false;
    }

    void clearForces(int i) {
        fx[i] = fy[i] = pendingX[i] = pendingY[i] = frameX[i] = frameY[i] = 0;
    }

    /** The unit of a row is where it is: nothing to interpolate from. */
    void settle(int i) {
        previousX[i] = x[i];
        previousY[i] = y[i];
    }

    void settle() {
        System.arraycopy(x, start, previousX, start, end - start);
        System.arraycopy(y, start, previousY, start, end - start);
    }

    /** What was the position becomes the previous one, and the other way round. */
    void swapPositions() {
        all[X] = previousX;
        all[Y] = previousY;
        all[PREVIOUS_X] = previousX = x;
        all[PREVIOUS_Y] = previousY = y;
        x = all[X];
        y = all[Y];
    }

    /** Row i of this block becomes row j of another, which may be this one. */
    void copyRow(int i, Columns other, int j) {
        other.id[j] = id[i];
        for (int k = 0; k < COUNT; k++) other.all[k][j] = all[k][i];
        if (other != this) other.dt = -1;
        other.wake(j);
        if (frozen[i] != 0 || maxSpeed[i] < 1e-100) other.still = true; // and more seldom than this block's may say
        if (fx[i] != 0 || fy[i] != 0) other.push(j);
        if (pendingX[i] != 0 || pendingY[i] != 0) other.pending = join(other.pending, j);
        if (frameX[i] != 0 || frameY[i] != 0) other.framed = join(other.framed, j);
    }

    /** The rows from one on are no longer in use. */
    void clear(int from) {
        for (double[] column : all) Arrays.fill(column, from, end, 0);
        Arrays.fill(mass, from, end, 1);
        Arrays.fill(cap, from, end, 1);
        end = from;
    }

    /** The rows of another block become those of this one; the coefficients are yet to be worked out. */
    void copy(Columns other) {
        int rows = other.end - start;
        for (int k = 0; k < FOLLOWING; k++) System.arraycopy(other.all[k], start, all[k], start, rows);
        System.arraycopy(other.id, start, id, start, rows);
        clear(other.end);
        pushed = other.pushed;
        pending = other.pending;
        framed = NONE;
        still = other.still;
        mover = other.mover;
        renew();
    }
}
