package yarts.physics;

import java.util.Arrays;

/**
 * The state of a {@link World} at one moment: to return to it, to write it to a file, to send it to a player who joins
 * late, or to find the differences of two worlds. It contains everything that the world's future and the picture depend
 * on: integrator, timestep, time, and the units' ids, order, state, and forces that have not acted. It does not contain
 * listeners, the pool, or fields of classes that extend {@link Unit}.
 *
 * <pre>{@code
 * Snapshot before = world.save();
 * world.step(dt);
 * world.restore(before);              // as if the step had not happened
 * byte[] file = before.toBytes();
 * other.restore(Snapshot.fromBytes(file));
 * }</pre>
 *
 * <p>A restore into the world that was saved brings back the same unit objects: a unit added since leaves the world with
 * its present state; a unit removed since returns. In another world, or from bytes, the units that have the same ids
 * stay, and missing ones are created.
 *
 * <p>Not thread-safe.
 */
public final class Snapshot {
    /** The state of the world that was saved, to recognise that world; null if there is none or it comes from bytes. */
    State source;

    /** The units of that world. */
    Unit[] units = {};

    /** Null if nothing was saved yet. */
    private State state;

    /** Creates an empty snapshot, for {@link World#save(Snapshot)}. */
    public Snapshot() {}

    /** Saves a world's state; or stays unchanged if there is no memory for it. */
    void take(State source, Unit[] units) {
        int n = source.table.size;
        Unit[] own = this.units.length < n ? new Unit[units.length] : this.units;
        State copy = state == null ? new State(source.integrator, source.clock.timestep()) : state;
        copy.copy(source);
        state = copy;
        this.source = source;
        System.arraycopy(units, 0, own, 0, n);
        Arrays.fill(own, n, own.length, null); // so that it keeps no other units alive
        this.units = own;
    }

    State state() {
        if (state == null) throw new IllegalArgumentException("the snapshot is empty: nothing was saved into it");
        return state;
    }

    /** {@return the number of units} */
    public int size() {
        return state == null ? 0 : state.table.size;
    }

    /** {@return the number of steps that the world had run} */
    public long getTick() {
        return state == null ? 0 : state.clock.tick();
    }

    /**
     * {@return the snapshot as bytes, for a file or another machine} The format does not depend on the machine.
     * docs/snapshots.md describes it field by field: 160 bytes per unit and 132 more.
     *
     * @throws IllegalArgumentException if nothing was saved into this snapshot
     */
    public byte[] toBytes() {
        return SnapshotFormat.write(state());
    }

    /**
     * {@return the snapshot in bytes that were written by {@link #toBytes}} {@link World#restore(Snapshot)} creates its
     * units. Truncated, damaged or forged bytes are rejected unless they describe a state that a world can have. The
     * checksum is not a signature: anyone who can write the bytes can forge such a state.
     *
     * @param bytes the bytes
     * @throws IllegalArgumentException if they are not a valid snapshot; the message names the fault
     */
    public static Snapshot fromBytes(byte[] bytes) {
        Snapshot snapshot = new Snapshot();
        snapshot.state = SnapshotFormat.read(Check.notNull("bytes", bytes));
        return snapshot;
    }

    /**
     * {@return the differences between this snapshot and another, one per line, for a log; empty if there are none} The
     * values of the world come first, then those of the units. Each line has the value here and the value there, in
     * hexadecimal and in decimal. After 100 lines it reports only how many more there are.
     *
     * @param other the other snapshot
     * @throws IllegalArgumentException if nothing was saved into one of them
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
