package yarts.physics;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.CRC32;

/** A {@link State} as bytes, as docs/snapshots.md describes them field by field. */
final class SnapshotFormat {
    private static final int VERSION = 1;

    private static final long MAGIC = 0x5948505354524159L; // "YARTSPHY", the first letter in the lowest byte
    private static final int HEADER = 40 + 8 * (Clock.STATE.length + 1), RECORD = 8 * (1 + Columns.STATE.length);
    private static final int CRC = 4;
    private static final long MAX_ID = Long.MAX_VALUE / 4;

    /** Components of forces and impulses that are held: more than 2^63 calls come to. */
    private static final double MAX_HELD = 1e70;

    private SnapshotFormat() {}

    static byte[] write(State state) {
        int size = state.table.size();
        byte[] bytes = new byte[Math.toIntExact(HEADER + (long) size * RECORD + CRC)];
        ByteBuffer out = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        Timestep timestep = state.clock.timestep();
        out.putLong(MAGIC).putInt(VERSION).putInt(size);
        out.put((byte) state.integrator.ordinal()).put((byte) (state.interpolating ? 1 : 0));
        out.putShort((short) 0).putInt(timestep.rate);
        out.putDouble(timestep.maxStep).putInt(timestep.maxSteps).putInt(0);
        for (long value : state.clock.state()) out.putLong(value);
        out.putLong(state.lastId);
        for (int k = 0; k < state.table.blocks(); k++) write(state.table.block(k), out);
        return out.putInt(crc(bytes)).array();
    }

    private static void write(Columns c, ByteBuffer out) {
        double[][] columns = c.state();
        for (int i = c.start; i < c.end; i++) {
            out.putLong(c.id[i]);
            for (double[] column : columns) out.putDouble(column[i] + 0.0);
        }
    }

    private static int crc(byte[] bytes) {
        CRC32 crc = new CRC32();
        crc.update(bytes, 0, bytes.length - CRC);
        return (int) crc.getValue();
    }

    static State read(byte[] bytes) {
        int length = bytes.length;
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
        int integrator = (int) Check.count("integrator", in.get(), Integrator.values().length - 1);
        boolean interpolating = Check.count("interpolating", in.get(), 1) == 1;
        Check.count("padding", in.getShort(), 0);
        Timestep timestep = readTimestep(in);
        State state = new State(Integrator.values()[integrator], timestep);
        state.interpolating = interpolating;
        long[] time = new long[Clock.STATE.length];
        for (int i = 0; i < time.length; i++) time[i] = in.getLong();
        state.clock.setState(timestep, time);
        state.lastId = Check.count("lastId", in.getLong(), MAX_ID);
        state.table.resize(count);
        long[] ids = new long[count];
        for (int k = 0; k < state.table.blocks(); k++) {
            Columns c = state.table.block(k);
            read(in, c);
            System.arraycopy(c.id, c.start, ids, c.origin + c.start, c.end - c.start);
        }
        Arrays.sort(ids);
        for (int i = 0; i < count; i++) {
            long least = i == 0 ? 1 : ids[i - 1] + 1;
            if (ids[i] < least || ids[i] > state.lastId)
                throw Check.refused("id", "from 1 to " + state.lastId + ", each once", ids[i]);
        }
        return state;
    }

    private static Timestep readTimestep(ByteBuffer in) {
        int rate = in.getInt();
        double maxStep = in.getDouble();
        int maxSteps = in.getInt();
        Check.count("padding", in.getInt(), 0);
        Timestep timestep = rate == 0 ? Timestep.variable(maxStep) : Timestep.fixed(rate);
        if (timestep.maxStep != maxStep) throw Check.refused("maxStep", timestep.maxStep + " at that rate", maxStep);
        return timestep.withMaxSteps(maxSteps);
    }

    private static void read(ByteBuffer in, Columns c) {
        double[][] columns = c.state();
        for (int i = c.start; i < c.end; i++) {
            c.id[i] = in.getLong();
            for (double[] column : columns) column[i] = in.getDouble() + 0.0;
            check(c, i);
        }
        c.pushed = c.pending = Columns.MANY;
        c.still = true;
    }

    /** Refuses a row if no unit can have come to it. */
    private static void check(Columns c, int i) {
        Check.finite("x", c.x[i]);
        Check.finite("y", c.y[i]);
        Check.finite("x - previousX", c.x[i] - Check.finite("previousX", c.previousX[i])); // or they cannot be
        Check.finite("y - previousY", c.y[i] - Check.finite("previousY", c.previousY[i])); // interpolated
        Check.mass(c.mass[i]);
        Check.friction(c.friction[i]);
        double most = Math.min(Check.maxSpeed(c.maxSpeed[i]), Kernel.FASTEST);
        if (most < Kernel.REST) most = 0;
        velocity("vx", c.vx[i], most);
        velocity("vy", c.vy[i], most);
        double speed = Kernel.speed(c.vx[i], c.vy[i]);
        if (!(speed <= most)) throw Check.refused("speed", "at most " + most + " m/s", speed);
        if (c.frozen[i] != 0 && c.frozen[i] != 1) throw Check.refused("frozen", "0 or 1", c.frozen[i]);
        if (c.frozen[i] == 1) {
            still("vx", c.vx[i]);
            still("vy", c.vy[i]);
        }
        held("fx", c.fx[i]);
        held("fy", c.fy[i]);
        held("pendingX", c.pendingX[i]);
        held("pendingY", c.pendingY[i]);
    }

    private static void velocity(String name, double v, double most) {
        boolean subnormal = v != 0 && Math.abs(v) < Double.MIN_NORMAL;
        if (subnormal || !(Math.abs(v) <= most)) {
            throw Check.refused(name, "0 or a normal number, at most " + most + " in magnitude", v);
        }
    }

    /** That of a frozen unit, which is not on its way to rest. */
    private static void still(String name, double v) {
        if (v != 0 && Math.abs(v) < Kernel.REST) {
            throw Check.refused(name, "0 or at least " + Kernel.REST + " in magnitude where frozen", v);
        }
    }

    private static void held(String name, double value) {
        if (!(Math.abs(value) <= MAX_HELD)) throw Check.refused(name, "finite and at most 1.0E70 in magnitude", value);
    }
}
