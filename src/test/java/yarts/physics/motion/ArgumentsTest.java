package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.NotSerializableException;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoublePredicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/** Every argument of every method: accepted and harmless, or refused with value and rule, and nothing changed. */
class ArgumentsTest {
    private static final double[] VALUES = {
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        -0.0,
        0.0,
        1,
        -1,
        Double.MIN_VALUE,
        -Double.MIN_VALUE,
        Double.MIN_NORMAL,
        -Double.MIN_NORMAL,
        1e-50,
        Math.nextDown(1e-50),
        1e9,
        Math.nextUp(1e9),
        1e50,
        Math.nextUp(1e50),
        -1e50,
        -Math.nextUp(1e50),
        1e154,
        -1e154,
        Double.MAX_VALUE,
        -Double.MAX_VALUE,
    };

    private interface Call {
        void on(World world, Unit unit, double value);
    }

    /** A method with one argument varied: its name, what it accepts, and how an error names argument and rule. */
    private record Door(String method, String argument, String rule, DoublePredicate accepts, Call call) {
        @Override
        public String toString() {
            return method + " " + argument;
        }
    }

    private static final DoublePredicate FINITE = Double::isFinite;
    private static final DoublePredicate TIME = t -> t >= 0 && t <= 1e9;
    private static final DoublePredicate FORCE = f -> f >= 0 && f <= 1e50;
    private static final DoublePredicate PUSH = f -> Math.abs(f) <= 1e50;
    private static final DoublePredicate ALPHA = a -> a >= 0 && a <= 1;
    private static final DoublePredicate MASS = m -> m >= 1e-50 && m <= 1e50;

    private static List<Door> doors() {
        List<Door> doors = new ArrayList<>(List.of(
                new Door("new Unit", "mass", "> 0", MASS, (w, u, v) -> w.add(new Unit(v))),
                new Door("setMass", "mass", "> 0", MASS, (w, u, v) -> u.setMass(v)),
                new Door("setPosition", "x", "finite", FINITE, (w, u, v) -> u.setPosition(v, 1)),
                new Door("setPosition", "y", "finite", FINITE, (w, u, v) -> u.setPosition(1, v)),
                new Door("setVelocity", "vx", "finite", FINITE, (w, u, v) -> u.setVelocity(v, 1)),
                new Door("setVelocity", "vy", "finite", FINITE, (w, u, v) -> u.setVelocity(1, v)),
                new Door("setMotor", "vx", "finite", FINITE, (w, u, v) -> u.setMotor(v, 1, 2)),
                new Door("setMotor", "vy", "finite", FINITE, (w, u, v) -> u.setMotor(1, v, 2)),
                new Door("setMotor", "maxForce", ">= 0", FORCE, (w, u, v) -> u.setMotor(1, 2, v)),
                new Door("setFriction", "friction", ">= 0", FORCE, (w, u, v) -> u.setFriction(v)),
                new Door("setMaxSpeed", "maxSpeed", ">= 0", s -> s >= 0, (w, u, v) -> u.setMaxSpeed(v)),
                new Door("applyForce", "fx", "finite", PUSH, (w, u, v) -> u.applyForce(v, 1)),
                new Door("applyForce", "fy", "finite", PUSH, (w, u, v) -> u.applyForce(1, v)),
                new Door("applyImpulse", "jx", "finite", PUSH, (w, u, v) -> u.applyImpulse(v, 1)),
                new Door("applyImpulse", "jy", "finite", PUSH, (w, u, v) -> u.applyImpulse(1, v)),
                new Door("integrate", "dt", ">= 0", TIME, (w, u, v) -> u.integrate(v)),
                new Door("step", "dt", ">= 0", TIME, (w, u, v) -> w.step(v)),
                new Door("advance", "elapsed", ">= 0", TIME, (w, u, v) -> w.advance(v)),
                new Door("getInterpolatedX", "alpha", "from 0 to 1", ALPHA, (w, u, v) -> u.getInterpolatedX(v)),
                new Door("getInterpolatedY", "alpha", "from 0 to 1", ALPHA, (w, u, v) -> u.getInterpolatedY(v)),
                new Door("copyPositions", "alpha", "from 0 to 1", ALPHA, (w, u, v) -> copyPositions(w, v)),
                new Door("copyPositions", "alpha", "from 0 to 1", ALPHA, (w, u, v) -> copyFloats(w, v)),
                new Door("applyForces", "xy[1]", "finite", PUSH, (w, u, v) -> w.applyForces(new double[] {9, v, 1}, 1)),
                new Door("applyForces", "xy[2]", "finite", PUSH, (w, u, v) -> w.applyForces(new double[] {9, 1, v}, 1)),
                new Door("Timestep.variable", "maxStep", "from 1.0E-6", s -> s >= 1e-6 && s <= 1e9, (w, u, v) -> {
                    World other =
                            new World(Integrator.EXACT, Timestep.variable(v).withMaxSteps(3));
                    other.add(new Unit(1)).applyForce(1, 1);
                    other.advance(1);
                    assertTrue(Double.isFinite(other.get(0).getX()));
                })));
        for (Integrator integrator : Integrator.values()) {
            doors.add(new Door("integrate " + integrator, "dt", ">= 0", TIME, (w, u, v) -> u.integrate(v, integrator)));
        }
        return doors;
    }

