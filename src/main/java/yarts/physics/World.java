package yarts.physics;

import java.util.Arrays;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.function.LongFunction;
import java.util.function.Predicate;

/**
 * A set of units that are stepped together, at fixed or variable timesteps.
 *
 * <pre>{@code
 * World world = new World();                         // EXACT, 60 steps per second
 * world.addBeforeStep((w, dt) -> steer(w));
 * // every frame:
 * world.advance(secondsSinceLastFrame);
 * world.copyPositions(buffer, 0);
 * }</pre>
 *
 * <p>Units have the indices 0 to size − 1, in the order in which they were added; a removal gives the index of the removed
 * unit to the last one. Units do not act on one another: each moves as it would alone, to the bit.
 *
 * <p>Once it has grown to its size, a world steps, draws, finds, saves and restores without allocating memory. The
 * exceptions are a pool ({@link #setPool}), and a restore by which units leave or are created. Not safe for use by
 * several threads at once.
 */
public final class World implements Iterable<Unit> {
    private static final StepListener[] NO_LISTENERS = {};

    final State state;
    private final Stepper stepper = new Stepper();
    private final Members members;
    private final List<Unit> units;
    /** Replaced by every change, so that a loop over one sees the listeners of its beginning. */
    private StepListener[] before = NO_LISTENERS, after = NO_LISTENERS;
    /** The operation during which the world must not be stepped, saved, restored or set; null if there is none. */
    private String running;

    /** Creates an empty world with {@link Integrator#EXACT} and 60 fixed steps per second. */
    public World() {
        this(Integrator.EXACT, Timestep.fixed(60));
    }

    /**
     * Creates an empty world.
     *
     * @param integrator the method by which a step is computed
     * @param timestep the rule by which {@link #advance} turns time into steps
     */
    public World(Integrator integrator, Timestep timestep) {
        state = new State(Check.notNull("integrator", integrator), Check.notNull("timestep", timestep));
        state.table.owner = this;
        members = new Members(state);
        units = Collections.unmodifiableList(members);
    }

    /** {@return the method by which a step is computed} */
    public Integrator getIntegrator() {
        return state.integrator;
    }

    /**
     * Sets the method by which a step is computed from now on.
     *
     * @param integrator the integrator
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void setIntegrator(Integrator integrator) {
        checkIdle();
        state.integrator = Check.notNull("integrator", integrator);
    }

    /** {@return the rule by which {@link #advance} turns time into steps} */
    public Timestep getTimestep() {
        return state.clock.timestep();
    }

    /**
     * Sets the rule by which {@link #advance} turns time into steps from now on. Time that waits for a step and pending
     * impulses keep their values; {@link #getAlpha()} follows from them, so that the picture may jump by a part of a step.
     * On a change to variable steps, the waiting time is added to the next advance. The waiting time, less than a second, may
     * be longer than a new step: then the next advance, even by 0, runs steps for it.
     *
     * @param timestep the timestep
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void setTimestep(Timestep timestep) {
        checkIdle();
        state.clock.setTimestep(Check.notNull("timestep", timestep));
        state.interpolating = state.interpolating && timestep.isFixed();
    }

    /**
     * Adds a unit, as the last one. It keeps its state, but not the forces that were applied before. It gets the next
     * {@linkplain Unit#getId() id}.
     *
     * @param <U> the unit's own type
     * @param unit a unit that is in no world
     * @return the unit
     * @throws IllegalStateException if the unit is in a world
     */
    public <U extends Unit> U add(U unit) {
        World world = Check.notNull("unit", unit).getWorld();
        if (world != null) {
            throw new IllegalStateException("a unit can be in one world only, and this one is in "
                    + (world == this ? "this world already: " : "another: ") + unit);
        }
        members.append(unit, state.lastId + 1);
        state.lastId++;
        return unit;
    }

    /**
     * Removes a unit. It keeps its state, but not the forces that have not acted yet.
     *
     * @param unit a unit, or null
     * @return whether the unit was in this world
     */
    public boolean remove(Unit unit) {
        if (!contains(unit)) return false;
        members.remove(unit.row);
        return true;
    }

    /**
     * Removes all units that match the filter, in the order of {@link #iterator()}. If the filter throws an exception, those
     * that matched before it are removed.
     *
     * @param filter called once for each unit
     * @return whether any unit was removed
     * @throws java.util.ConcurrentModificationException if the filter adds or removes units
     */
    public boolean removeIf(Predicate<? super Unit> filter) {
        return members.removeIf(filter);
    }

    /** Removes all units, in constant time apart from clearing their forces. Time and ids continue. */
    public void clear() {
        members.clear();
    }

