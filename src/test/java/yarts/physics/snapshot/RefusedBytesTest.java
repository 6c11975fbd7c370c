package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;

/** Every value is checked as the setters would, and more: bytes hold a state that a world can be in, or are refused. */
class RefusedBytesTest {
    static Stream<Arguments> bad() {
        double inf = Double.POSITIVE_INFINITY, nan = Double.NaN;
        double tiny = Double.MIN_VALUE, most = Double.MAX_VALUE;
        List<Arguments> bad = new ArrayList<>();
        for (Object[] row : new Object[][] {
            {"magic", 0L, -1L},
            {"version", 0, 2, -1, 1 << 24},
            {"integrator", 4, -1, 127},
            {"interpolating", 2, -1},
            {"padding", 1, -1},
            {"padding again", 1, -1},
            {"rate", -1, 59, 1_000_001, Integer.MAX_VALUE, Integer.MIN_VALUE},
            {"maxStep", nan, inf, -inf, 0, -1, Math.nextUp(1 / 60.0), Math.nextDown(1 / 60.0), tiny, most},
            {"maxSteps", 0, -1, Integer.MIN_VALUE},
            {"tick", -1L, Long.MIN_VALUE, 1L << 61, Long.MAX_VALUE, 0},
            {"regularTicks", -1L, Long.MIN_VALUE, 5, Long.MAX_VALUE},
            {"remainder", -1L, Long.MIN_VALUE, 60_000_000_000L, Long.MAX_VALUE},
            {"droppedTicks", -1L, Long.MIN_VALUE, 1L << 61, Long.MAX_VALUE},
            {"remainderError", nan, inf, -inf, Math.nextUp(1.0), Math.nextDown(-1.0), most},
            {"time", nan, inf, -inf, -1, -tiny, 1.1e100, most},
            {"timeError", nan, inf, -inf, 1.1e100, -1.1e100},
            {"droppedTime", nan, inf, -inf, -1, -tiny, 1.1e100},
            {"droppedTimeError", nan, inf, -inf, 1.1e100, -1.1e100},
            {"lastSteppedId", -1L, 4L, Long.MIN_VALUE, Long.MAX_VALUE},
            {"lastId", -1L, 0, 2, Long.MIN_VALUE, 1L << 61, Long.MAX_VALUE},
            {"id", 0L, 1L, 3L, -2L, 4L, Long.MIN_VALUE, Long.MAX_VALUE},
            {"x", nan, inf, -inf},
            {"y", nan, inf, -inf},
            {"vx", nan, inf, -inf, 1000.1, -1000.1, most, 0x1p501, tiny, -tiny, Double.MIN_NORMAL / 2},
            {"vy", nan, inf, -inf, 1000.1, -1000.1, most, 0x1p501, tiny, -tiny, Double.MIN_NORMAL / 2},
            {"mass", nan, inf, -inf, 0, -1, 0.999e-50, 1.001e50},
            {"friction", nan, inf, -inf, -1, -tiny, 1.001e50},
            {"maxSpeed", nan, -inf, -1, -tiny, 0, tiny, 1e-200},
            {"frozen", nan, inf, -inf, -1, 2, 0.5, tiny, -tiny, Math.nextDown(1.0), Math.nextUp(1.0)},
            {"motorVx", nan, inf, -inf, most, Math.nextUp(0x1p500), tiny, -tiny, Math.nextDown(0x1p-500)},
            {"motorVy", nan, inf, -inf, -most, -Math.nextUp(0x1p500), tiny, -tiny, -Math.nextDown(0x1p-500)},
            {"motorForce", nan, inf, -inf, -1, -tiny, Math.nextUp(1e50), most},
            {"waitingX", nan, inf, -inf, 1.1e70, -1.1e70},
            {"waitingY", nan, inf, -inf, 1.1e70, -1.1e70},
            {"fx", nan, inf, -inf, 1.1e70, -1.1e70},
            {"fy", nan, inf, -inf, 1.1e70, -1.1e70},
            {"pendingX", nan, inf, -inf, 1.1e70, -1.1e70},
            {"pendingY", nan, inf, -inf, 1.1e70, -1.1e70},
            {"previousX", nan, inf, -inf},
            {"previousY", nan, inf, -inf},
        }) {
            for (int i = 1; i < row.length; i++) bad.add(Arguments.of(row[0], row[i]));
        }
        return bad.stream();
    }