    private static void copyPositions(World world, double alpha) {
        double[] xy = {9, 9};
        try {
            world.copyPositions(xy, 0, alpha);
        } catch (IllegalArgumentException e) {
            assertArrayEquals(new double[] {9, 9}, xy);
            throw e;
        }
    }

    private static void copyFloats(World world, double alpha) {
        float[] xy = {9, 9};
        try {
            world.copyPositions(xy, 0, alpha);
        } catch (IllegalArgumentException e) {
            assertArrayEquals(new float[] {9, 9}, xy);
            throw e;
        }
    }

    static Stream<Arguments> everyDoorAndValue() {
        return doors().stream().flatMap(door -> Arrays.stream(VALUES).mapToObj(v -> Arguments.of(door, v)));
    }

    @ParameterizedTest
    @MethodSource("everyDoorAndValue")
    void isAcceptedAndHarmlessOrRefusedAndNothingIsChanged(Door door, double value) {
        for (Integrator integrator : Integrator.values()) {
            for (Timestep timestep : List.of(Timestep.fixed(64), Timestep.variable(0.01))) {
                World world = new World(integrator, timestep);
                Unit unit = world.add(new Unit(2).setFriction(3).setMaxSpeed(50).setVelocity(4, -5));
                unit.setMotor(-6, 7, 8);
                unit.applyForce(1, 2);
                world.advance(0.1);
                unit.applyForce(6, 7);
                if (door.accepts.test(value)) {
                    door.call.on(world, unit, value);
                    assertSound(world);
                } else {
                    List<Object> before = state(world);
                    IllegalArgumentException e =
                            assertThrows(IllegalArgumentException.class, () -> door.call.on(world, unit, value));
                    assertTrue(e.getMessage().startsWith(door.argument + " must be "), e.getMessage());
                    assertTrue(e.getMessage().contains(door.rule), e.getMessage());
                    assertTrue(e.getMessage().endsWith(", was " + value), e.getMessage());
                    assertEquals(before, state(world));
                }
            }
        }
    }