    /**
     * {@return whether a unit is in this world} In constant time.
     *
     * @param unit a unit, or null
     */
    public boolean contains(Unit unit) {
        return unit != null && members.has(unit);
    }

    /** {@return the number of units} */
    public int size() {
        return members.size();
    }

    /**
     * {@return the unit with an index}
     *
     * @param index from 0 to size − 1
     * @throws IndexOutOfBoundsException if the index is out of range
     */
    public Unit get(int index) {
        return members.get(index);
    }

    /**
     * {@return the unit with an id, or null if it is not in this world} In constant time.
     *
     * @param id an id as of {@link Unit#getId()}
     */
    public Unit find(long id) {
        return members.find(id);
    }

    /** {@return the units in order: a live view that cannot be modified} Its iterators are as {@link #iterator()}. */
    public List<Unit> units() {
        return units;
    }

    /**
     * {@return an iterator over the units in order} Its {@code remove} is the only change that may happen during the
     * iteration; every other unit is then still visited once. After any other change, {@code hasNext} and {@code next}
     * throw a {@link java.util.ConcurrentModificationException}.
     */
    @Override
    public Iterator<Unit> iterator() {
        return members.iterator();
    }

    /** Runs one step of the timestep's own length: 1/rate seconds, or the longest one if steps are variable. */
    public void step() {
        step(getTimestep().maxStep);
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
        begin("a step");
        try {
            Impulses.useWaiting(state.table);
            run(dt, false);
        } finally {
            running = null;
            Impulses.end(state.table);
        }
    }

    /**
     * Advances by the time of a frame, in steps according to the {@link Timestep}. Forces applied before it act for the
     * elapsed time: their impulse F·elapsed is distributed evenly over the steps that the time turns into, and the part for
     * time not yet covered by a step stays pending. So a push that is applied once per frame has the same effect at any
     * frame rate.
     *
     * <p>Time beyond the limit of {@link Timestep#withMaxSteps} is dropped. {@link #getDroppedTime()} grows in every frame
     * if the game passes milliseconds instead of seconds, or cannot keep up: look at it if units seem slow or fly off.
     *
     * @param elapsed in seconds, from 0 to 1e9
     * @return the number of steps that were run
     * @throws IllegalArgumentException if elapsed is out of range
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public int advance(double elapsed) {
        elapsed = Check.time("elapsed", elapsed);
        begin("a step");
        try {
            return getTimestep().isFixed() ? advanceFixed(elapsed) : advanceVariable(elapsed);
        } finally {
            running = null;
        }
    }

    private int advanceFixed(double elapsed) {
        Clock clock = state.clock;
        Timestep timestep = clock.timestep();
        long before = clock.remainder(), due = clock.stepsDue(elapsed), after = clock.remainder();
        if (due == 0) {
            Impulses.hold(state.table, clock.seconds(after - before));
            return 0;
        }
        long old = clock.old(before, due);
        double kept = before > 0 ? (double) old / before : 0, covered = (double) due / timestep.rate;
        Impulses.begin(state.table, kept, clock.seconds(before - old), clock.seconds(after - old), covered, due > 1);
        return runFrame(due, timestep.maxStep, true);
    }

    private int advanceVariable(double elapsed) {
        Clock clock = state.clock;
        Timestep timestep = clock.timestep();
        double before = clock.takeRemainder(), covered = before + elapsed;
        if (covered == 0) {
            Impulses.discard(state.table);
            return 0;
        }
        double time = Math.min(covered, timestep.maxSteps * timestep.maxStep);
        if (time < covered) clock.drop(covered - time);
        long steps = Math.max(1, (long) (time / timestep.maxStep));
        if (time / steps > timestep.maxStep && steps < timestep.maxSteps) steps++;
        Impulses.begin(state.table, 0, before, 0, covered, steps > 1);
        return runFrame(steps, Math.min(time / steps, timestep.maxStep), false);
    }

    /** Runs the steps that are due, as far as the limit allows, with the frame's forces in each; drops the others. */
    private int runFrame(long due, double dt, boolean interpolating) {
        long start = state.clock.tick();
        int n = (int) Math.min(due, state.clock.timestep().maxSteps);
        try {
            for (int i = 0; i < n; i++) {
                if (i > 0) Impulses.repeat(state.table);
                run(dt, interpolating);
            }
            return n;
        } finally {
            state.clock.drop(due - (state.clock.tick() - start), dt);
            Impulses.end(state.table);
        }
    }