    /** One value changed in the save of three units, of the second of them if it is a unit's; its checksum is right. */
    @ParameterizedTest
    @MethodSource("bad")
    void aValueThatNoWorldCanHaveIsRefused(String name, Number value) {
        byte[] save = Saves.save(3);
        Saves.places(1).get(name).put(save, value);
        String message = Saves.refused(Saves.repair(save));
        String says = message.split(" must | are ")[0];
        switch (name) {
            case "magic":
                assertEquals("the bytes", says);
                break;
            case "rate":
                assertTrue(
                        List.of("stepsPerSecond", "maxStep", "maxSteps", "remainder")
                                .contains(says),
                        message);
                break;
            case "tick": // which bounds another
                assertTrue(List.of("tick", "regularTicks").contains(says), message);
                break;
            case "lastId":
                assertTrue(List.of("lastId", "lastSteppedId", "id").contains(says), message);
                break;
            case "maxSpeed": // which bounds others
                assertTrue(List.of("maxSpeed", "vx", "vy", "speed").contains(says), message);
                break;
            default:
                assertEquals(name.replace(" again", ""), says, message);
        }
    }

    @Test
    void aSpeedOverTheTopSpeedIsRefused() {
        byte[] save = Saves.save(3);
        Saves.places(1).get("vx").put(save, 800);
        Saves.places(1).get("vy").put(save, -800);
        assertTrue(Saves.refused(Saves.repair(save)).startsWith("speed must be at most 1000.0 m/s, was 1131."));
    }

    @Test
    void aTopSpeedBelowRestIsRefusedForAUnitAtRest() {
        byte[] save = Saves.save(3);
        for (String v : List.of("vx", "vy")) Saves.places(1).get(v).put(save, 0);
        for (double tooSlow : new double[] {Double.MIN_VALUE, 1e-200, Math.nextDown(0x1p-500)}) {
            Saves.places(1).get("maxSpeed").put(save, tooSlow);
            assertTrue(Saves.refused(Saves.repair(save)).startsWith("maxSpeed must be "));
        }
    }

    @Test
    void aPinnedUnitThatMovesIsRefused() {
        byte[] save = Saves.save(3);
        Saves.places(1).get("maxSpeed").put(save, 0);
        Saves.places(1).get("vy").put(save, 0);
        Saves.places(1).get("vx").put(save, 1e-201);
        assertTrue(Saves.refused(Saves.repair(save)).startsWith("vx must be 0 "));
        Saves.places(1).get("vx").put(save, 0);
        Saves.assertSound(Snapshot.fromBytes(Saves.repair(save)));
    }

    /** The slowest top speed that is not a pin is a speed, too. */
    @Test
    void aUnitWithATopSpeedOfRestMayMove() {
        byte[] save = Saves.save(3);
        Saves.places(1).get("maxSpeed").put(save, 0x1p-500);
        Saves.places(1).get("vx").put(save, 0x1p-500);
        Saves.places(1).get("vy").put(save, 0);
        Saves.assertSound(Snapshot.fromBytes(Saves.repair(save)));
    }

    /** It would come to rest beside others that move, and not alone. */
    @Test
    void aFrozenUnitOnItsWayToRestIsRefused() {
        for (String v : List.of("vx", "vy")) {
            byte[] save = Saves.save(3);
            Saves.places(1).get(v).put(save, Math.nextDown(0x1p-500));
            Saves.assertSound(Snapshot.fromBytes(Saves.repair(save)));
            Saves.places(1).get("frozen").put(save, 1);
            assertTrue(
                    Saves.refused(Saves.repair(save)).startsWith(v + " of a frozen unit must be 0 or at least 3.05"));
            Saves.places(1).get(v).put(save, 0x1p-500);
            Saves.assertSound(Snapshot.fromBytes(Saves.repair(save)));
        }
    }

