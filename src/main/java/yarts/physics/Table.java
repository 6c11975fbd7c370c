package yarts.physics;

import java.util.Arrays;

/**
 * The state of units: one array per quantity, one row per unit. It grows and copies rows; it contains no physics.
 *
 * <p>The rows are divided into tiles. A step processes one tile after the other, so the data of a tile stays in the
 * cache from pass to pass. Each tile has flags. A flag may be true although no row has the property, but if it is
 * false, no row has it.
 *
 * <p>A table belongs to a world, to a snapshot, or to units outside a world. Outside a world, different threads may use
 * different rows: no code reads the flags there, and no code clears them.
 */
final class Table {
    private static final int SHIFT = 9;

    /** The number of rows in a tile. The arrays of a pass fit into a first-level cache of 32 KB. */
    static final int TILE = 1 << SHIFT;

    /** Loops over a tile cover a multiple of this many rows; see {@link Passes}. */
    static final int LANES = 32;

    /**
     * The number of additional elements of long arrays: a cache line. Arrays whose lengths are powers of two would
     * start at the same offset within a page and evict one another from the cache.
     */
    private static final int LINE = 8;

    /** The names of the columns of the state, in the order of {@link #columns}. */
    static final String[] STATE = {
        "x",
        "y",
        "vx",
        "vy",
        "mass",
        "friction",
        "maxSpeed",
        "frozen",
        "motorVx",
        "motorVy",
        "motorForce",
        "fx",
        "fy",
        "waitingX",
        "waitingY",
        "pendingX",
        "pendingY",
        "previousX",
        "previousY"
    };

    private static final int X = 0,
            Y = 1,
            MASS = 4,
            PREVIOUS_X = 17,
            PREVIOUS_Y = 18,
            CAP = 19,
            COPIED = 22,
            COLUMNS = 25;

    /** The world that contains the units of the rows; null outside a world. */
    Object owner;

    /** The number of rows in use. Loops also run over other rows; these are at rest, with a mass and a cap of 1. */
    int size;

    /** The id that the world gave to the unit: 1, 2, 3 and so on; 0 if it was never in a world. */
    long[] id;

    double[] x, y, vx, vy, mass, friction, maxSpeed;
    /** 1 if frozen, otherwise 0. */
    double[] frozen;
    /** The ordered velocity of the motor, and its maximum force. */
    double[] motorVx, motorVy, motorForce;
    /** The force for the next step, or for the time of the next advance. */
    double[] fx, fy;
    /**
     * The force that was applied after the last step of a call. It acts for exactly one step, which a later call runs.
     */
    double[] waitingX, waitingY;
    /** The impulse of forces during elapsed time that no step has covered yet. */
    double[] pendingX, pendingY;
    /** The position before the last step, for interpolation. */
    double[] previousX, previousY;

    /** The top speed, limited to the range in which {@link Kernel} can compute. It follows from the state. */
    double[] cap;
    /** The force of a frame in each of its steps, while they run. */
    double[] frameX, frameY;
    /** The coefficients of {@link Kernel}, which follow from the state for one {@link #dt} and {@link #integrator}. */
    double[] decay, gain, lag;

    /** All columns in this order: the state, the cap, the frame's force, and the coefficients, which are not copied. */
    private double[][] all;

    /**
     * Tiles in which rows may have a force for the next step, a pending impulse, a waiting force, or a frame's force.
     */
    boolean[] pushed, pending, waiting, framed;
    /** Tiles in which rows may have an ordered velocity or a motor force. */
    boolean[] motored;
    /** Tiles in which rows may be frozen or have a top speed of 0. */
    boolean[] still;
    /** Tiles that a step without forces would not change: no row moves, and none moved in the last step. */
    boolean[] asleep;
    /** Tiles whose coefficients are not for {@link #dt} and {@link #integrator}. */
    boolean[] stale;

    /** The length of the steps for which the coefficients of the tiles hold that are not stale; in seconds. */
    double dt = -1;

    /** The integrator for which they hold. */
    Integrator integrator;

    /** Creates a table in which all rows are in use. */
    Table(int size) {
        this.size = size;
        int tiles = tiles(size);
        id = new long[size];
        pushed = new boolean[tiles];
        pending = new boolean[tiles];
        waiting = new boolean[tiles];
        framed = new boolean[tiles];
        motored = new boolean[tiles];
        still = new boolean[tiles];
        asleep = new boolean[tiles];
        stale = new boolean[tiles];
        Arrays.fill(stale, true);
        double[][] columns = new double[COLUMNS][];
        for (int k = 0; k < COLUMNS; k++) columns[k] = new double[length(size)];
        Arrays.fill(columns[MASS], 1);
        Arrays.fill(columns[CAP], 1);
        use(columns);
    }

    private static int length(int capacity) {
        return capacity < TILE ? capacity : capacity + LINE;
    }

    private void use(double[][] columns) {
        all = columns;
        int k = 0;
        x = all[k++];
        y = all[k++];
        vx = all[k++];
        vy = all[k++];
        mass = all[k++];
        friction = all[k++];
        maxSpeed = all[k++];
        frozen = all[k++];
        motorVx = all[k++];
        motorVy = all[k++];
        motorForce = all[k++];
        fx = all[k++];
        fy = all[k++];
        waitingX = all[k++];
        waitingY = all[k++];
        pendingX = all[k++];
        pendingY = all[k++];
        previousX = all[k++];
        previousY = all[k++];
        cap = all[k++];
        frameX = all[k++];
        frameY = all[k++];
        decay = all[k++];
        gain = all[k++];
        lag = all[k];
    }

