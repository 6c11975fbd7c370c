package yarts.physics;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ForkJoinPool;
import java.util.function.LongFunction;

/**
 * Steps many units together, at fixed or variable timesteps.
 *
 * <pre>{@code
 * World world = new World(Integrator.EXACT, Timestep.fixed(60));
 * world.setStepListener((w, dt) -> steer(w));
 * // every frame:
 * world.advance(secondsSinceLastFrame);
 * world.copyPositions(buffer, 0);
 * }</pre>
 *
 * <p><b>Order.</b> Units are numbered 0 to size − 1, in the order in which they were added. Removing one gives its
 * number to the last. While iterating, remove through the iterator, which visits every other unit all the same; adding
 * or removing in any other way makes the iterator throw {@link java.util.ConcurrentModificationException}.
 *
 * <p>Units do not act on one another, and every unit moves exactly as it would alone: the same bits as
 * {@link Unit#integrate(double, Integrator)}. Once it has grown to its size, a world creates no garbage. Not safe for
 * use by several threads at once.
 */
public final class World implements Iterable<Unit> {
    /** Volatile, so that no compiler works out in its own thread what they become. */
    private static volatile double smallestNormal = Double.MIN_NORMAL, smallest = Double.MIN_VALUE;

    private final Clock clock;
    private Integrator how;
    private Timestep timestep;
    private final Columns columns = new Columns(this, 16);
    private final Members members = new Members(columns);
    private final List<Unit> units = Collections.unmodifiableList(members);
    private StepListener listener;
    /** Whose threads step this; null if the caller's alone does. */
    Team team;

    private boolean stepping;
    /** How many units were ever added. */
    private long lastId;
    /** Whether the last step was one to interpolate over. */
    private boolean interpolating;

    /** Creates an empty world with {@link Integrator#EULER} and 60 fixed steps a second. */
    public World() {
        this(Integrator.EULER, Timestep.fixed(60));
    }

    /**
     * Creates an empty world.
     *
     * @param how the integrator
     * @param timestep how {@link #advance} turns time into steps
     */
    public World(Integrator how, Timestep timestep) {
        this.how = Check.notNull("how", how);
        this.timestep = Check.notNull("timestep", timestep);
        clock = new Clock(timestep);
    }

    /**
     * Adds a unit, as the last, with its state and the forces applied to it. It gets the next {@linkplain Unit#getId()
     * id}.
     *
     * @param <U> the unit's own type
     * @param unit a unit that is in no world
     * @return the unit
     * @throws IllegalStateException if the unit is in a world already, this one or another
     */
    public <U extends Unit> U add(U unit) {
        if (Check.notNull("unit", unit).getWorld() != null) {
            throw new IllegalStateException("a unit can be in one world only, and this one is in "
                    + (contains(unit) ? "this world already: " : "another: ") + unit);
        }
        members.append(unit, ++lastId);
        return unit;
    }

    /**
     * Removes a unit, which keeps its state. The last unit takes its number.
     *
     * @param unit a unit
     * @return whether the unit was in this world
     */
    public boolean remove(Unit unit) {
        if (!contains(unit)) return false;
        members.remove(unit.row);
        return true;
    }

    /**
     * Tells whether a unit is in this world, in constant time.
     *
     * @param unit a unit, or null
     * @return whether it is
     */
    public boolean contains(Unit unit) {
        return unit != null && unit.columns == columns;
    }

    /** Removes all units, which keep their state. Time stays as it is. */
    public void clear() {
        members.clear();
    }

    /** {@return the number of units} */
    public int size() {
        return members.size();
    }

    /**
     * {@return the unit with a number}
     *
     * @param index the number, from 0 to size − 1
     * @throws IndexOutOfBoundsException if there is none
     */
    public Unit get(int index) {
        return members.get(index);
    }

    /**
     * {@return the unit with an id, or null if it is not in this world} In constant time, but for the first call and the
     * first after a {@link #restore} that brought or took units, which look at all of them.
     *
     * @param id the id
     * @see Unit#getId()
     */
    public Unit find(long id) {
        return members.find(id);
    }

    /** {@return the units in order: a live view that cannot be modified} */
    public List<Unit> units() {
        return units;
    }

    /** {@return an iterator over the units in order, which can remove them} */
    @Override
    public Iterator<Unit> iterator() {
        return members.iterator();
    }