    /** Runs the listeners and the step. If a before-step listener throws, the step does not run. */
    private void run(double dt, boolean interpolating) {
        try {
            call(before, dt);
        } catch (Throwable e) {
            Impulses.discard(state.table);
            throw e;
        }
        stepper.step(state.table, dt, state.integrator);
        state.clock.ran(dt);
        state.lastSteppedId = state.lastId;
        state.interpolating = interpolating;
        call(after, dt);
    }

    private void call(StepListener[] listeners, double dt) {
        for (StepListener listener : listeners) listener.onStep(this, dt);
    }

    private void begin(String operation) {
        checkIdle();
        running = operation;
    }

    private void checkIdle() {
        if (running == null) return;
        throw new IllegalStateException(
                running + " of this world is running: until it ends, no listener, factory or other"
                        + " thread may step, save, restore or set the world");
    }

    /**
     * {@return the fraction of the next fixed step that has elapsed, in [0, 1), also as a float} With variable steps it
     * is 0.
     */
    public double getAlpha() {
        return state.clock.alpha();
    }

    /** The fraction of the last step at which units are drawn. */
    double drawnAlpha() {
        return state.interpolating ? getAlpha() : 1;
    }

    /** Whether a unit of this world took part in the last step. */
    boolean hasStepped(Unit unit) {
        return unit.getId() <= state.lastSteppedId;
    }

    /** {@return the number of steps that were run} */
    public long getTick() {
        return state.clock.tick();
    }

    /** {@return the simulated time in seconds: the sum of all steps} */
    public double getTime() {
        return state.clock.time();
    }

    /**
     * {@return the time in seconds that {@link #advance} has dropped: beyond the limit of steps, or of steps that did not run
     * because a listener threw an exception}
     */
    public double getDroppedTime() {
        return state.clock.droppedTime();
    }

    /**
     * Adds a listener that is called before each step, after those that were added earlier. If it is added during a step,
     * it is called from the next phase of listeners on.
     *
     * @param listener the listener; it is called as often per step as it was added
     */
    public void addBeforeStep(StepListener listener) {
        before = with(before, listener);
    }

    /**
     * Adds a listener that is called after each step, after those that were added earlier. If it is added during a step, it
     * is called from the next phase of listeners on.
     *
     * @param listener the listener; it is called as often per step as it was added
     */
    public void addAfterStep(StepListener listener) {
        after = with(after, listener);
    }

    private static StepListener[] with(StepListener[] listeners, StepListener listener) {
        Check.notNull("listener", listener);
        StepListener[] more = Arrays.copyOf(listeners, listeners.length + 1);
        more[listeners.length] = listener;
        return more;
    }

    /**
     * Removes all registrations of a listener, before and after the step. It must be the same object that was added: two uses of
     * a lambda or of a method reference are different objects. If it is removed during a step, it is not called
     * from the next phase of listeners on.
     *
     * @param listener the same object that was added, or null
     * @return whether the listener was registered
     */
    public boolean removeStepListener(StepListener listener) {
        int count = before.length + after.length;
        before = without(before, listener);
        after = without(after, listener);
        return before.length + after.length < count;
    }

    private static StepListener[] without(StepListener[] listeners, StepListener listener) {
        StepListener[] others = new StepListener[listeners.length];
        int n = 0;
        for (StepListener other : listeners) if (other != listener) others[n++] = other;
        return Arrays.copyOf(others, n);
    }

    /**
     * Sets a pool whose threads share the work of a step with the calling thread, in worlds of about 30,000 units or more.
     * At most as many threads work as the pool's parallelism says, the caller included; of {@link
     * ForkJoinPool#commonPool}, all threads and the caller. The results are the same to the bit, and a step has ended when
     * the call that runs it returns. A pool that is busy, shut down or without threads leaves the work to the caller. Each
     * step with a pool allocates a few objects.
     *
     * @param pool the pool, which the caller must shut down; null for none
     */
    public void setPool(ForkJoinPool pool) {
        stepper.crew = pool == null ? null : new Team(pool, Stepper.LEAST);
    }

    /**
     * Applies a force to every unit, as {@link Unit#applyForce} does: fx0, fy0, fx1, fy1, … in order.
     *
     * @param xy in N, each at most 1e50 in magnitude
     * @param offset the index of fx0
     * @throws IllegalArgumentException if an element is out of range; no force is applied then
     * @throws IndexOutOfBoundsException if the array has less than 2·size elements from offset on; no force is applied then
     */
    public void applyForces(double[] xy, int offset) {
        Bulk.applyForces(state.table, xy, offset);
    }

