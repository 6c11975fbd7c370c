package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Not one field may be left out of save, restore, toBytes, fromBytes, stateHash and difference. */
class SnapshotFieldsTest {
    /** A field, the change of which alone a difference names so, and a change of it. */
    private record Change(String field, Consumer<World> of) {
        @Override
        public String toString() {
            return field;
        }
    }

    private static final int ROW = 2;

    static Stream<Change> changes() {
        List<Change> changes = new ArrayList<>();
        for (int k = 0; k < Columns.STATE.length; k++) {
            int column = k;
            changes.add(new Change("unit 3 " + Columns.STATE[k], w -> table(w).state()[column][ROW] += 0.125));
        }
        for (int k = 0; k < Clock.STATE.length; k++) {
            int value = k;
            changes.add(new Change(Clock.STATE[k], w -> {
                Clock clock = (Clock) read(w, "clock");
                long[] state = clock.state();
                if (value < Clock.DOUBLES) state[value]++;
                else state[value] = Double.doubleToRawLongBits(Double.longBitsToDouble(state[value]) + 0.125);
                clock.setState(state);
            }));
        }
        changes.add(new Change("lastId", w -> write(w, "lastId", 9L)));
        changes.add(new Change("integrator", w -> write(w, "how", Integrator.EULER)));
        changes.add(new Change("interpolating", w -> write(w, "interpolating", false)));
        for (Timestep timestep : List.of(Timestep.fixed(50), Timestep.fixed(60).withMaxSteps(3))) {
            changes.add(new Change("timestep", w -> {
                Snapshot snapshot = Saves.snapshot(w);
                snapshot.clock.setTimestep(timestep);
                w.restore(snapshot);
            }));
        }
        return changes.stream();
    }

    private static World world() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 1; i <= 5; i++) world.add(new Unit(i).setFriction(i).setMaxSpeed(100));
        for (Unit unit : world) unit.applyForce(1, -unit.getId());
        world.step(0.01);
        for (Unit unit : world) unit.applyForce(1, -unit.getId());
        assertEquals(2, world.advance(0.04));
        return world;
    }

    @ParameterizedTest
    @MethodSource("changes")
    void isPartOfEverything(Change change) {
        World world = world();
        Snapshot before = Saves.snapshot(world);
        long hash = world.stateHash();
        List<Long> bits = Churn.bits(world);
        change.of.accept(world);
        Snapshot after = Saves.snapshot(world);
        long changed = world.stateHash();

        assertNotEquals(hash, changed, "stateHash");
        String difference = before.difference(after);
        assertTrue(difference.startsWith(change.field + ": "), difference);
        assertEquals(change.field.equals("interpolating") ? difference : line(difference), difference);
        assertEquals(changed, Saves.restored(after).stateHash(), "save, or restore");
        Snapshot read = Snapshot.fromBytes(after.toBytes());
        assertEquals("", after.difference(read), "toBytes, or fromBytes");
        assertEquals(changed, Saves.restored(read).stateHash(), "toBytes, or fromBytes");
        world.restore(before);
        assertEquals(hash, world.stateHash(), "restore");
        assertEquals(bits, Churn.bits(world), "restore");
    }

    /** What the test above would see of a column that save leaves out: the value that the snapshot had before. */
    @ParameterizedTest
    @MethodSource("changes")
    void wouldBeMissed(Change change) {
        if (!change.field.startsWith("unit")) return;
        World world = world();
        Snapshot snapshot = Saves.snapshot(world);
        double[][] stale = new double[Columns.STATE.length][];
        for (int k = 0; k < stale.length; k++) stale[k] = snapshot.columns.state()[k].clone();
        change.of.accept(world);
        world.save(snapshot);
        for (int k = 0; k < stale.length; k++) {
            if (!change.field.endsWith(" " + Columns.STATE[k])) continue;
            System.arraycopy(stale[k], 0, snapshot.columns.state()[k], 0, world.size());
        }
        assertNotEquals(world.stateHash(), Saves.restored(snapshot).stateHash());
    }

    private static String line(String text) {
        return text.substring(0, text.indexOf('\n') + 1);
    }

    private static Columns table(World world) {
        Columns table = world.get(0).columns;
        table.forced = true; // as applyForce would
        return table;
    }

    private static Object read(World world, String name) {
        try {
            return field(name).get(world);
        } catch (IllegalAccessException e) {
            throw new AssertionError(e);
        }
    }

    private static void write(World world, String name, Object value) {
        try {
            field(name).set(world, value);
        } catch (IllegalAccessException e) {
            throw new AssertionError(e);
        }
    }

    private static Field field(String name) {
        try {
            Field field = World.class.getDeclaredField(name);
            field.setAccessible(true);
            return field;
        } catch (NoSuchFieldException e) {
            throw new AssertionError(e);
        }
    }
}