    /**
     * Runs one step of exactly dt. Forces applied before it act for dt.
     *
     * @param dt in seconds, from 0 to 1e9
     * @throws IllegalArgumentException if dt is out of range
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void step(double dt) {
        dt = Check.time("dt", dt);
        begin();
        try {
            run(dt);
            interpolating = false;
        } finally {
            stepping = false;
        }
    }

    /**
     * Advances by a frame's time, in steps as the {@link Timestep} says.
     *
     * <p>Forces applied before it act for the elapsed time: their impulse F·elapsed is spread evenly over the steps
     * that the time turns into, and what falls in a remainder that no step has covered yet waits for the next advance,
     * with the remainder. So a push applied once a frame moves a unit alike at any frame rate. Time beyond the limit of
     * {@link Timestep#withMaxSteps} is dropped, and the forces' share of it too.
     *
     * @param elapsed in seconds, from 0 to 1e9; rounded to nanoseconds if steps are fixed
     * @return how many steps were run
     * @throws IllegalArgumentException if elapsed is out of range
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public int advance(double elapsed) {
        elapsed = Check.time("elapsed", elapsed);
        begin();
        try {
            return timestep.isFixed() ? advanceFixed(elapsed) : advanceVariable(elapsed);
        } finally {
            stepping = false;
        }
    }

    private int advanceFixed(double elapsed) {
        long before = clock.remainder();
        long due = clock.stepsDue(elapsed);
        long after = clock.remainder();
        if (due == 0) {
            columns.carry(size(), clock.seconds(after - before));
            return 0;
        }
        columns.spread(clock.seconds(before), clock.seconds(after), (double) due / timestep.rate, due > 1);
        return run(due, timestep.maxStep);
    }

    private int advanceVariable(double elapsed) {
        double most = timestep.maxSteps * timestep.maxStep;
        if (elapsed > most) {
            clock.drop(elapsed - most);
            elapsed = most;
        }
        if (elapsed == 0) {
            columns.dropStepForces(size());
            return 0;
        }
        long steps = Math.max(1, (long) (elapsed / timestep.maxStep));
        if (elapsed / steps > timestep.maxStep && steps < timestep.maxSteps) steps++;
        columns.spread(0, 0, elapsed, steps > 1);
        return run(steps, Math.min(elapsed / steps, timestep.maxStep));
    }

    /** Runs the steps due, as far as the limit allows, with the frame's forces in each; drops those not run. */
    private int run(long due, double dt) {
        int ran = 0;
        try {
            int n = (int) Math.min(due, timestep.maxSteps);
            while (ran < n) {
                if (ran > 0) columns.repeatFrame(size());
                interpolating = timestep.isFixed() && ran == n - 1;
                run(dt);
                ran++;
            }
        } finally {
            clock.drop(due - ran, dt);
            columns.dropStepForces(size()); // of a step that the listener stopped with an exception
        }
        return ran;
    }

    private void run(double dt) {
        if (listener != null) {
            columns.spreadAll(size());
            listener.beforeStep(this, dt);
        }
        columns.stepAll(size(), dt, how, interpolating, team);
        clock.ran(dt);
    }

    private void begin() {
        refuseWhileStepping();
        stepping = true;
    }

    private void refuseWhileStepping() {
        if (!stepping) return;
        throw new IllegalStateException("a step is running: a StepListener must not step, save or restore its world");
    }

    /** {@return how far time is on its way from one fixed step to the next: at least 0, and below 1 even as a float} */
    public double getAlpha() {
        return clock.alpha();
    }

    /** {@return the number of steps run so far} */
    public long getTick() {
        return clock.tick();
    }

    /** {@return the simulated time in seconds: that of the steps run so far} */
    public double getTime() {
        return clock.time();
    }

    /** {@return the seconds that {@link #advance} dropped so far, since they were beyond the catch-up limit} */
    public double getDroppedTime() {
        return clock.droppedTime();
    }

    /**
     * Sets what to call before each step.
     *
     * @param listener the listener, or null for none
     */
    public void setStepListener(StepListener listener) {
        this.listener = listener;
    }

    /**
     * Sets a pool whose threads share the work of steps of large worlds, from some 30,000 units on. The results are the
     * same to the bit as on one thread, and a step has still ended when the call that runs it returns. The calling
     * thread does its part. Of the pool's threads as many take part as make up its parallelism with the caller; of
     * {@link ForkJoinPool#commonPool}, all.
     *
     * @param pool the pool, which remains the caller's to shut down, or null for none
     */
    public void setPool(ForkJoinPool pool) {
        team = pool == null ? null : new Team(pool, Team.LEAST);
    }

    /**
     * Copies the interpolated positions of all units, in order, as x0, y0, x1, y1, … into a renderer's buffer.
     *
     * @param xy the buffer; values beyond the range of float become the largest float
     * @param offset where x0 goes
     * @throws IndexOutOfBoundsException if the buffer has no room for 2·size floats from offset; it is unchanged then
     */
    public void copyPositions(float[] xy, int offset) {
        Objects.checkFromIndexSize(offset, 2 * size(), xy.length);
        for (int i = 0, j = offset; i < size(); i++) {
            xy[j++] = narrow(interpolate(columns.previousX[i], columns.x[i]));
            xy[j++] = narrow(interpolate(columns.previousY[i], columns.y[i]));
        }
    }