    @Test
    void countsOutOfRangeAreRefused() {
        for (int bad : new int[] {0, -1, Integer.MIN_VALUE, 1_000_001, Integer.MAX_VALUE}) {
            String message = assertThrows(IllegalArgumentException.class, () -> Timestep.fixed(bad))
                    .getMessage();
            assertTrue(message.contains("stepsPerSecond must be from 1 to 1000000"), message);
            assertTrue(message.endsWith("was " + bad), message);
        }
        for (int bad : new int[] {0, -1, Integer.MIN_VALUE}) {
            String message = assertThrows(
                            IllegalArgumentException.class,
                            () -> Timestep.fixed(1).withMaxSteps(bad))
                    .getMessage();
            assertEquals("maxSteps must be >= 1, was " + bad, message);
        }
        for (int good : new int[] {1, 1_000_000}) Timestep.fixed(good).withMaxSteps(Integer.MAX_VALUE);
    }

    @Test
    void nullIsRefusedByName() {
        World world = new World();
        Unit unit = world.add(new Unit(1));
        List<Object> before = state(world);
        refusesNull("integrator", () -> unit.integrate(1, null));
        refusesNull("integrator", () -> new World(null, Timestep.fixed(1)));
        refusesNull("integrator", () -> world.setIntegrator(null));
        refusesNull("timestep", () -> new World(Integrator.EULER, null));
        refusesNull("timestep", () -> world.setTimestep(null));
        refusesNull("unit", () -> world.add(null));
        refusesNull("into", () -> world.save(null));
        refusesNull("from", () -> world.restore(null));
        refusesNull("factory", () -> world.restore(new Snapshot(), null));
        refusesNull("bytes", () -> Snapshot.fromBytes(null));
        refusesNull("other", () -> world.save().difference(null));
        assertThrows(NullPointerException.class, () -> world.removeIf(null));
        assertThrows(NullPointerException.class, () -> world.applyForces(null, 0));
        assertThrows(NullPointerException.class, () -> world.copyVelocities(null, 0));
        assertThrows(NullPointerException.class, () -> world.copyPositions(null, 0));
        assertThrows(NullPointerException.class, () -> world.copyPositions((float[]) null, 0, 1));
        assertThrows(NullPointerException.class, () -> world.copyPositions((double[]) null, 0, 1));
        assertEquals(before, state(world));
    }

    private static void refusesNull(String name, Executable call) {
        assertEquals(
                name + " must not be null",
                assertThrows(NullPointerException.class, call).getMessage());
    }

