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
 * <p>Units have the indices 0 to size − 1, in the order in which they were added; when a unit is removed, the last one
 * takes its index. Units do not act on one another: each moves exactly as it would alone, to the bit.
 *
 * <p>A world whose number of units does not grow allocates no memory for steps, positions, searches, saves and
 * restores. The exceptions are a pool ({@link #setPool}), and a restore in which units leave or are created.
 *
 * <p>Not thread-safe.
 */
public final strictfp class World implements Iterable<Unit> {
    private static final StepListener[] NO_LISTENERS = {};

    final State state;
    private final Stepper stepper = new Stepper();
    private final Members members;
    private final List<Unit> units;
    /** Every change replaces the array, so that a loop that is running continues over the old one. */
    private StepListener[] before = NO_LISTENERS, after = NO_LISTENERS;
    /**
     * The running operation, during which the world must not be stepped, saved, restored or set; null if there is none.
     */
    private String running;

    /** Creates an empty world with {@link Integrator#EXACT} and 60 fixed steps per second. */
    public World() {
        this(Integrator.EXACT, Timestep.fixed(60));
    }

    /**
     * Creates an empty world, such as {@code new World(Integrator.EULER, Timestep.fixed(20))}.
     *
     * @param integrator the method that computes each step
     * @param timestep the rule by which {@link #advance} divides time into steps
     */
    public World(Integrator integrator, Timestep timestep) {
        state = new State(Check.notNull("integrator", integrator), Check.notNull("timestep", timestep));
        state.table.owner = this;
        members = new Members(state);
        units = Collections.unmodifiableList(members);
    }

    /** {@return the method that computes each step} */
    public Integrator getIntegrator() {
        return state.integrator;
    }

    /**
     * Sets the method that computes each step from now on.
     *
     * @param integrator the integrator
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}
     */
    public void setIntegrator(Integrator integrator) {
        checkIdle();
        state.integrator = Check.notNull("integrator", integrator);
    }

    /** {@return the rule by which {@link #advance} divides time into steps} */
    public Timestep getTimestep() {
        return state.clock.timestep();
    }

    /**
     * Sets the rule by which {@link #advance} divides time into steps from now on. The time that waits for a step and
     * the pending impulses keep their values. {@link #getAlpha()} follows from them, so the interpolated positions may
     * jump by a part of a step. On a change to variable steps, the waiting time is added to the next advance. On a
     * change to shorter steps, the waiting time (less than a second) may exceed a step: the next advance, even by 0 s,
     * then runs steps for it, up to {@link Timestep#withMaxSteps}, and drops the rest.
     *
     * @param timestep the timestep
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}
     */
    public void setTimestep(Timestep timestep) {
        checkIdle();
        state.clock.setTimestep(Check.notNull("timestep", timestep));
    }

    /**
     * Adds a unit as the last one and returns it, as in {@code Tank tank = world.add(new Tank())}. The unit keeps its
     * state, but loses forces that have not acted and its pending impulse. It gets the next {@linkplain Unit#getId()
     * id}.
     *
     * @param <U> the class of the unit
     * @param unit a unit outside a world
     * @return the unit
     * @throws IllegalStateException if the unit is already in a world, this one or another
     */
    public <U extends Unit> U add(U unit) {
        World world = Check.notNull("unit", unit).getWorld();
        if (world != null) {
            throw new IllegalStateException("a unit can be in only one world, and this unit is in "
                    + (world == this ? "this world" : "another world") + " already: " + unit);
        }
        members.append(unit, state.lastId + 1);
        state.lastId++;
        return unit;
    }

    /**
     * Removes a unit. It keeps its state, but loses forces that have not acted and its pending impulse. The last unit
     * takes its index.
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
     * Removes all units that match the filter, in the order of {@link #iterator()}. If the filter throws an exception,
     * the units that matched before remain removed.
     *
     * @param filter returns whether to remove a unit; it is called once for each unit
     * @return whether any unit was removed
     * @throws java.util.ConcurrentModificationException if the filter adds or removes units
     */
    public boolean removeIf(Predicate<? super Unit> filter) {
        return members.removeIf(filter);
    }

    /**
     * Removes all units. They keep their state, but lose forces that have not acted and their pending impulses. Time
     * and ids continue.
     */
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
     * {@return the unit at an index}
     *
     * @param index the index, from 0 to size − 1
     * @throws IndexOutOfBoundsException if the index is out of range
     */
    public Unit get(int index) {
        return members.get(index);
    }

    /**
     * {@return the unit with an id, or null if it is not in this world} In constant time.
     *
     * @param id the id, as {@link Unit#getId()} returns it
     */
    public Unit find(long id) {
        return members.find(id);
    }

    /**
     * {@return an unmodifiable live view of the units, in order} Its iterators also throw a {@link
     * java.util.ConcurrentModificationException} after any change.
     */
    public List<Unit> units() {
        return units;
    }

    /**
     * {@return an iterator over the units, in order} During the iteration, units may be removed only by the iterator's
     * {@code remove}; it still visits every other unit once. After any other change, {@code hasNext} and {@code next}
     * throw a {@link java.util.ConcurrentModificationException}.
     */
    @Override
    public Iterator<Unit> iterator() {
        return members.iterator();
    }

    /**
     * Runs one step of the length {@link Timestep#getMaxStep()}: 1/60 s for {@code Timestep.fixed(60)}, 0.03 s for
     * {@code Timestep.variable(0.03)}.
     *
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}
     */
    public void step() {
        step(getTimestep().maxStep);
    }

    /**
     * Runs one step of exactly dt seconds. Forces that were applied before act for this time; if dt is 0, they are
     * discarded.
     *
     * @param dt in seconds, from 0 to 1e9
     * @throws IllegalArgumentException if dt is NaN or out of range
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}
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
     * Advances the world by the time of a frame, in steps according to the {@link Timestep}. Forces that were applied
     * before act for the elapsed time: their impulse F·elapsed is distributed evenly over the steps, and the part that
     * belongs to time not yet covered by a step stays pending. So a force that is applied in every frame has the same
     * effect at any frame rate. If elapsed is 0, these forces are discarded.
     *
     * <p>Time beyond the limit of {@link Timestep#withMaxSteps} is dropped. If the game passes milliseconds instead of
     * seconds, or is too slow, {@link #getDroppedTime()} grows in every frame: check it if units seem slow or fly off.
     *
     * @param elapsed the seconds since the last call, from 0 to 1e9
     * @return the number of steps that were run
     * @throws IllegalArgumentException if elapsed is NaN or out of range
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}
     */
    public int advance(double elapsed) {
        elapsed = Check.time("elapsed", elapsed);
        begin("a step");
        try {
            if (elapsed == 0) Impulses.discard(state.table);
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
        if (covered == 0) return 0;
        double time = Math.min(covered, timestep.maxSteps * timestep.maxStep);
        if (time < covered) clock.drop(covered - time);
        long steps = Math.max(1, (long) (time / timestep.maxStep));
        if (time / steps > timestep.maxStep && steps < timestep.maxSteps) steps++;
        Impulses.begin(state.table, 0, before, 0, covered, steps > 1);
        return runFrame(steps, Math.min(time / steps, timestep.maxStep), false);
    }

    /** Runs the steps that are due, up to the limit, with the forces of the frame in each. Drops the other steps. */
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
                running + " of this world is running: until it ends, no listener, factory or other thread"
                        + " may step, save or restore the world, or set its integrator or timestep");
    }

    /**
     * {@return the fraction of the next fixed step that has elapsed, in [0, 1)} It is below 1 as a float, too. With
     * variable steps it is 0.
     */
    public double getAlpha() {
        return state.clock.alpha();
    }

    /** The fraction of the last step at which units are drawn: 1 for the positions after it. */
    double drawnAlpha() {
        return state.interpolating && getTimestep().isFixed() ? getAlpha() : 1;
    }

    /** Whether a unit of this world took part in the last step. */
    boolean hasStepped(Unit unit) {
        return unit.getId() <= state.lastSteppedId;
    }

    /** {@return the number of steps that have run} */
    public long getTick() {
        return state.clock.tick();
    }

    /** {@return the simulated time in seconds: the sum of all steps} */
    public double getTime() {
        return state.clock.time();
    }

    /**
     * {@return the time that {@link #advance} has dropped in all, in seconds: time beyond the limit of steps, and steps
     * that did not run because a listener threw an exception}
     */
    public double getDroppedTime() {
        return state.clock.droppedTime();
    }

    /**
     * Adds a listener that is called before each step, such as {@code (w, dt) -> steer(w)}. Listeners are called in the
     * order in which they were added. A listener that is added during a step is first called before the next step.
     *
     * @param listener the listener. It is called as often per step as it was added. Keep a lambda or a method reference
     *     in a variable to remove it later: {@link #removeStepListener} compares listeners by identity
     */
    public void addBeforeStep(StepListener listener) {
        before = with(before, listener);
    }

    /**
     * Adds a listener that is called after each step, such as {@code (w, dt) -> resolveWalls(w)}. Listeners are called
     * in the order in which they were added. If a before-step listener adds it, it is first called after that step; if
     * an after-step listener adds it, after the next one.
     *
     * @param listener the listener. It is called as often per step as it was added. Keep a lambda or a method reference
     *     in a variable to remove it later: {@link #removeStepListener} compares listeners by identity
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
     * Removes all registrations of a listener, before and after steps. Listeners are compared by identity: keep a
     * lambda or a method reference in a variable, because writing the same expression again creates another object.
     *
     * <pre>{@code
     * StepListener gravity = (w, dt) -> applyGravity(w);
     * world.addBeforeStep(gravity);
     * world.removeStepListener(gravity);
     * }</pre>
     *
     * <p>If a listener is removed during the calls before (or after) a step, these calls still include it, but no later
     * ones do.
     *
     * @param listener the object that was added, or null
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
     * Sets a pool whose threads share the work of each step with the calling thread, in worlds of about 30,000 units or
     * more. The results are the same to the bit, and all work is done when the call returns. The number of threads that
     * work is at most the parallelism of the pool, including the calling thread (for {@link ForkJoinPool#commonPool},
     * one more). If the pool is busy, shut down or without threads, the calling thread does the work. Each step with a
     * pool allocates a few objects.
     *
     * @param pool the pool, which the game must shut down itself; null for none
     */
    public void setPool(ForkJoinPool pool) {
        stepper.crew = pool == null ? null : new Team(pool, Stepper.MIN_TILES);
    }

    /**
     * Applies a force to every unit, as {@link Unit#applyForce} does, from an array with fx0, fy0, fx1, fy1, … in the
     * order of the indices.
     *
     * @param xy the components in N, each at most 1e50 in magnitude
     * @param offset the index of fx0 in the array
     * @throws IllegalArgumentException if a component is NaN or out of range; no force is applied
     * @throws IndexOutOfBoundsException if the array has fewer than 2·size elements from offset on; no force is applied
     */
    public void applyForces(double[] xy, int offset) {
        Bulk.applyForces(state.table, xy, offset);
    }

    /**
     * Copies the positions at which to draw all units ({@link Unit#getInterpolatedX()}), in m, as x0, y0, x1, y1, … in
     * the order of the indices.
     *
     * @param xy the array to copy to; a value beyond the range of float becomes the largest float of its sign
     * @param offset the index of x0 in the array
     * @throws IndexOutOfBoundsException if the array has fewer than 2·size elements from offset on; nothing is copied
     */
    public void copyPositions(float[] xy, int offset) {
        Bulk.copyPositions(state.table, xy, offset, drawnAlpha());
    }

    /**
     * Copies positions between those before and after the last step, for a game that keeps the time itself.
     *
     * @param xy the array to copy to, as in {@link #copyPositions(float[], int)}
     * @param offset the index of x0 in the array
     * @param alpha the fraction of the last step, from 0 (the positions before it) to 1 (those after it)
     * @throws IllegalArgumentException if alpha is NaN or out of range; nothing is copied
     * @throws IndexOutOfBoundsException if the array has fewer than 2·size elements from offset on; nothing is copied
     */
    public void copyPositions(float[] xy, int offset, double alpha) {
        Bulk.copyPositions(state.table, xy, offset, Check.part("alpha", alpha));
    }

    /**
     * Copies positions between those before and after the last step, in full precision. With an alpha of 1, they are
     * {@link Unit#getX()} and {@link Unit#getY()}. If all steps are run by {@link #advance} with fixed steps, {@code
     * world.copyPositions(xy, 0, world.getAlpha())} copies the positions at which to draw, the same values as {@link
     * Unit#getInterpolatedX()}. After other steps, these positions are those with an alpha of 1.
     *
     * @param xy the array to copy to, in m, as x0, y0, x1, y1, … in the order of the indices
     * @param offset the index of x0 in the array
     * @param alpha the fraction of the last step, from 0 (the positions before it) to 1 (those after it)
     * @throws IllegalArgumentException if alpha is NaN or out of range; nothing is copied
     * @throws IndexOutOfBoundsException if the array has fewer than 2·size elements from offset on; nothing is copied
     */
    public void copyPositions(double[] xy, int offset, double alpha) {
        Bulk.copyPositions(state.table, xy, offset, Check.part("alpha", alpha));
    }

    /**
     * Copies the velocities of all units, in m/s, as vx0, vy0, vx1, vy1, … in the order of the indices.
     *
     * @param xy the array to copy to
     * @param offset the index of vx0 in the array
     * @throws IndexOutOfBoundsException if the array has fewer than 2·size elements from offset on; nothing is copied
     */
    public void copyVelocities(double[] xy, int offset) {
        Bulk.copyVelocities(state.table, xy, offset);
    }

    /**
     * {@return a hash of everything that a {@link Snapshot} contains, to compare the worlds of several players} Worlds
     * with the same history have the same hash on every JVM and machine. If two worlds differ in a single bit, their
     * hashes differ; if they differ in several, almost always.
     */
    public long stateHash() {
        return state.hash();
    }

    /**
     * {@return a new snapshot of the state of this world}
     *
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}
     */
    public Snapshot save() {
        Snapshot snapshot = new Snapshot();
        save(snapshot);
        return snapshot;
    }

    /**
     * Saves the state of this world into an existing snapshot. A snapshot that already had as many units allocates
     * nothing.
     *
     * @param into the snapshot; its previous content is lost
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}, or
     *     during a restore from this snapshot; the snapshot is then unchanged
     */
    public void save(Snapshot into) {
        Check.notNull("into", into);
        checkIdle();
        into.take(state, members.array());
    }

    /**
     * Restores this world to the state in a snapshot, which may be of another world. Missing units are created by
     * {@code new Unit}; {@link Snapshot} describes when units return, leave or are created.
     *
     * @param from the snapshot; it can be restored any number of times
     * @throws IllegalArgumentException if nothing was saved into the snapshot
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener}, or if
     *     a unit of the snapshot is now in another world; this world is then unchanged
     */
    public void restore(Snapshot from) {
        restoreUnits(from, null);
    }

    /**
     * Restores this world to the state in a snapshot, which may be of another world, with a factory for missing units:
     * {@code world.restore(snapshot, id -> new Tank())}.
     *
     * @param from the snapshot; it can be restored any number of times
     * @param factory returns a new unit for an id; the restore then sets its state. It must not change this world or
     *     save into this snapshot
     * @throws IllegalArgumentException if nothing was saved into the snapshot
     * @throws NullPointerException if the factory returns null; this world is then unchanged
     * @throws IllegalStateException during a step or restore of this world, such as from a {@link StepListener} or from
     *     the factory; if a unit of the snapshot is now in another world; if the factory changes this world, saves into
     *     the snapshot, or returns a unit that is in a world or that it has returned before. The restore then changes
     *     nothing
     */
    public void restore(Snapshot from, LongFunction<? extends Unit> factory) {
        restoreUnits(from, Check.notNull("factory", factory));
    }

    /** Creates missing units by new Unit if the factory is null: Android below 7 and RoboVM have no LongFunction. */
    private void restoreUnits(Snapshot from, LongFunction<? extends Unit> factory) {
        Check.notNull("from", from);
        begin("a restore");
        from.restores++;
        try {
            members.restore(from.state(), from.source == state ? from.units : null, factory);
        } finally {
            from.restores--;
            running = null;
        }
    }

    /**
     * Checks that this thread computes as Java specifies, so that worlds on different machines stay the same. Native
     * code can set a mode in which a thread flushes subnormal numbers to 0. Call this on the thread that steps, after
     * loading native libraries.
     *
     * @throws IllegalStateException if this thread flushes subnormal numbers to 0; the message names operands or
     *     results
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
