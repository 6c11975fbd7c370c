package yarts.physics;

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
import java.util.Map;
import java.util.zip.CRC32C;

/** The bytes of snapshots, taken apart by what docs/snapshots.md says of them. */
final class Saves {
    static final int HEADER = 112, RECORD = 112, CRC = 4;

    /** Where a value is, and its type: byte, short, int, long, double. */
    record Place(int offset, int size, String type) {
        void put(byte[] save, Number value) {
            ByteBuffer bytes = order(save);
            if (type.equals("double")) bytes.putDouble(offset, value.doubleValue());
            else if (type.equals("long")) bytes.putLong(offset, value.longValue());
            else if (type.equals("int")) bytes.putInt(offset, value.intValue());
            else if (type.equals("short")) bytes.putShort(offset, value.shortValue());
            else bytes.put(offset, value.byteValue());
        }
    }

    private Saves() {}

    /** {@return the places of the values of the header and of the unit with a number, in the order of the document} */
    static Map<String, Place> places(int unit) {
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

    static ByteBuffer order(byte[] save) {
        return ByteBuffer.wrap(save).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Makes the checksum right. */
    static byte[] repair(byte[] save) {
        CRC32C crc = new CRC32C();
        crc.update(save, 0, save.length - CRC);
        order(save).putInt(save.length - CRC, (int) crc.getValue());
        return save;
    }

    static byte[] of(World world) {
        return snapshot(world).toBytes();
    }

    static Snapshot snapshot(World world) {
        Snapshot snapshot = new Snapshot();
        world.save(snapshot);
        return snapshot;
    }

    static World restored(Snapshot snapshot) {
        World world = new World();
        world.restore(snapshot);
        return world;
    }

    /** A save of some units with forces held and carried, interpolated if steps are fixed. */
    static byte[] save(int units, Timestep timestep) {
        World world = new World(Integrator.EXACT, timestep);
        for (int i = 1; i <= units; i++) {
            world.add(new Unit(i).setFriction(i % 7).setMaxSpeed(i % 5 == 0 ? i % 2 : 1000))
                    .applyForce(i, -i);
        }
        world.step(0.3);
        for (Unit unit : world) unit.applyForce(3, unit.getId());
        world.advance(0.06);
        for (Unit unit : world) unit.applyForce(unit.getId(), 2);
        return of(world);
    }

    static byte[] save(int units) {
        return save(units, Timestep.fixed(60));
    }

    /** {@return with what message it is refused} */
    static String refused(byte[] save) {
        return assertThrows(IllegalArgumentException.class, () -> Snapshot.fromBytes(save))
                .getMessage();
    }

    /** It writes what it was read from, and a world goes on from it with finite numbers. */
    static void assertSound(Snapshot snapshot) {
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

    static void assertFinite(World world) {
        assertTrue(Double.isFinite(world.getTime()) && Double.isFinite(world.getDroppedTime()));
        assertTrue(world.getAlpha() >= 0 && world.getAlpha() < 1);
        for (Unit unit : world) {
            double[][] state = unit.columns.state();
            for (int k = 0; k < state.length; k++) {
                boolean finite = Double.isFinite(state[k][unit.row]);
                assertTrue(finite || Columns.STATE[k].equals("maxSpeed"), Columns.STATE[k]);
            }
            assertTrue(Double.isFinite(unit.getInterpolatedX()) && Double.isFinite(unit.getInterpolatedY()));
            assertTrue(unit.getSpeed() <= unit.getMaxSpeed());
        }
    }
}
