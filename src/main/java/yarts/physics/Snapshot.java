package yarts.physics;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.zip.CRC32C;

/**
 * What a {@link World} was at one moment: to go back to it, to write it to a file, to send it to a player who joins late,
 * or to find out in what two worlds differ.
 *
 * <pre>{@code
 * Snapshot before = new Snapshot();
 * world.save(before);
 * world.step(dt);
 * world.restore(before);              // as if the step had never been
 * byte[] file = before.toBytes();
 * other.restore(Snapshot.fromBytes(file));
 * }</pre>
 *
 * <p>A snapshot refers to the units it was taken of, so that they can come back as the same objects. Its bytes do not.
 */
public final class Snapshot {
    /** Of the format of {@link #toBytes}, which docs/snapshots.md describes. */
    private static final int VERSION = 1;

    private static final long MAGIC = 0x5948505354524159L; // "YARTSPHY", the first letter in the lowest byte
    private static final int HEADER = 112, RECORD = 8 * (1 + Columns.STATE.length), CRC = 4;
    private static final long MAX_ID = Long.MAX_VALUE / 4;

    /** The world this was taken of; null if none, or if it comes from bytes. */
    World world;

    /** That world's units. */
    Unit[] units = {};

    int size;
    Integrator how;
    final Clock clock = new Clock(Timestep.fixed(1));
    long lastId;
    boolean interpolating;
    final Columns columns = new Columns(null, 0);

    /** Creates an empty snapshot, for {@link World#save}. */
    public Snapshot() {}

    void take(
            World world,
            Integrator how,
            Clock clock,
            long lastId,
            boolean interpolating,
            Columns from,
            Unit[] units,
            int n) {
        from.copyRows(n, columns, interpolating);
        if (this.units.length < n) this.units = new Unit[units.length];
        else Arrays.fill(this.units, n, this.units.length, null); // and keep none alive for nothing
        System.arraycopy(units, 0, this.units, 0, n);
        size = n;
        this.world = world;
        this.how = how;
        this.clock.set(clock);
        this.lastId = lastId;
        this.interpolating = interpolating;
    }

    void requireSaved() {
        if (how == null) throw new IllegalArgumentException("the snapshot is empty: nothing was saved into it");
    }

    /** {@return the number of units} */
    public int size() {
        return size;
    }

    /** {@return the number of steps that the world had run} */
    public long getTick() {
        return clock.tick();
    }

    /**
     * {@return the snapshot as bytes, for a file or another machine} Their format is described field by field in
     * docs/snapshots.md; it does not depend on the machine.
     *
     * @throws IllegalArgumentException if nothing was saved into this snapshot
     */
    public byte[] toBytes() {
        requireSaved();
        byte[] bytes = new byte[Math.toIntExact(HEADER + (long) size * RECORD + CRC)];
        ByteBuffer out = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        Timestep timestep = clock.timestep();
        out.putLong(MAGIC).putInt(VERSION).putInt(size);
        out.put((byte) how.ordinal()).put((byte) (interpolating ? 1 : 0)).putShort((short) 0);
        out.putInt(timestep.rate)
                .putDouble(timestep.maxStep)
                .putInt(timestep.maxSteps)
                .putInt(0);
        for (long value : clock.state()) out.putLong(value);
        out.putLong(lastId);
        double[][] state = columns.state();
        for (int i = 0; i < size; i++) {
            out.putLong(columns.id[i]);
            for (double[] column : state) out.putDouble(column[i] + 0.0);
        }
        return out.putInt(crc(bytes)).array();
    }

    private static int crc(byte[] bytes) {
        CRC32C crc = new CRC32C();
        crc.update(bytes, 0, bytes.length - CRC);
        return (int) crc.getValue();
    }

    /**
     * {@return the snapshot that some bytes of {@link #toBytes} are of} Its units are yet to be made; {@link
     * World#restore} does that. Bytes that were cut, damaged or made up are refused, unless what they say is a state that
     * a world can be in: a checksum is no signature, and whoever can write the bytes can make up such a state.
     *
     * @param bytes the bytes
     * @throws IllegalArgumentException if they are not a snapshot's; the message says what is wrong
     */
    public static Snapshot fromBytes(byte[] bytes) {
        int length = Check.notNull("bytes", bytes).length;
        if (length < HEADER + CRC) throw Check.refused("bytes.length", "at least " + (HEADER + CRC), length);
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (in.getLong() != MAGIC)
            throw new IllegalArgumentException("the bytes are no snapshot: they begin otherwise");
        int version = in.getInt(), count = in.getInt();
        if (version != VERSION) throw Check.refused("version", "" + VERSION, version);
        if (count < 0 || length != HEADER + (long) count * RECORD + CRC) {
            throw Check.refused("count", (length - HEADER - CRC) / (double) RECORD + " by the number of bytes", count);
        }
        if (in.getInt(length - CRC) != crc(bytes)) throw new IllegalArgumentException("the checksum is wrong");
        Snapshot snapshot = new Snapshot();
        snapshot.read(in, count);
        return snapshot;
    }

