package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Rows;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The format of version 1: the offset of each value, and a file that every later version must read. {@link #main} wrote
 * the file once; it must not change.
 */
class SnapshotFormatTest {
    private static final byte[] MAGIC = "YARTSPHY".getBytes(StandardCharsets.US_ASCII);

    /**
     * Six units: forces for the next advance and the next step, pending impulses, interpolation, no top speed, one
     * pinned, one frozen, one removed.
     */
    private static World world() {
        World world = new World(Integrator.MIDPOINT, Timestep.fixed(50).withMaxSteps(3));
        for (int i = 1; i <= 7; i++) world.add(new Unit(i).setPosition(i, -i).setVelocity(10 * i, i / 4.0));
        world.find(1).setFriction(0.5).setMaxSpeed(2);
        world.find(2).setMaxSpeed(0);
        world.find(4).setMass(1e50).setFriction(1e-50).setPosition(1e300, -1e-300);
        world.remove(world.find(3)); // 7 takes its index
        world.step(0.25);
        world.find(7).setFrozen(true);
        world.find(5).applyForce(8, -16);
        world.addAfterStep((w, dt) -> w.find(1).applyForce(w.getTick() == 4 ? 3 : 0, w.getTick() == 4 ? -4 : 0));
        world.advance(0.105); // five steps are due, three run, and a quarter of one remains
        world.advance(0x1p-40); // not a whole billionth of a step
        world.find(6).applyForce(0.5, 1024);
        return world;
    }

    /**
     * Writes a file like the resource of the tests.
     *
     * @param args the path of the file
     */
    public static void main(String[] args) throws IOException {
        Files.write(Path.of(args[0]), Saves.of(world()));
    }

    private static byte[] file() throws IOException {
        try (InputStream in = SnapshotFormatTest.class.getResourceAsStream("/snapshot-1.bin")) {
            return in.readAllBytes();
        }
    }

    /** These values never change: do not write the file again to make this test pass. */
    @Test
    void theFileOfVersion1CanBeRead() throws IOException {
        Snapshot snapshot = Snapshot.fromBytes(file());
        assertArrayEquals(file(), snapshot.toBytes());
        World world = Saves.restored(snapshot);
        assertEquals(0x31128c8be1ac3dd6L, world.stateHash());
        assertEquals(4, snapshot.getTick());
        assertEquals(4, world.getTick());
        assertEquals(0.31, world.getTime());
        assertEquals(0.04, world.getDroppedTime());
        assertEquals(0.25, world.getAlpha());
        assertEquals(6, world.size());
        double none = Double.POSITIVE_INFINITY;
        assertUnit(world.get(0), 1, 1, 0.5, 2, 1.5747194014165873, -0.9856320149645853);
        assertMoves(world.get(0), 1.7120155921079487, 0.04280038980269872, 1.5403070277058748, -0.9864923243073531);
        assertUnit(world.get(1), 2, 2, 0, 0, 2, -2);
        assertMoves(world.get(1), 0, 0, 2, -2);
        assertUnit(world.get(2), 7, 7, 0, none, 24.5, -6.5625);
        assertMoves(world.get(2), 70, 1.75, 24.5, -6.5625);
        assertUnit(world.get(3), 4, 1e50, 1e-50, none, 1e300, 0.31000000000000005);
        assertMoves(world.get(3), 40, 1, 1e300, 0.29000000000000004);
        assertUnit(world.get(4), 5, 5, 0, none, 20.502879999999998, -4.61826);
        assertMoves(world.get(4), 50.09599999999999, 1.0579999999999998, 19.501279999999998, -4.64006);
        assertUnit(world.get(5), 6, 6, 0, none, 24.599999999999998, -5.534999999999999);
        assertMoves(world.get(5), 60, 1.5, 23.4, -5.5649999999999995);
        assertForces(world.find(1), 3, -4);
        for (int id : new int[] {2, 4, 5, 6, 7}) assertForces(world.find(id), id == 6 ? 0.5 : 0, id == 6 ? 1024 : 0);
        assertEquals(3, Rows.get(world.find(1), "waitingX"));
        assertEquals(0.5, Rows.get(world.find(6), "fx"));
        for (Unit unit : world) assertEquals(unit.getId() == 7, unit.isFrozen());
        for (Unit unit : world) assertPending(unit, unit.getId() == 5 ? 0.04 : 0, unit.getId() == 5 ? -0.08 : 0);
        assertEquals(8, world.add(new Unit(1)).getId());
        assertEquals(3, world.advance(1));
        assertEquals(24.5, world.get(2).getX());
    }

    private static void assertUnit(
            Unit unit, long id, double mass, double friction, double maxSpeed, double x, double y) {
        assertEquals(
                List.of((double) id, mass, friction, maxSpeed, x, y),
                List.of(
                        (double) unit.getId(),
                        unit.getMass(),
                        unit.getFriction(),
                        unit.getMaxSpeed(),
                        unit.getX(),
                        unit.getY()));
    }

    private static void assertMoves(Unit unit, double vx, double vy, double previousX, double previousY) {
        assertEquals(List.of(previousX, previousY), List.of(unit.getInterpolatedX(0), unit.getInterpolatedY(0)));
        double drawnX = previousX + (unit.getX() - previousX) * 0.25;
        double drawnY = previousY + (unit.getY() - previousY) * 0.25;
        assertEquals(
                List.of(vx, vy, drawnX, drawnY),
                List.of(unit.getVx(), unit.getVy(), unit.getInterpolatedX(), unit.getInterpolatedY()));
    }

    private static void assertForces(Unit unit, double fx, double fy) {
        assertEquals(List.of(fx, fy), List.of(unit.getFx(), unit.getFy()));
    }

    private static void assertPending(Unit unit, double jx, double jy) {
        assertEquals(List.of(jx, jy), List.of(unit.getPendingImpulseX(), unit.getPendingImpulseY()));
    }

    @Test
    void theDocumentHasTheLength() throws IOException {
        String length = Saves.HEADER + Saves.CRC + " + " + Saves.RECORD + "·n bytes";
        assertTrue(Files.readString(Path.of("docs/snapshots.md")).contains(length), length);
        assertEquals(Saves.HEADER + 6 * Saves.RECORD + Saves.CRC, Saves.of(world()).length);
    }

    /** The offsets are those that a reader of the document expects. */
    @Test
    void everyValueIsAtTheOffsetInTheDocument() {
        World world = world();
        byte[] save = new byte[Saves.HEADER + 6 * Saves.RECORD + Saves.CRC];
        Number[] header = {
            0, 1, 6, 1, 1, 0, 50, 1 / 50.0, 3, 0, 4, 3, 250_000_000, 2, 0x1p-40 * 50e9, 0.25, 0, 0, 0, 7, 7
        };
        for (int i = 0; i < 6; i++) {
            int end = 0, value = 0;
            for (Map.Entry<String, Saves.Place> entry : Saves.places(i).entrySet()) {
                String name = entry.getKey();
                Saves.Place place = entry.getValue();
                if (name.equals("id")) end += i * Saves.RECORD;
                assertEquals(end, place.offset(), name + " does not follow the value before it");
                end += place.size();
                if (name.equals("magic")) System.arraycopy(MAGIC, 0, save, 0, 8);
                else if (end <= Saves.HEADER) place.put(save, header[value]);
                else place.put(save, name.equals("id") ? world.get(i).getId() : Rows.get(world.get(i), name));
                value++;
            }
            assertEquals(Saves.HEADER + (i + 1) * Saves.RECORD, end);
            assertEquals(header.length + 1 + Saves.STATE.size(), value);
        }
        assertArrayEquals(Saves.repair(save), Saves.of(world));
    }
}
