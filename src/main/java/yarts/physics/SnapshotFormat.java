package yarts.physics;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.CRC32;

/** Writes and reads a {@link State} as bytes. docs/snapshots.md describes the format field by field. */
final strictfp class SnapshotFormat {
    private static final int VERSION = 1;

    private static final long MAGIC = 0x5948505354524159L; // "YARTSPHY", the first letter in the lowest byte
    private static final int HEADER = 40 + 8 * (Clock.STATE.length + 2), RECORD = 8 * (1 + Table.STATE.length);
    private static final int CRC = 4;
    private static final long MAX_ID = Long.MAX_VALUE / 4;

    /** The maximum component of forces and impulses that have not acted; 2^63 calls cannot exceed it. */
    private static final double MAX_HELD = 1e70;

    private SnapshotFormat() {}

    static byte[] write(State state) {
        Table t = state.table;
        byte[] bytes = new byte[(int) Check.count("the number of bytes", length(t.size), Integer.MAX_VALUE)];
        ByteBuffer out = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        Timestep timestep = state.clock.timestep();
        out.putLong(MAGIC).putInt(VERSION).putInt(t.size);
        out.put((byte) state.integrator.code).put((byte) (state.interpolating ? 1 : 0));
        out.putShort((short) 0).putInt(timestep.rate);
        out.putDouble(timestep.maxStep).putInt(timestep.maxSteps).putInt(0);
        for (long value : state.clock.state()) out.putLong(value);
        out.putLong(state.lastId).putLong(state.lastSteppedId);
        double[][] columns = t.columns();
        for (int i = 0; i < t.size; i++) {
            out.putLong(t.id[i]);
            for (double[] column : columns) out.putDouble(column[i] + 0.0);
        }
        return out.putInt(crc(bytes)).array();
    }

    private static long length(int units) {
        return HEADER + (long) units * RECORD + CRC;
    }

    private static int crc(byte[] bytes) {
        CRC32 crc = new CRC32();
        crc.update(bytes, 0, bytes.length - CRC);
        return (int) crc.getValue();
    }

    static State read(byte[] bytes) {
        int length = bytes.length;
        if (length < length(0)) {
            throw new IllegalArgumentException(
                    "the bytes are truncated: a snapshot has at least " + length(0) + ", these are " + length);
        }
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (in.getLong() != MAGIC) {
            throw new IllegalArgumentException("the bytes are not a snapshot: they do not begin with YARTSPHY");
        }
        int version = in.getInt(), count = in.getInt();
        if (version != VERSION) throw Check.invalid("version", "" + VERSION, version);
        if (count < 0) throw Check.invalid("the number of units", ">= 0", count);
        if (length != length(count)) {
            throw new IllegalArgumentException("the bytes are " + (length < length(count) ? "truncated" : "too many")
                    + ": a snapshot of " + count + " units has " + length(count) + ", these are " + length);
        }
        if (in.getInt(length - CRC) != crc(bytes)) throw new IllegalArgumentException("the checksum is wrong");
        int integrator = (int) Check.count("integrator", in.get(), Integrator.MAX_CODE);
        boolean interpolating = Check.count("interpolating", in.get(), 1) == 1;
        Check.count("padding", in.getShort(), 0);
        Timestep timestep = readTimestep(in);
        State state = new State(Integrator.ofCode(integrator), timestep);
        state.interpolating = interpolating;
        long[] time = new long[Clock.STATE.length];
        for (int i = 0; i < time.length; i++) time[i] = in.getLong();
        state.clock.setState(timestep, time);
        state.lastId = Check.count("lastId", in.getLong(), MAX_ID);
        state.lastSteppedId = Check.count("lastSteppedId", in.getLong(), state.lastId);
        readUnits(in, state.table, count);
        checkIds(Arrays.copyOf(state.table.id, count), state.lastId);
        return state;
    }

    private static Timestep readTimestep(ByteBuffer in) {
        int rate = in.getInt();
        double maxStep = in.getDouble();
        int maxSteps = in.getInt();
        Check.count("padding", in.getInt(), 0);
        Timestep timestep = rate == 0 ? Timestep.variable(maxStep) : Timestep.fixed(rate);
        if (timestep.maxStep != maxStep) throw Check.invalid("maxStep", timestep.maxStep + " at that rate", maxStep);
        return timestep.withMaxSteps(maxSteps);
    }

    private static void readUnits(ByteBuffer in, Table t, int count) {
        t.reserve(count);
        t.size = count;
        double[][] columns = t.columns();
        for (int i = 0; i < count; i++) {
            t.id[i] = in.getLong();
            for (double[] column : columns) column[i] = in.getDouble() + 0.0;
            check(t, i);
            Kernel.setMaxSpeed(t, i, t.maxSpeed[i]);
        }
        for (boolean[] flags : new boolean[][] {t.pushed, t.pending, t.waiting, t.motored, t.still}) {
            Arrays.fill(flags, true);
        }
    }

    private static void checkIds(long[] ids, long lastId) {
        Arrays.sort(ids);
        for (int i = 0; i < ids.length; i++) {
            long least = i == 0 ? 1 : ids[i - 1] + 1;
            if (ids[i] < least || ids[i] > lastId) {
                throw Check.invalid("id", "from 1 to " + lastId + ", each once", ids[i]);
            }
        }
    }

    /** Throws an exception if no unit can have the state of a row. */
    private static void check(Table t, int i) {
        Check.finite("x", t.x[i]);
        Check.finite("y", t.y[i]);
        // Interpolation needs finite differences.
        Check.finite("x - previousX", t.x[i] - Check.finite("previousX", t.previousX[i]));
        Check.finite("y - previousY", t.y[i] - Check.finite("previousY", t.previousY[i]));
        Check.mass(t.mass[i]);
        Check.friction(t.friction[i]);
        double maxSpeed = Check.maxSpeed(t.maxSpeed[i]), most = Math.min(maxSpeed, Kernel.FASTEST);
        notBelowRest("maxSpeed", maxSpeed);
        velocity("vx", t.vx[i], most);
        velocity("vy", t.vy[i], most);
        double speed = Kernel.speed(t.vx[i], t.vy[i]);
        if (!(speed <= most)) throw Check.invalid("speed", "at most " + most + " m/s", speed);
        if (t.frozen[i] != 0 && t.frozen[i] != 1) throw Check.invalid("frozen", "0 or 1", t.frozen[i]);
        if (t.frozen[i] == 1) {
            notBelowRest("vx of a frozen unit", t.vx[i]);
            notBelowRest("vy of a frozen unit", t.vy[i]);
        }
        velocity("motorVx", t.motorVx[i], Kernel.FASTEST);
        velocity("motorVy", t.motorVy[i], Kernel.FASTEST);
        notBelowRest("motorVx", t.motorVx[i]);
        notBelowRest("motorVy", t.motorVy[i]);
        Check.motorForce("motorForce", t.motorForce[i]);
        held("fx", t.fx[i]);
        held("fy", t.fy[i]);
        held("waitingX", t.waitingX[i]);
        held("waitingY", t.waitingY[i]);
        held("pendingX", t.pendingX[i]);
        held("pendingY", t.pendingY[i]);
    }

    private static void velocity(String name, double v, double most) {
        boolean subnormal = v != 0 && Math.abs(v) < Double.MIN_NORMAL;
        if (subnormal || !(Math.abs(v) <= most)) {
            throw Check.invalid(name, "0 or a normal number, at most " + most + " in magnitude", v);
        }
    }

    private static void notBelowRest(String name, double v) {
        if (v != Kernel.zeroBelowRest(v))
            throw Check.invalid(name, "0 or at least " + Kernel.REST + " in magnitude", v);
    }

    private static void held(String name, double value) {
        if (!(Math.abs(value) <= MAX_HELD)) throw Check.invalid(name, "finite and at most 1.0E70 in magnitude", value);
    }
}