    private void read(ByteBuffer in, int count) {
        how = Integrator.values()[(int) Check.count("integrator", in.get(), Integrator.values().length - 1)];
        interpolating = Check.count("interpolating", in.get(), 1) == 1;
        Check.count("padding", in.getShort(), 0);
        int rate = in.getInt();
        double maxStep = in.getDouble();
        int maxSteps = in.getInt();
        Check.count("padding", in.getInt(), 0);
        Timestep timestep = rate == 0 ? Timestep.variable(maxStep) : Timestep.fixed(rate);
        if (timestep.maxStep != maxStep) throw Check.refused("maxStep", timestep.maxStep + " at that rate", maxStep);
        clock.setTimestep(timestep.withMaxSteps(maxSteps));
        long[] time = new long[Clock.STATE.length];
        for (int i = 0; i < time.length; i++) time[i] = in.getLong();
        clock.setState(time);
        lastId = Check.count("lastId", in.getLong(), MAX_ID);
        columns.reserve(count);
        size = count;
        double[][] state = columns.state();
        for (int i = 0; i < count; i++) {
            columns.id[i] = in.getLong();
            for (double[] column : state) column[i] = in.getDouble() + 0.0;
            columns.check(i);
        }
        long[] ids = Arrays.copyOf(columns.id, count);
        Arrays.sort(ids);
        for (int i = 0; i < count; i++) {
            long least = i == 0 ? 1 : ids[i - 1] + 1;
            if (ids[i] < least || ids[i] > lastId)
                throw Check.refused("id", "from 1 to " + lastId + ", each once", ids[i]);
        }
        columns.follow(count);
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
        requireSaved();
        Check.notNull("other", other).requireSaved();
        Lines lines = new Lines();
        lines.add("integrator", how, other.how);
        lines.add(
                "timestep", clock.timestep().toString(), other.clock.timestep().toString());
        long[] time = clock.state(), otherTime = other.clock.state();
        for (int i = 0; i < time.length; i++) {
            if (i < Clock.DOUBLES) lines.add(Clock.STATE[i], time[i], otherTime[i]);
            else lines.add(Clock.STATE[i], Double.longBitsToDouble(time[i]), Double.longBitsToDouble(otherTime[i]));
        }
        lines.add("lastId", lastId, other.lastId);
        lines.add("interpolating", interpolating, other.interpolating);
        lines.add("size", size, other.size);
        Map<Long, Integer> rows = new HashMap<>();
        for (int i = 0; i < other.size; i++) rows.put(other.columns.id[i], i);
        double[][] state = columns.state(), otherState = other.columns.state();
        int shown = interpolating || other.interpolating ? state.length : state.length - 2; // previousX and Y come last
        for (int i = 0; i < size; i++) {
            String unit = "unit " + columns.id[i];
            Integer j = rows.remove(columns.id[i]);
            lines.add(unit, "number " + i, j == null ? "missing" : "number " + j);
            for (int k = 0; j != null && k < shown; k++) {
                lines.add(unit + ' ' + Columns.STATE[k], state[k][i] + 0.0, otherState[k][j] + 0.0);
            }
        }
        for (int j = 0; j < other.size; j++) {
            long id = other.columns.id[j];
            if (rows.containsKey(id)) lines.add("unit " + id, "missing", "number " + j);
        }
        return lines.toString();
    }

    /** The lines of a difference. */
    private static final class Lines {
        private static final int MOST = 100;
        private final StringBuilder text = new StringBuilder();
        private int count;

        void add(String name, Object mine, Object theirs) {
            if (mine.equals(theirs) || ++count > MOST) return;
            text.append(name)
                    .append(": ")
                    .append(show(mine))
                    .append(" | ")
                    .append(show(theirs))
                    .append('\n');
        }

        private static String show(Object value) {
            return value instanceof Double ? Double.toHexString((Double) value) + " (" + value + ")" : value.toString();
        }

        @Override
        public String toString() {
            return text + (count > MOST ? "and " + (count - MOST) + " more\n" : "");
        }
    }
}