    /** A force anywhere in the array, and an offset, is refused before any force is applied. */
    @Test
    void bulkForcesAreAppliedToAllOrToNone() {
        World world = new World();
        for (int i = 0; i <= Tiles.TILE; i++) world.add(new Unit(1 + i)).applyForce(i, 1);
        int length = 2 * world.size();
        List<Object> before = state(world);
        for (int bad : new int[] {0, 1, length / 2, length - 2, length - 1}) {
            for (double value : new double[] {Double.NaN, Double.NEGATIVE_INFINITY, Math.nextUp(1e50)}) {
                double[] xy = new double[length + 3];
                Arrays.fill(xy, 7);
                xy[3 + bad] = value;
                assertEquals(
                        "xy[" + (3 + bad) + "] must be finite and at most 1.0E50 in magnitude, was " + value,
                        assertThrows(IllegalArgumentException.class, () -> world.applyForces(xy, 3))
                                .getMessage());
                assertEquals(before, state(world));
            }
        }
        for (int offset : new int[] {-1, 1, length, Integer.MIN_VALUE, Integer.MAX_VALUE}) {
            assertThrows(IndexOutOfBoundsException.class, () -> world.applyForces(new double[length], offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyVelocities(new double[length], offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(new float[length], offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(new float[length], offset, 1));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(new double[length], offset, 1));
        }
        assertEquals(before, state(world));
        double[] outside = new double[length + 2];
        outside[0] = outside[length + 1] = Double.NaN; // not among those that are asked for
        world.applyForces(outside, 1);
        assertEquals(before, state(world));
        world.clear();
        world.applyForces(new double[2], 2);
    }

    @Test
    void indicesOutOfRangeAreRefused() {
        World world = new World();
        world.add(new Unit(1));
        for (int bad : new int[] {-1, 1, Integer.MIN_VALUE, Integer.MAX_VALUE}) {
            assertThrows(IndexOutOfBoundsException.class, () -> world.get(bad));
            assertThrows(IndexOutOfBoundsException.class, () -> world.units().get(bad));
        }
        for (long nobody : new long[] {0, -1, 2, Long.MIN_VALUE, Long.MAX_VALUE}) assertNull(world.find(nobody));
    }

    /** A unit whose class says that it can be serialised. */
    private static final class Sent extends Unit implements Serializable {
        private static final long serialVersionUID = 1;

        Sent() {
            super(1);
        }
    }

    /** Even where there is nothing to copy. */
    @Test
    void aPlaceBeyondTheArrayIsRefusedByAnEmptyWorld() {
        World world = new World();
        for (int offset : new int[] {-1, 5, Integer.MAX_VALUE}) {
            assertThrows(IndexOutOfBoundsException.class, () -> world.applyForces(new double[4], offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyVelocities(new double[4], offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(new double[4], offset, 1));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(new float[4], offset));
        }
        world.applyForces(new double[4], 4);
    }

    @Test
    void serialisationIsRefusedAndSaysWhatToSaveInstead() throws IOException {
        Unit unit = new World().add(new Sent());
        try (ObjectOutputStream out = new ObjectOutputStream(new ByteArrayOutputStream())) {
            assertEquals(
                    Sent.class.getName() + " is a Unit: save a Snapshot, and its own fields by id",
                    assertThrows(NotSerializableException.class, () -> out.writeObject(unit))
                            .getMessage());
        }
    }

    @Test
    void negativeZeroIsZero() {
        Unit unit = new Unit(1).setPosition(-0.0, -0.0).setVelocity(-0.0, -0.0).setFriction(-0.0);
        unit.applyForce(-0.0, -0.0);
        unit.setMaxSpeed(-0.0).setMotor(-0.0, -0.0, -0.0);
        for (double v : new double[] {
            unit.getX(),
            unit.getY(),
            unit.getVx(),
            unit.getVy(),
            unit.getFx(),
            unit.getFy(),
            unit.getFriction(),
            unit.getMaxSpeed(),
            unit.getMotorVx(),
            unit.getMotorVy(),
            unit.getMotorForce()
        }) {
            assertEquals(0.0, v);
        }
    }

    /** Goes on for a while, with pushes, and finds every number finite. */
    private static void assertSound(World world) {
        for (int i = 0; i < 50; i++) {
            for (Unit unit : world) unit.applyForce(-3, 1e50);
            world.advance(0.01);
            world.step(0.02);
            for (Unit unit : world) {
                unit.integrate(0.01, Integrator.EXACT);
                unit.applyImpulse(1e50, -1e50);
                for (double v : new double[] {
                    unit.getX(),
                    unit.getY(),
                    unit.getVx(),
                    unit.getVy(),
                    unit.getSpeed(),
                    unit.getFx(),
                    unit.getFy(),
                    unit.getPendingImpulseX(),
                    unit.getPendingImpulseY(),
                    unit.getInterpolatedX(),
                    unit.getInterpolatedY(),
                    unit.getInterpolatedX(0.5),
                    unit.getInterpolatedY(0.5)
                }) {
                    assertTrue(Double.isFinite(v), unit.toString());
                }
                assertTrue(unit.getSpeed() <= unit.getMaxSpeed(), unit.toString());
            }
        }
        float[] xy = new float[2 * world.size()];
        world.copyPositions(xy, 0);
        for (float v : xy) assertTrue(Float.isFinite(v));
        assertTrue(Double.isFinite(world.getTime()) && Double.isFinite(world.getDroppedTime()));
    }

    /** Everything there is to know of a world: every getter, and all that a save holds. */
    private static List<Object> state(World world) {
        byte[] save = world.save().toBytes();
        return List.of(Churn.bits(world), ByteBuffer.wrap(save), world.stateHash());
    }
}