    /**
     * Copies the positions at which to draw all units ({@link Unit#getInterpolatedX()}), in order, as x0, y0, x1, y1, …
     *
     * @param xy the array to copy to; values beyond the range of float become the largest float
     * @param offset the index of x0
     * @throws IndexOutOfBoundsException if the array has less than 2·size elements from offset on; nothing is copied then
     */
    public void copyPositions(float[] xy, int offset) {
        Bulk.copyPositions(state.table, xy, offset, drawnAlpha());
    }

    /**
     * Copies positions as {@link #copyPositions(float[], int)}, for a game that keeps the time itself.
     *
     * @param xy the array to copy to
     * @param offset the index of x0
     * @param alpha the fraction from the positions before the last step, 0, to those after it, 1
     * @throws IllegalArgumentException if alpha is out of range
     */
    public void copyPositions(float[] xy, int offset, double alpha) {
        Bulk.copyPositions(state.table, xy, offset, Check.part("alpha", alpha));
    }

    /**
     * Copies positions as {@link #copyPositions(float[], int, double)}, in full precision. With an alpha of 1, these are
     * {@link Unit#getX()} and {@link Unit#getY()}.
     *
     * @param xy the array to copy to
     * @param offset the index of x0
     * @param alpha the fraction from the positions before the last step, 0, to those after it, 1
     * @throws IllegalArgumentException if alpha is out of range
     */
    public void copyPositions(double[] xy, int offset, double alpha) {
        Bulk.copyPositions(state.table, xy, offset, Check.part("alpha", alpha));
    }

    /**
     * Copies the velocities of all units, in order, as vx0, vy0, vx1, vy1, …
     *
     * @param xy the array to copy to
     * @param offset the index of vx0
     * @throws IndexOutOfBoundsException if the array has less than 2·size elements from offset on; nothing is copied then
     */
    public void copyVelocities(double[] xy, int offset) {
        Bulk.copyVelocities(state.table, xy, offset);
    }

    /**
     * {@return a hash of everything that a {@link Snapshot} contains} Worlds with the same history have the same hash, on
     * any JVM and machine. Worlds that differ in one bit have different hashes; those that differ in more, almost always.
     */
    public long stateHash() {
        return state.hash();
    }

    /**
     * {@return a new snapshot of this world}
     *
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public Snapshot save() {
        Snapshot snapshot = new Snapshot();
        save(snapshot);
        return snapshot;
    }

    /**
     * Saves this world into a snapshot. A snapshot that is used again allocates nothing.
     *
     * @param into the snapshot; its previous content is lost
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void save(Snapshot into) {
        Check.notNull("into", into);
        checkIdle();
        into.take(state, members.array());
    }

    /**
     * Restores this world to the state in a snapshot, which may be of another world. Missing units are created by
     * {@code new Unit}.
     *
     * @param from the snapshot, which can be restored from again
     * @throws IllegalArgumentException if nothing was saved into the snapshot
     * @throws IllegalStateException if called from a {@link StepListener}, or if a unit of the snapshot is now in another
     *     world; nothing is changed then
     */
    public void restore(Snapshot from) {
        restore(from, id -> new Unit(1));
    }

    /**
     * Restores this world to the state in a snapshot, which may be of another world. A factory creates missing units.
     *
     * @param from the snapshot, as in {@link #restore(Snapshot)}
     * @param factory returns a new unit for an id; the unit then gets the saved state. It must not change this world
     * @throws IllegalArgumentException if nothing was saved into the snapshot
     * @throws NullPointerException if the factory returns null; nothing is changed then
     * @throws IllegalStateException as {@link #restore(Snapshot)}, or if the factory changes this world, or returns a unit
     *     that is in a world or that it has returned before; the restore changes nothing then
     */
    public void restore(Snapshot from, LongFunction<? extends Unit> factory) {
        Check.notNull("from", from);
        Check.notNull("factory", factory);
        begin("a restore");
        try {
            members.restore(from.state(), from.source == state ? from.units : null, factory);
        } finally {
            running = null;
        }
    }

    /**
     * Checks that this thread does Java's arithmetic, without which worlds on two machines drift apart: native code can
     * switch a thread to flush tiny numbers to 0. Call it on the thread that steps, after native libraries were loaded.
     *
     * @throws IllegalStateException if it does not; the message says what it does instead
     */
    public static void checkArithmetic() {
        Check.arithmetic();
    }

    /** {@return a description for logs: number of units, tick, time, integrator and timestep} */
    @Override
    public String toString() {
        return "World[" + size() + " units, tick=" + getTick() + ", time=" + getTime() + ", " + getIntegrator() + ", "
                + getTimestep() + "]";
    }
}
