package yarts.physics;

import java.util.Arrays;

/**
 * What a {@link World} was at one moment: to go back to it, to write it to a file, to send it to a player who joins late,
 * or to find out in what two worlds differ. It holds all that the world's future depends on, and where units are drawn:
 * the integrator, the timestep, where the world stands in time, the units' ids, order and state, and the forces held for
 * later. The step listener and the pool stay the world's own, and so do the fields of a class that extends {@link Unit}.
 *
 * <pre>{@code
 * Snapshot before = world.save();
 * world.step(dt);
 * world.restore(before);              // as if the step had never been
 * byte[] file = before.toBytes();
 * other.restore(Snapshot.fromBytes(file));
 * }</pre>
 *
 * <p>Restored in the world it was taken of, it brings back the same units as objects: one added since leaves the world,
 * with its present state; one removed since is back. In another world, or from bytes, the units with the same ids stay,
 * and those that are missing are made.
 */
public final class Snapshot {
    /** The state of the world this was taken of; null if of none, or if it comes from bytes. */
    State source;

    /** That world's units. */
    Unit[] units = {};

    /** Null if nothing was saved yet. */
    private State state;

    /** Creates an empty snapshot, for {@link World#save(Snapshot)}. */
    public Snapshot() {}

    /** Becomes a world's; or stays as it was, if there is no memory for that. */
    void take(State source, Unit[] units) {
        int n = source.table.size();
        Unit[] own = this.units.length < n ? new Unit[units.length] : this.units;
        State copy = state == null ? new State(source.integrator, source.clock.timestep()) : state;
        copy.set(source);
        state = copy;
        this.source = source;
        System.arraycopy(units, 0, own, 0, n);
        Arrays.fill(own, n, own.length, null); // and keep none alive for nothing
        this.units = own;
    }

    State state() {
        if (state == null) throw new IllegalArgumentException("the snapshot is empty: nothing was saved into it");
        return state;
    }

    /** {@return the number of units} */
    public int size() {
        return state == null ? 0 : state.table.size();
    }

    /** {@return the number of steps that the world had run} */
    public long getTick() {
        return state == null ? 0 : state.clock.tick();
    }

    /**
     * {@return the snapshot as bytes, for a file or another machine} Their format is described field by field in
     * docs/snapshots.md; it does not depend on the machine.
     *
     * @throws IllegalArgumentException if nothing was saved into this snapshot
     */
    public byte[] toBytes() {
        return SnapshotFormat.write(state());
    }

    /**
     * {@return the snapshot that some bytes of {@link #toBytes} are of} Its units are yet to be made; {@link
     * World#restore(Snapshot)} does that. Bytes that were cut, damaged or made up are refused, unless what they say is a
     * state that a world can be in: a checksum is no signature, and whoever can write the bytes can make up such a state.
     *
     * @param bytes the bytes
     * @throws IllegalArgumentException if they are not a snapshot's; the message says what is wrong
     */
    public static Snapshot fromBytes(byte[] bytes) {
        Snapshot snapshot = new Snapshot();
        snapshot.state = SnapshotFormat.read(Check.notNull("bytes", bytes));
        return snapshot;
    }

    /**
     * {@return in what this snapshot and another differ, for a log; empty if in nothing} First what is the world's own,
     * then unit by unit: a line for each value that differs, this one's and the other's, in hexadecimal and in decimal. After
     * 100 lines it says how many more there are.
     *
     * @param other the other snapshot
     * @throws IllegalArgumentException if nothing was saved into one of them
     */
    public String difference(Snapshot other) {
        return Difference.of(state(), Check.notNull("other", other).state());
    }
}
