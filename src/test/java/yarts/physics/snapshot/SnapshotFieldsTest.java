package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * save, restore, toBytes, fromBytes, stateHash and difference must include each value of the bytes. The test changes a
 * value at the offset in the document, and restores it into a world with another history.
 */
class SnapshotFieldsTest {
    /** The index of the changed unit. */
    private static final int INDEX = 2;

    /** Values that say how to read the others, or that cannot change alone. */
    private static final Set<String> FRAME = Set.of("magic", "version", "count", "padding", "padding again");

    static Stream<String> values() {
        return Saves.places(INDEX).keySet().stream().filter(name -> !FRAME.contains(name));
    }

    private static World world() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 1; i <= 5; i++) world.add(new Unit(i).setFriction(i).setMaxSpeed(100));
        for (int i = 0; i < 5; i += 2) world.get(i).setMotor(1, -i, 2 + i);
        for (Unit unit : world) unit.applyForce(1, (double) -unit.getId());
        world.step(0.01);
        for (Unit unit : world) unit.applyForce(1, (double) -unit.getId());
        assertEquals(2, world.advance(0.04));
        world.remove(world.add(new Unit(6)));
        return world;
    }

    /** Changes a value by as little as possible; another rate needs another maxStep. */
    private static void change(byte[] save, String name) {
        Map<String, Saves.Place> places = Saves.places(INDEX);
        Saves.Place place = places.get(name);
        double was = place.get(save).doubleValue();
        switch (name) {
            case "integrator":
            case "interpolating":
            case "lastSteppedId":
                place.put(save, was - 1);
                break;
            case "rate":
                place.put(save, 50);
                places.get("maxStep").put(save, 1 / 50.0);
                break;
            case "maxStep":
                places.get("rate").put(save, 0);
                place.put(save, Math.nextUp(was));
                break;
            case "id":
                place.put(save, 6);
                break;
            case "frozen":
                place.put(save, 1 - was);
                break;
            default:
                place.put(save, place.type().equals("double") ? was + 0.125 : was + 1);
        }
        Saves.repair(save);
    }

    /** The start of the line in a difference. */
    private static String line(String name) {
        if (List.of("rate", "maxStep", "maxSteps").contains(name)) return "timestep: ";
        if (name.equals("id")) return "unit 3: ";
        return (Saves.STATE.contains(name) ? "unit 3 " : "") + name + ": ";
    }

    @ParameterizedTest
    @MethodSource("values")
    void everyCallIncludesTheValue(String name) {
        World world = world();
        Snapshot before = world.save();
        byte[] bytes = before.toBytes();
        change(bytes, name);
        Snapshot after = Snapshot.fromBytes(bytes);
        assertArrayEquals(bytes, after.toBytes(), "fromBytes, or toBytes");

        String difference = before.difference(after);
        assertTrue(difference.lines().anyMatch(line -> line.startsWith(line(name))), difference);
        int lines = name.equals("id") ? 2 : 1; // two units
        assertEquals(lines, difference.lines().count(), difference);

        long hash = world.stateHash();
        List<Long> bits = Churn.bits(world);
        world.restore(after);
        long changed = world.stateHash();
        assertNotEquals(hash, changed, "stateHash");
        assertArrayEquals(bytes, world.save().toBytes(), "restore, or save");
        if (Saves.STATE.contains(name)) {
            Saves.Place place = Saves.places(INDEX).get(name);
            assertEquals(place.get(bytes), Saves.state(world.get(INDEX), name), "the value of the unit");
        }

        Snapshot used = world.save();
        world.restore(before);
        assertEquals(hash, world.stateHash(), "restore");
        assertEquals(bits, Churn.bits(world), "restore");
        world.save(used);
        assertArrayEquals(before.toBytes(), used.toBytes(), "save into a snapshot that held another value");
        World other = new World();
        for (int i = 0; i < 9; i++) other.add(new Unit(7)).applyForce(1, 1);
        other.advance(0.03);
        other.restore(after);
        assertEquals(changed, other.stateHash(), "restore in another world");
    }
}