    @Test
    void noTimestepLeavesARemainderOfASecond() {
        byte[] save = Saves.save(3, Timestep.variable(0.02));
        Saves.places(0).get("remainder").put(save, 999_999_999L);
        Saves.assertSound(Snapshot.fromBytes(Saves.repair(save)));
        Saves.places(0).get("remainder").put(save, 1_000_000_000L);
        assertEquals("remainder must be from 0 to 999999999, was 1000000000", Saves.refused(Saves.repair(save)));
    }

    /** As far apart as two doubles can be, so that half-way between them would be no number. */
    @Test
    void positionsTooFarApartToInterpolateAreRefused() {
        for (String axis : List.of("X", "Y")) {
            byte[] save = Saves.save(3);
            Saves.places(1).get(axis.toLowerCase(Locale.ROOT)).put(save, Double.MAX_VALUE);
            Saves.places(1).get("previous" + axis).put(save, -Double.MAX_VALUE);
            assertTrue(Saves.refused(Saves.repair(save)).contains("previous" + axis));
        }
    }

    @Test
    void aMessageTellsTheNumbers() {
        int least = Saves.HEADER + Saves.CRC;
        for (int length = 0; length < least; length++) {
            assertEquals(
                    "the bytes are truncated: a snapshot has at least " + least + ", these are " + length,
                    Saves.refused(Arrays.copyOf(Saves.save(3), length)));
        }
        byte[] save = Saves.save(3);
        Saves.order(save).putInt(12, 2);
        int two = least + 2 * Saves.RECORD, three = least + 3 * Saves.RECORD;
        assertEquals(
                "the bytes are too many: a snapshot of 2 units has " + two + ", these are " + three,
                Saves.refused(Saves.repair(save)));
        assertEquals(
                "the bytes are truncated: a snapshot of 3 units has " + three + ", these are " + (three - 1),
                Saves.refused(Arrays.copyOf(Saves.save(3), three - 1)));
    }

    /** So that a sign that nothing else shows does not come to light, say in a unit's log. */
    @Test
    void minusZeroIsReadAsZero() {
        for (String name : Saves.STATE) {
            if (name.equals("mass")) continue;
            byte[] save = Saves.save(3);
            if (name.equals("maxSpeed"))
                for (String v : List.of("vx", "vy")) Saves.places(1).get(v).put(save, 0);
            Saves.places(1).get(name).put(save, -0.0);
            Unit unit = Saves.restored(Snapshot.fromBytes(Saves.repair(save))).get(1);
            assertEquals(0.0, Saves.state(unit, name), name);
        }
    }

    @Test
    void valuesAtTheLimitsAreAccepted() {
        double tiny = Double.MIN_VALUE;
        for (Object[] row : new Object[][] {
            {"maxSteps", 1, Integer.MAX_VALUE},
            {"tick", (1L << 61) - 100},
            {"droppedTicks", 0L, (1L << 61) - 1},
            {"remainder", 0L, 59_999_999_999L},
            {"remainderError", 1, -1, tiny, -0.0, 0.5},
            {"time", 0, -0.0, 1e100},
            {"droppedTime", 1e100},
            {"timeError", 1e100, -1e100},
            {"lastId", 3L, (1L << 61) - 100},
            {"x", Double.MAX_VALUE, -Double.MAX_VALUE, Double.MIN_VALUE, -0.0},
            {"vx", -0.0, Double.MIN_NORMAL, 0x1p-501, 999},
            {"mass", 1e-50, 1e50},
            {"friction", -0.0, 1e50},
            {"maxSpeed", Double.POSITIVE_INFINITY, Double.MAX_VALUE},
            {"frozen", 0, -0.0, 1},
            {"motorVx", 0, -0.0, 0x1p-500, -0x1p500, 1e3},
            {"motorVy", 0, -0.0, -0x1p-500, 0x1p500, -1e3},
            {"motorForce", 0, -0.0, tiny, 1e50},
            {"fx", 1e70, -1e70},
            {"waitingX", 1e70, -1e70},
            {"pendingY", 1e70, -1e70},
        }) {
            for (int i = 1; i < row.length; i++) {
                byte[] save = Saves.save(3);
                Saves.places(1).get(row[0].toString()).put(save, (Number) row[i]);
                Saves.assertSound(Snapshot.fromBytes(Saves.repair(save)));
            }
        }
    }
}
