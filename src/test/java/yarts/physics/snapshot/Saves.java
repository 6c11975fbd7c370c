package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import yarts.physics.Integrator;
import yarts.physics.Rows;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The bytes of snapshots, read as the tables of docs/snapshots.md describe them. */
public final class Saves {
    public static final int CRC = 4, HEADER = length(0) - CRC, RECORD = length(1) - length(0);

    private static int length(int units) {
        World world = new World();
        for (int i = 0; i < units; i++) world.add(new Unit(1));
        return world.save().toBytes().length;
    }

    /** The offset, size and type of a value: byte, short, int, long, double. */
    public record Place(int offset, int size, String type) {
        void put(byte[] save, Number value) {
            ByteBuffer bytes = order(save);
            if (type.equals("double")) bytes.putDouble(offset, value.doubleValue());
            else if (type.equals("long")) bytes.putLong(offset, value.longValue());
            else if (type.equals("int")) bytes.putInt(offset, value.intValue());
            else if (type.equals("short")) bytes.putShort(offset, value.shortValue());
            else bytes.put(offset, value.byteValue());
        }

        /** The bits of a value of 8 bytes. */
        long bits(byte[] save) {
            return order(save).getLong(offset);
        }

        public Number get(byte[] save) {
            ByteBuffer bytes = order(save);
            if (type.equals("double")) return bytes.getDouble(offset);
            if (type.equals("long")) return bytes.getLong(offset);
            if (type.equals("int")) return bytes.getInt(offset);
            return type.equals("short") ? bytes.getShort(offset) : bytes.get(offset);
        }
    }

    /** The doubles of a unit's record, in the order of the document. */
    public static final List<String> STATE = places(0).entrySet().stream()
            .filter(entry -> entry.getValue().offset() > HEADER)
            .map(Map.Entry::getKey)
            .toList();

    private Saves() {}

    /** {@return a value of a unit's record, from the unit} */
    public static double state(Unit unit, String name) {
        switch (name) {
            case "x":
                return unit.getX();
            case "y":
                return unit.getY();
            case "vx":
                return unit.getVx();
            case "vy":
                return unit.getVy();
            case "mass":
                return unit.getMass();
            case "friction":
                return unit.getFriction();
            case "maxSpeed":
                return unit.getMaxSpeed();
            case "frozen":
                return unit.isFrozen() ? 1 : 0;
            case "fx":
                return unit.getFx();
            case "fy":
                return unit.getFy();
            case "motorVx":
                return unit.getMotorVx();
            case "motorVy":
                return unit.getMotorVy();
            case "motorForce":
                return unit.getMotorForce();
            case "waitingX":
            case "waitingY":
                return Rows.get(unit, name);
            case "pendingX":
                return unit.getPendingImpulseX();
            case "pendingY":
                return unit.getPendingImpulseY();
            case "previousX":
                return unit.getInterpolatedX(0);
            case "previousY":
                return unit.getInterpolatedY(0);
            default:
                throw new AssertionError(name);
        }
    }

    /** {@return the places of the values of the header and of the unit with an index, in the order of the document} */
    public static Map<String, Place> places(int unit) {
        Map<String, Place> places = new LinkedHashMap<>();
        int start = 0;
        try {
            for (String line : Files.readAllLines(Path.of("docs/snapshots.md"))) {
                if (line.equals("### A unit")) start = HEADER + RECORD * unit;
                String[] cells = line.split(" *\\| *");
                if (cells.length < 5 || !cells[1].matches("\\d+")) continue;
                int offset = start + Integer.parseInt(cells[1]);
                String name = places.containsKey(cells[4]) ? cells[4] + " again" : cells[4];
                places.put(name, new Place(offset, Integer.parseInt(cells[2]), cells[3]));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return places;
    }

    public static ByteBuffer order(byte[] save) {
        return ByteBuffer.wrap(save).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Corrects the checksum. */
    public static byte[] repair(byte[] save) {
        CRC32 crc = new CRC32();
        crc.update(save, 0, save.length - CRC);
        order(save).putInt(save.length - CRC, (int) crc.getValue());
        return save;
    }

    public static byte[] of(World world) {
        return snapshot(world).toBytes();
    }

    public static Snapshot snapshot(World world) {
        return world.save();
    }

    public static World restored(Snapshot snapshot) {
        World world = new World();
        world.restore(snapshot);
        return world;
    }

    /**
     * A snapshot of units with waiting forces and pending impulses, some with motors, some frozen, interpolated if
     * steps are fixed.
     */
    public static byte[] save(int units, Timestep timestep) {
        World world = new World(Integrator.EXACT, timestep);
        for (int i = 1; i <= units; i++) {
            world.add(new Unit(i).setFriction(i % 7).setMaxSpeed(i % 5 == 0 ? i % 2 : 1000))
                    .applyForce(i, -i);
        }
        world.step(0.3);
        for (int i = 3; i < units; i += 7) world.get(i).setFrozen(true);
        for (int i = 1; i < units; i += 2) world.get(i).setMotor(i, -2, 3);
        for (Unit unit : world) unit.applyForce(3, (double) unit.getId());
        world.advance(0.06);
        for (Unit unit : world) unit.applyForce((double) unit.getId(), 2);
        return of(world);
    }

    public static byte[] save(int units) {
        return save(units, Timestep.fixed(60));
    }

    /** {@return the message of the exception that the bytes cause} */
    public static String refused(byte[] save) {
        return assertThrows(IllegalArgumentException.class, () -> Snapshot.fromBytes(save))
                .getMessage();
    }

    /** Checks that a snapshot writes the bytes from which it was read, and that a restored world has finite numbers. */
    public static void assertSound(Snapshot snapshot) {
        World world = restored(snapshot);
        Snapshot again = Snapshot.fromBytes(snapshot.toBytes());
        assertEquals("", snapshot.difference(again));
        assertEquals(world.stateHash(), restored(again).stateHash());
        assertFinite(world);
        world.add(new Unit(1)).applyForce(1, 1);
        world.advance(1e-3);
        for (int i = 0; i < 3; i++) {
            world.step(i * 0.1);
            assertFinite(world);
            for (Unit unit : world) unit.applyForce(-3, 1e50);
            world.advance(i * 1e-4);
            assertFinite(world);
        }
        assertEquals(world.stateHash(), restored(Snapshot.fromBytes(of(world))).stateHash());
    }

    public static void assertFinite(World world) {
        assertTrue(Double.isFinite(world.getTime()) && Double.isFinite(world.getDroppedTime()));
        assertTrue(world.getAlpha() >= 0 && world.getAlpha() < 1);
        for (Unit unit : world) {
            for (String name : STATE) {
                double v = state(unit, name);
                assertTrue(Double.isFinite(v) || (name.equals("maxSpeed") && v > 0), name);
            }
            for (double alpha : new double[] {0, 0.5, 1}) {
                assertTrue(Double.isFinite(unit.getInterpolatedX(alpha)));
                assertTrue(Double.isFinite(unit.getInterpolatedY(alpha)));
            }
            for (double v : new double[] {unit.getVx(), unit.getVy()}) {
                assertTrue(v == 0 || Math.abs(v) >= Double.MIN_NORMAL, "a subnormal velocity: " + v);
            }
            assertTrue(unit.getSpeed() <= unit.getMaxSpeed());
        }
    }
}