    /** {@return the columns of the state, in the order of {@link #STATE}} */
    double[][] columns() {
        return Arrays.copyOf(all, STATE.length);
    }

    /** The number of tiles with rows in use. */
    int tiles() {
        return tiles(size);
    }

    private static int tiles(int rows) {
        return (rows + TILE - 1) >> SHIFT;
    }

    static int tile(int row) {
        return row >> SHIFT;
    }

    /** The first row of a tile. */
    static int start(int tile) {
        return tile << SHIFT;
    }

    /** The end (exclusive) of the rows of a tile that are in use. */
    int end(int tile) {
        return Math.min(start(tile + 1), size);
    }

    /** The end (exclusive) of a loop over a tile, which may include rows that are not in use. */
    int lanes(int tile) {
        return Math.min(start(tile + 1), roundUp(size));
    }

    private static int roundUp(int rows) {
        return (rows + LANES - 1) / LANES * LANES;
    }

    /** Allocates memory for a number of rows. No other part of an addition to the table allocates memory. */
    void reserve(int rows) {
        int capacity = id.length;
        if (rows > capacity) grow(roundUp(Math.max(rows, capacity + capacity / 2)));
    }

    /** Allocates arrays of the state before it assigns any: if memory runs out, only arrays of flags may be longer. */
    private void grow(int capacity) {
        int old = all[MASS].length, length = length(capacity), tiles = tiles(capacity);
        double[][] columns = new double[COLUMNS][];
        for (int k = 0; k < COLUMNS; k++) columns[k] = Arrays.copyOf(all[k], length);
        Arrays.fill(columns[MASS], old, length, 1);
        Arrays.fill(columns[CAP], old, length, 1);
        long[] ids = Arrays.copyOf(id, capacity);
        pushed = Arrays.copyOf(pushed, tiles);
        pending = Arrays.copyOf(pending, tiles);
        waiting = Arrays.copyOf(waiting, tiles);
        framed = Arrays.copyOf(framed, tiles);
        motored = Arrays.copyOf(motored, tiles);
        still = Arrays.copyOf(still, tiles);
        asleep = Arrays.copyOf(asleep, tiles);
        boolean[] stales = Arrays.copyOf(stale, tiles);
        Arrays.fill(stales, stale.length, tiles, true);
        stale = stales;
        id = ids;
        use(columns);
    }

    /** Copies a row to a row of another table or of this one. The caller must then compute its coefficients. */
    void copyRow(int i, Table to, int j) {
        to.id[j] = id[i];
        for (int k = 0; k < COPIED; k++) to.all[k][j] = all[k][i];
        int tile = tile(j);
        to.asleep[tile] = false;
        if (fx[i] != 0 || fy[i] != 0) to.pushed[tile] = true;
        if (pendingX[i] != 0 || pendingY[i] != 0) to.pending[tile] = true;
        if (waitingX[i] != 0 || waitingY[i] != 0) to.waiting[tile] = true;
        if (frameX[i] != 0 || frameY[i] != 0) to.framed[tile] = true;
        if (hasMotor(i)) to.motored[tile] = true;
        if (frozen[i] != 0 || maxSpeed[i] == 0) to.still[tile] = true;
    }

    /** Whether a row has an ordered velocity or a motor force. */
    boolean hasMotor(int i) {
        return motorForce[i] != 0 || motorVx[i] != 0 || motorVy[i] != 0;
    }

    /** Discards the forces on a row that have not acted, or not in every step of the frame. */
    void clearForces(int i) {
        fx[i] = fy[i] = waitingX[i] = waitingY[i] = pendingX[i] = pendingY[i] = frameX[i] = frameY[i] = 0;
    }

    /** Discards the forces on all rows. */
    void clearForces() {
        for (int i = 0; i < size; i++) clearForces(i);
    }

    /** Makes the previous position of a row equal to its position, so that it is not interpolated. */
    void settle(int i) {
        previousX[i] = x[i];
        previousY[i] = y[i];
    }

    /** Makes the previous positions of a tile equal to its positions. */
    void settleTile(int tile) {
        int start = start(tile), rows = end(tile) - start;
        System.arraycopy(x, start, previousX, start, rows);
        System.arraycopy(y, start, previousY, start, rows);
    }

    /** Swaps the columns of the positions and of the previous positions. */
    void swapPositions() {
        all[X] = previousX;
        all[Y] = previousY;
        all[PREVIOUS_X] = previousX = x;
        all[PREVIOUS_Y] = previousY = y;
        x = all[X];
        y = all[Y];
    }

    /** Reduces the number of rows in use, and resets the others. */
    void truncate(int newSize) {
        for (int i = newSize; i < size; i++) {
            for (int k = 0; k < COPIED; k++) all[k][i] = 0;
            mass[i] = cap[i] = 1;
            id[i] = 0;
        }
        size = newSize;
    }

    /** Replaces all rows by those of another table. The coefficients become stale. */
    void copy(Table other) {
        reserve(other.size);
        if (other.size < size) truncate(other.size);
        size = other.size;
        for (int k = 0; k <= CAP; k++) System.arraycopy(other.all[k], 0, all[k], 0, size);
        System.arraycopy(other.id, 0, id, 0, size);
        int tiles = tiles();
        System.arraycopy(other.pushed, 0, pushed, 0, tiles);
        System.arraycopy(other.pending, 0, pending, 0, tiles);
        System.arraycopy(other.waiting, 0, waiting, 0, tiles);
        System.arraycopy(other.motored, 0, motored, 0, tiles);
        System.arraycopy(other.still, 0, still, 0, tiles);
        System.arraycopy(other.asleep, 0, asleep, 0, tiles);
        Arrays.fill(stale, true);
    }
}
