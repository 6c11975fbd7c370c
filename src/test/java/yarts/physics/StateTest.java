package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import yarts.physics.snapshot.Saves;

/** Properties of the state that are not visible in bytes: new fields, and the sign of zero in memory. */
class StateTest {
    /** Each field is in hash and snapshots, is computed from such fields, or is used only during a frame. */
    @Test
    void everyFieldIsKnown() {
        Stream<String> known = Stream.of(Table.STATE);
        Stream<String> working = Stream.of("cap", "decay", "gain", "lag", "frameX", "frameY");
        assertFields(Table.class, double[].class, Stream.concat(known, working));
        assertFields(Table.class, long[].class, Stream.of("id"));
        Stream<String> flags =
                Stream.of("pushed", "pending", "waiting", "framed", "motored", "still", "asleep", "stale");
        assertFields(Table.class, boolean[].class, flags);
        Stream<String> state = Stream.of("table", "clock", "integrator", "lastId", "lastSteppedId", "interpolating");
        assertFields(State.class, null, state);
        Stream<String> counts = Stream.of("tick", "regular", "remainder", "droppedSteps", "remainderError");
        assertFields(Clock.class, null, Stream.concat(counts, Stream.of("timestep", "irregular", "dropped")));
        assertFields(Timestep.class, null, Stream.of("rate", "maxStep", "maxSteps"));
        assertEquals(5 + 2 * 2, Clock.STATE.length, "two sums have an error, too");
        assertEquals(Saves.STATE, List.of(Table.STATE), "the names in the document");
    }

    /** Compares the names of the fields of a type, or of any type if it is null. */
    private static void assertFields(Class<?> of, Class<?> type, Stream<String> expected) {
        Set<String> names = new HashSet<>();
        for (Field field : of.getDeclaredFields()) {
            if (Modifier.isStatic(field.getModifiers()) || field.isSynthetic()) continue;
            if (type == null || field.getType() == type) names.add(field.getName());
        }
        assertEquals(new HashSet<>(expected.toList()), names, of.getSimpleName());
    }

    /** Players with the same version compare hashes. This number changes only if a version changes the hash. */
    @Test
    void theHashOfMotorsIsTheSameInEveryRun() {
        World world = new World(Integrator.EULER, Timestep.fixed(60));
        world.add(new Unit(2)).setMotor(3, -5, 7);
        assertEquals(0x834247b3d49e6c0fL, world.stateHash());
    }

    /** A clock of a snapshot may have a rounding error that no run reaches. */
    @Test
    void theWaitingTimeStaysBelowASecondAfterAChangeOfTheTimestep() {
        Clock clock = new Clock(Timestep.fixed(1));
        clock.setState(Timestep.fixed(1), new long[] {0, 0, 999_999_999, 0, Double.doubleToRawLongBits(1), 0, 0, 0, 0});
        clock.setTimestep(Timestep.fixed(2));
        assertEquals(1_999_999_999, clock.remainder());
        new Clock(Timestep.fixed(1)).setState(Timestep.fixed(2), clock.state());
    }

    @Test
    void theSignOfZeroChangesNeitherHashNorBytes() {
        World world = new World();
        for (int i = 1; i <= 100; i++) world.add(new Unit(i).setFrozen(true)).applyForce(i, -i);
        world.addAfterStep((w, dt) -> w.forEach(unit -> unit.applyForce(1, 2)));
        world.advance(0.04);
        for (double[] column : world.state.table.columns()) {
            if (column == world.state.table.mass) continue;
            Arrays.fill(column, 10, 20, 0.0);
            long hash = world.stateHash();
            Snapshot zeros = world.save();
            Arrays.fill(column, 10, 20, -0.0);
            assertEquals(hash, world.stateHash());
            assertEquals(-1, Arrays.mismatch(zeros.toBytes(), world.save().toBytes()));
            assertEquals("", zeros.difference(world.save()));
        }
    }
}
