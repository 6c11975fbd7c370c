package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** All that a world's future depends on is in its hash, to the bit, and nothing else is. */
class StateHashTest {
    private final World world = world();
    private final long hash = world.stateHash();

    /** A hundred units with forces held and carried, and interpolated. */
    private static World world() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 1; i <= 100; i++) {
            world.add(new Unit(i).setFriction(i % 7).setMaxSpeed(i % 5 == 0 ? 1 : 1000))
                    .applyForce(i, -i);
        }
        world.advance(0.04);
        for (Unit unit : world) unit.applyForce(unit.getId(), 2);
        return world;
    }

    @Test
    void everyBitOfEveryUnitShows() {
        Columns columns = world.get(0).columns;
        Set<Long> hashes = new HashSet<>(Set.of(hash));
        int flips = 0;
        for (int i = 0; i < 100; i++) {
            for (int bit = 0; bit < 64; bit++, flips++) {
                columns.id[i] ^= 1L << bit;
                assertTrue(hashes.add(world.stateHash()), "id");
                columns.id[i] ^= 1L << bit;
            }
            for (int k = 0; k < Columns.STATE.length; k++) {
                double[] column = columns.state()[k];
                double v = column[i];
                assertTrue(v != 0 || Columns.STATE[k].equals("friction"), Columns.STATE[k]);
                for (int bit = 0; bit < (v == 0 ? 63 : 64); bit++, flips++) {
                    column[i] = Double.longBitsToDouble(Double.doubleToRawLongBits(v) ^ 1L << bit);
                    assertTrue(hashes.add(world.stateHash()), Columns.STATE[k]);
                }
                column[i] = v;
            }
        }
        assertEquals(100 * 14 * 64 - 14, flips); // 14 frictions are 0, whose sign does not count
        assertEquals(hash, world.stateHash());
    }

    @Test
    void everyBitOfTheClockShows() throws Exception {
        Object clock = field(world, "clock").get(world);
        int flips = 0;
        for (Field field : instanceFields(clock)) {
            Object value = field.get(clock);
            if (field.getType() == Timestep.class) continue;
            if (value instanceof Long) flips += flip(clock, field);
            else for (Field part : instanceFields(value)) flips += flip(value, part);
        }
        assertEquals(4 * 64 + 2 * (64 + 63), flips); // an error may be -0.0, which does not count
        assertEquals(4 + 2 * 2, Clock.STATE.length);
    }

    @Test
    void everyBitOfTheWorldsOwnShows() throws Exception {
        assertEquals(64, flip(world, field(world, "lastId")));
        Field interpolating = field(world, "interpolating");
        interpolating.set(world, false);
        assertNotEquals(hash, world.stateHash());
    }

    /** {@return how many bits of a field it flipped, each of which showed} */
    private int flip(Object of, Field field) throws IllegalAccessException {
        boolean whole = field.getType() == long.class;
        long bits = whole ? field.getLong(of) : Double.doubleToRawLongBits(field.getDouble(of));
        int flips = !whole && field.getName().equals("error") ? 63 : 64;
        for (int bit = 0; bit <= flips; bit++) {
            long flipped = bit == flips ? bits : bits ^ 1L << bit; // and back, at the end
            if (whole) field.setLong(of, flipped);
            else field.setDouble(of, Double.longBitsToDouble(flipped));
            assertEquals(bit == flips, hash == world.stateHash(), field + " bit " + bit);
        }
        return flips;
    }

    private static Field field(Object of, String name) throws NoSuchFieldException {
        Field field = of.getClass().getDeclaredField(name);
        field.setAccessible(true);
        return field;
    }

    private static List<Field> instanceFields(Object of) {
        List<Field> fields = new ArrayList<>();
        for (Field field : of.getClass().getDeclaredFields()) {
            if (Modifier.isStatic(field.getModifiers()) || field.isSynthetic()) continue;
            field.setAccessible(true);
            fields.add(field);
        }
        return fields;
    }

    /** A column is in the hash, or is worked out from those that are, or lasts for a frame. */
    @Test
    void noColumnIsForgotten() {
        List<String> known = new ArrayList<>(List.of(Columns.STATE));
        known.addAll(List.of("cap", "decay", "gain", "lag", "frameX", "frameY"));
        List<String> columns = new ArrayList<>();
        for (Field field : instanceFields(world.get(0).columns)) {
            if (field.getType() == double[].class) columns.add(field.getName());
        }
        assertEquals(new HashSet<>(known), new HashSet<>(columns));
    }

    @Test
    void integratorAndTimestepShow() {
        Set<Long> hashes = new HashSet<>();
        for (Integrator how : Integrator.values()) {
            for (Timestep timestep : List.of(
                    Timestep.fixed(60),
                    Timestep.fixed(61),
                    Timestep.fixed(60).withMaxSteps(14),
                    Timestep.fixed(60).withMaxSteps(16),
                    Timestep.variable(1 / 60.0),
                    Timestep.variable(Math.nextUp(1 / 60.0)),
                    Timestep.variable(1 / 60.0).withMaxSteps(14))) {
                assertTrue(hashes.add(new World(how, timestep).stateHash()), how + " " + timestep);
            }
        }
    }

    @Test
    void orderTimeAndForcesShow() {
        Set<Long> hashes = new HashSet<>(Set.of(hash));
        Columns columns = world.get(0).columns;
        swap(columns, 3, 77);
        assertTrue(hashes.add(world.stateHash()), "order");
        swap(columns, 3, 77);
        assertEquals(hash, world.stateHash());
        Unit unit = world.get(5);
        unit.applyForce(1e-9, 0);
        assertTrue(hashes.add(world.stateHash()), "a force");
        world.remove(world.add(new Unit(1)));
        assertTrue(hashes.add(world.stateHash()), "an id that was given");
        world.step(0);
        assertTrue(hashes.add(world.stateHash()), "a step of no time");
        world.advance(1e-9);
        assertTrue(hashes.add(world.stateHash()), "a nanosecond");
        world.clear();
        assertTrue(hashes.add(world.stateHash()), "no units");
    }

    private static void swap(Columns columns, int i, int j) {
        long id = columns.id[i];
        columns.id[i] = columns.id[j];
        columns.id[j] = id;
        for (double[] column : columns.state()) {
            double v = column[i];
            column[i] = column[j];
            column[j] = v;
        }
    }

    @Test
    void theSignOfZeroDoesNotShow() {
        for (double[] column : world.get(0).columns.state()) {
            Arrays.fill(column, 10, 20, 0.0);
            long zeros = world.stateHash();
            Arrays.fill(column, 10, 20, -0.0);
            assertEquals(zeros, world.stateHash());
        }
    }

    /** Forces that were taken back leave no trace, though the table has been told to look for some. */
    @Test
    void forcesTakenBackDoNotShow() {
        World other = world();
        for (World each : List.of(world, other)) {
            for (Unit unit : each) unit.clearForces();
            each.step(1 / 60.0);
        }
        for (Unit unit : world) unit.applyForce(3, 4);
        for (World each : List.of(world, other)) assertEquals(0, each.advance(1e-6)); // carried
        for (Unit unit : world) unit.clearForces();
        world.get(7).applyForce(1, 1);
        world.get(7).clearForces();
        for (int i = 0; i < 3; i++) {
            assertEquals(world.stateHash(), other.stateHash());
            for (World each : List.of(world, other)) each.advance(0.02);
        }
    }
}
