package yarts.physics;

import java.util.Arrays;

/**
 * The state of a {@link World} at one moment, for rollback, saved games, players who join late, and the comparison of
 * worlds.
 *
 * <pre>{@code
 * Snapshot before = world.save();
 * world.step(dt);
 * world.restore(before);              // as if the step had not happened
 * byte[] file = before.toBytes();
 * other.restore(Snapshot.fromBytes(file));
 * }</pre>
 *
 * <p>A snapshot contains everything that future steps and interpolated positions depend on: integrator, timestep, time,
 * and the ids, order, state and forces of the units. It does not contain listeners, the pool, or fields of classes that
 * extend {@link Unit}.
 *
 * <p>A restore into the world that was saved restores the same unit objects: a unit that was added since leaves the
 * world with its present state; a unit that was removed since returns. A restore into another world, or from bytes,
 * keeps the units whose ids are in the snapshot, removes the others, and creates missing ones.
 *
 * <p>Not thread-safe.
 */
public final class Snapshot {
    /**
     * The state object of the saved world, which identifies that world; null if the snapshot is empty or read from
     * bytes.
     */
    State source;

    /** The units of that world. */
    Unit[] units = {};

    /** Null if nothing has been saved. */
    private State state;

    /** The number of restores from this snapshot that are running. */
    int restores;

    /** Creates an empty snapshot, to be filled by {@link World#save(Snapshot)}. */
    public Snapshot() {}

    /** Saves the state of a world. If this throws an exception or error, this snapshot is unchanged. */
    void take(State source, Unit[] units) {
        if (restores > 0) {
            throw new IllegalStateException(
                    "a restore from this snapshot is running: until it ends, the factory must not save into it");
        }
        int n = source.table.size;
        Unit[] own = this.units.length < n ? new Unit[units.length] : this.units;
        State copy = state == null ? new State(source.integrator, source.clock.timestep()) : state;
        copy.copy(source);
        state = copy;
        this.source = source;
        System.arraycopy(units, 0, own, 0, n);
        Arrays.fill(own, n, own.length, null); // lets other units be garbage-collected
        this.units = own;
    }

    State state() {
        if (state == null) throw new IllegalArgumentException("the snapshot is empty: nothing was saved into it");
        return state;
    }

    /** {@return the number of units; 0 if nothing was saved} */
    public int size() {
        return state == null ? 0 : state.table.size;
    }

    /** {@return the number of steps that the world had run; 0 if nothing was saved} */
    public long getTick() {
        return state == null ? 0 : state.clock.tick();
    }

    /**
     * {@return the snapshot as bytes, for a file or another machine} The format is the same on every machine: 160 bytes
     * per unit and 132 more. docs/snapshots.md describes each field.
     *
     * @throws IllegalArgumentException if nothing was saved into this snapshot, or if the bytes would not fit into an array
     *     (more than 13 million units)
     */
    public byte[] toBytes() {
        return SnapshotFormat.write(state());
    }

    /**
     * Reads a snapshot from bytes that were written by {@link #toBytes}. Its units are created by {@link
     * World#restore(Snapshot)}. Bytes that are truncated, damaged or describe an impossible state are rejected. The
     * checksum is no signature: it does not prevent the forgery of a possible state.
     *
     * @param bytes the bytes, which are copied
     * @return the snapshot
     * @throws IllegalArgumentException if the bytes are not a valid snapshot; the message names the fault
     */
    public static Snapshot fromBytes(byte[] bytes) {
        Snapshot snapshot = new Snapshot();
        snapshot.state = SnapshotFormat.read(Check.notNull("bytes", bytes));
        return snapshot;
    }

    /**
     * {@return the differences between this snapshot and another, one per line, for a log; empty if there are none}
     * Values of the world come first, then values of units. Each line gives the value in this snapshot and the value in
     * the other, in hexadecimal and in decimal. After 100 lines, one more line gives the number of the remaining
     * differences.
     *
     * @param other the other snapshot
     * @throws IllegalArgumentException if nothing was saved into one of the two snapshots
     */
    public String difference(Snapshot other) {
        return Difference.of(state(), Check.notNull("other", other).state());
    }

    /** {@return a description for logs: the number of units and the tick} */
    @Override
    public String toString() {
        return state == null ? "Snapshot[empty]" : "Snapshot[" + size() + " units, tick=" + getTick() + "]";
    }
}