    /**
     * {@return a hash of all that this world's future depends on} That is the integrator, the timestep, where the world
     * stands in time, its units' ids, order and state, and the forces held for later. Two worlds that were treated alike
     * have the same hash, on any JVM and machine. Two that differ in a single bit have not, and two that differ in more all
     * but never. It creates no garbage.
     *
     * @see Snapshot#difference
     */
    public long stateHash() {
        long h = Clock.mix(clock.hash(how.ordinal()), lastId);
        h = Clock.mix(Clock.mix(h, size()), interpolating ? 1 : 0);
        return columns.hash(h, size(), interpolating);
    }

    /**
     * Saves this world into a snapshot, to {@link #restore} it later: all that {@link #stateHash} is a hash of, and which
     * units they are. The step listener and the pool are not part of it. A snapshot that is used again creates no garbage.
     *
     * @param into what to save into; what it held before is lost
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void save(Snapshot into) {
        Check.notNull("into", into);
        refuseWhileStepping();
        into.take(this, how, clock, lastId, interpolating, columns, members.array(), size());
    }

    /**
     * Makes this world what it was, or another one is, in a snapshot.
     *
     * <p>If the snapshot was taken of this world, the units are the same objects as then: one added since leaves the
     * world, with its present state; one removed since is back. Otherwise the units of this world with the same ids stay,
     * and {@code new Unit} makes the missing ones.
     *
     * @param from the snapshot, which can be restored from again
     * @throws IllegalArgumentException if nothing was saved into the snapshot
     * @throws IllegalStateException if called from a {@link StepListener}, or if a unit of the snapshot is in another
     *     world by now; nothing is changed then
     */
    public void restore(Snapshot from) {
        restore(from, id -> new Unit(1));
    }

    /**
     * Makes this world what it was, or another one is, in a snapshot; with the caller's own class of units.
     *
     * @param from the snapshot
     * @param factory makes a unit, in no world, for an id that is missing here; its state is then that of the snapshot
     * @throws IllegalArgumentException if nothing was saved into the snapshot
     * @throws NullPointerException if the factory returns null; nothing is changed then
     * @throws IllegalStateException as in {@link #restore(Snapshot)}, or if the factory returns a unit that is in a world
     *     or that it has returned before; nothing is changed then
     */
    public void restore(Snapshot from, LongFunction<? extends Unit> factory) {
        Check.notNull("from", from);
        Check.notNull("factory", factory);
        refuseWhileStepping();
        from.requireSaved();
        members.set(from.world == this ? from.units : unitsFor(from, factory), from.columns.id, from.size);
        from.columns.copyRows(from.size, columns, from.interpolating);
        clock.set(from.clock);
        timestep = clock.timestep();
        how = from.how;
        lastId = from.lastId;
        interpolating = from.interpolating;
    }

    private Unit[] unitsFor(Snapshot from, LongFunction<? extends Unit> factory) {
        Unit[] wanted = new Unit[from.size];
        Set<Unit> made = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int i = 0; i < from.size; i++) {
            long id = from.columns.id[i];
            wanted[i] = find(id);
            if (wanted[i] != null) continue;
            wanted[i] = Check.notNull("the factory's unit", factory.apply(id));
            if (wanted[i].getWorld() != null || !made.add(wanted[i])) {
                throw new IllegalStateException("the factory must make a new unit for id " + id + ", not " + wanted[i]);
            }
        }
        return wanted;
    }

    /**
     * Checks that this thread's arithmetic is Java's, without which worlds on two machines drift apart: native code, such
     * as a library built for fast arithmetic, can switch a thread or all that it starts to flush tiny numbers to 0. Call
     * it on the thread that steps, once native libraries are loaded.
     *
     * @throws IllegalStateException if it flushes subnormal numbers, as results or as operands; the message says which
     */
    public static void checkArithmetic() {
        boolean results = Double.doubleToRawLongBits(smallestNormal / 2) == 0;
        boolean operands = Double.doubleToRawLongBits(smallest * 0x1p100) == 0;
        if (results || operands) {
            throw new IllegalStateException("this thread flushes subnormal numbers to 0, as "
                    + (results ? operands ? "results and operands" : "results" : "operands")
                    + ": native code has changed its floating-point mode (FTZ, DAZ)");
        }
    }

    private static float narrow(double v) {
        return (float) Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, v));
    }

    double interpolate(double previous, double present) {
        return interpolating ? previous + (present - previous) * clock.alpha() : present;
    }
}
