package yarts.physics;

import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.function.LongFunction;
import java.util.function.Predicate;

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
 * <p>Units have the indices 0 to size − 1, in the order in which they were added; removing one gives its index to the last.
 * They do not act on one another: every unit moves as it would alone, to the bit. Once it has grown to its size, a world
 * steps, draws, saves and restores without garbage. Not safe for use by several threads at once.
 */
public final class World extends Simulation implements Iterable<Unit> {
    private final Members members = new Members(state.table);
    private final List<Unit> units = Collections.unmodifiableList(members);
    private StepListener listener;
    /** The last id that took part in the step which is being corrected; 0 if none is. */
    private long corrected;

    /** Creates an empty world with {@link Integrator#EULER} and 60 fixed steps a second. */
    public World() {
        this(Integrator.EULER, Timestep.fixed(60));
    }

    /**
     * Creates an empty world.
     *
     * @param integrator how to work out a step
     * @param timestep how {@link #advance} turns time into steps
     */
    public World(Integrator integrator, Timestep timestep) {
        super(integrator, timestep);
    }

    /**
     * Adds a unit, as the last, with its state, but not the forces applied before. It gets the next {@link Unit#getId() id}.
     *
     * @param <U> the unit's own type
     * @param unit a unit that is in no world
     * @return the unit
     * @throws IllegalStateException if the unit is in a world
     */
    public <U extends Unit> U add(U unit) {
        if (Check.notNull("unit", unit).world != null) {
            throw new IllegalStateException("a unit can be in one world only, and this one is in "
                    + (contains(unit) ? "this world already: " : "another: ") + unit);
        }
        members.append(unit, state.lastId + 1);
        state.lastId++;
        unit.world = this;
        return unit;
    }

    /**
     * Removes a unit, which keeps its state, but not the forces that have not acted yet.
     *
     * @param unit a unit, or null
     * @return whether the unit was in this world
     */
    public boolean remove(Unit unit) {
        if (!contains(unit)) return false;
        members.remove(unit.index());
        return true;
    }

    /**
     * Removes the units of which something is true, in the order of {@link #iterator()}.
     *
     * @param filter asked once of each; it must not change this world
     * @return whether any was removed
     */
    public boolean removeIf(Predicate<? super Unit> filter) {
        return members.removeIf(filter);
    }

    /** Removes all units. Time stays as it is. */
    public void clear() {
        members.clear();
    }

    /**
     * {@return whether a unit is in this world} In constant time.
     *
     * @param unit a unit, or null
     */
    public boolean contains(Unit unit) {
        return unit != null && unit.world == this;
    }

    /** {@return the number of units} */
    public int size() {
        return members.size();
    }

    /**
     * {@return the unit with an index}
     *
     * @param index from 0 to size − 1, or it is an {@link IndexOutOfBoundsException}
     */
    public Unit get(int index) {
        return members.get(index);
    }

    /**
     * {@return the unit with an id, or null if it is not in this world} In constant time, but for the first call.
     *
     * @param id of {@link Unit#getId()}
     */
    public Unit find(long id) {
        return members.find(id);
    }

    /** {@return the units in order: a live view that cannot be modified} */
    public List<Unit> units() {
        return units;
    }

    /**
     * {@return an iterator over the units in order} Its {@code remove} is the one change that it survives, and it visits
     * every other unit all the same; after others it throws {@link java.util.ConcurrentModificationException}.
     */
    @Override
    public Iterator<Unit> iterator() {
        return members.iterator();
    }

    @Override
    void beforeStep(double dt) {
        if (listener != null) listener.beforeStep(this, dt);
    }

    @Override
    void afterStep(double dt) {
        if (listener == null) return;
        corrected = state.lastId;
        try {
            listener.afterStep(this, dt);
        } finally {
            corrected = 0;
        }
    }

    /** Whether to put a unit somewhere is to correct a step. It is not if the unit came after the step. */
    boolean corrects(Unit unit) {
        return unit.getId() <= corrected;
    }

    /**
     * Sets what to call before and after each step.
     *
     * @param listener the listener, or null for none
     */
    public void setStepListener(StepListener listener) {
        this.listener = listener;
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
     * Saves this world into a snapshot. One that is used again creates no garbage.
     *
     * @param into what to save into; what it held before is lost
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void save(Snapshot into) {
        Check.notNull("into", into);
        refuseWhileStepping();
        into.take(state, members.array());
    }

    /**
     * Makes this world what it was, or another one is, in a snapshot; {@code new Unit} makes the units that are missing.
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
     * Makes this world what it was, or another one is, in a snapshot; a factory makes the units that are missing.
     *
     * @param from the snapshot, as in {@link #restore(Snapshot)}
     * @param factory makes a unit, in no world, for an id; it then gets the snapshot's state
     * @throws NullPointerException if the factory returns null; nothing is changed then
     * @throws IllegalStateException as there, or if it returns a unit that is in a world or that it has returned before;
     *     nothing is changed then
     */
    public void restore(Snapshot from, LongFunction<? extends Unit> factory) {
        Check.notNull("from", from);
        Check.notNull("factory", factory);
        refuseWhileStepping();
        State saved = from.state();
        members.set(from.source == state ? from.units : members.wanted(saved.table, factory), saved.table);
        state.set(saved);
        members.place();
        for (int i = 0; i < size(); i++) get(i).world = this;
    }

    /**
     * Checks that this thread's arithmetic is Java's, without which worlds on two machines drift apart: native code can
     * switch a thread to flush tiny numbers to 0. Call it on the thread that steps, once native libraries are loaded.
     *
     * @throws IllegalStateException if it does; the message says how
     */
    public static void checkArithmetic() {
        Check.arithmetic();
    }
}
