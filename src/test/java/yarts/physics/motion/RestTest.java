package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A velocity that decays becomes exactly 0, without subnormal numbers. */
class RestTest {
    private static final int STEPS = 1_000_000;

    static Stream<Arguments> decays() {
        return Arrays.stream(Integrator.values())
                .flatMap(integrator -> Stream.of(0.5, 0.9, 0.99, 0.999).map(decay -> Arguments.of(integrator, decay)));
    }

    /** The z at which an integrator's decay(z) is d. */
    private static double z(Integrator integrator, double d) {
        switch (integrator) {
            case EULER:
                return 1 - d;
            case SEMI_IMPLICIT:
                return 1 / d - 1;
            case MIDPOINT:
                return 2 * (1 - d) / (1 + d);
            default:
                return -Math.log(d);
        }
    }

    @ParameterizedTest
    @MethodSource("decays")
    void aDecayingVelocityEndsAtExactlyZero(Integrator integrator, double decay) {
        Unit unit = new Unit(1).setFriction(z(integrator, decay)).setVelocity(10, -1e-3);
        unit.integrate(1, integrator);
        assertEquals(10 * decay, unit.getVx(), 1e-14, "the decay of this test");
        for (int i = 1; i < STEPS; i++) {
            unit.integrate(1, integrator);
            assertNormalOrZero(unit.getVx());
            assertNormalOrZero(unit.getVy());
        }
        assertAtRest(unit);
        double x = unit.getX(), y = unit.getY();
        unit.integrate(1e9, integrator);
        assertEquals(x, unit.getX());
        assertEquals(y, unit.getY());
        assertTrue(x > 9.99 && x < Double.MAX_VALUE);
    }

    @ParameterizedTest
    @MethodSource("decays")
    void aWorldComesToRestAsAWhole(Integrator integrator, double decay) {
        World world = new World(integrator, Timestep.fixed(60));
        for (int i = -300; i <= 150; i += 50) { // from just above rest to the greatest speed
            double v = Math.pow(10, i);
            world.add(new Unit(1).setFriction(z(integrator, decay)).setVelocity(-v, v / 3));
        }
        for (int i = 0; i < STEPS; i++) world.step(1);
        world.units().forEach(RestTest::assertAtRest);
    }

    @Test
    void withoutARestThresholdADecayingVelocityNeverReachesZero() {
        double v = 10;
        for (int i = 0; i < STEPS; i++) v *= 0.9;
        assertTrue(v > 0 && v < Double.MIN_NORMAL);
    }

    @Test
    void withoutFrictionTheSmallestVelocityDoesNotDecay() {
        double slow = 2 * Range.REST;
        for (Integrator integrator : Integrator.values()) {
            Unit unit = new Unit(1).setVelocity(slow, -slow);
            for (int i = 0; i < 1000; i++) unit.integrate(1, integrator);
            assertEquals(slow, unit.getVx());
            assertEquals(-slow, unit.getVy());
        }
    }

    @Test
    void aVelocityBelowRestIsRestAtOnce() {
        for (double v : new double[] {Double.MIN_VALUE, Double.MIN_NORMAL, 1e-200, Math.nextDown(Range.REST), -0.0}) {
            assertAtRest(new Unit(1).setVelocity(v, -v));
            Unit kicked = new Unit(1);
            kicked.applyImpulse(-v, v);
            assertAtRest(kicked);
        }
    }

    @Test
    void aUnitAtRestCanBePushedAgain() {
        for (Integrator integrator : Integrator.values()) {
            Unit unit = new Unit(2).setFriction(2e6).setVelocity(5, 5);
            for (int i = 0; i < 1000; i++) unit.integrate(1, integrator);
            assertAtRest(unit);
            unit.applyForce(2e6, 0);
            unit.integrate(1, integrator);
            double gain = integrator == Integrator.SEMI_IMPLICIT ? 1e6 / (1 + 1e6) : 1; // z = 1e6
            assertEquals(gain, unit.getVx(), 1e-15);
            assertEquals(0, unit.getVy());
        }
    }

    /** The smallest top speed with which a unit moves; any smaller one pins it. */
    @Test
    void aUnitWithATopSpeedOfRestMovesAtThatSpeed() {
        for (boolean alone : new boolean[] {true, false}) {
            Unit unit = new Unit(1).setMaxSpeed(Range.REST).setVelocity(Range.REST, 0);
            World world = new World(Integrator.EULER, Timestep.variable(1));
            if (!alone) world.add(unit);
            for (int i = 0; i < 3; i++) {
                if (alone) unit.integrate(1);
                else world.step(1);
            }
            assertEquals(Range.REST, unit.getVx());
            assertEquals(3 * Range.REST, unit.getX());
        }
    }

    /** Neither subnormal nor −0.0. */
    private static void assertNormalOrZero(double v) {
        if (Math.abs(v) < Double.MIN_NORMAL) assertEquals(0L, Double.doubleToRawLongBits(v), () -> "v " + v);
    }

    private static void assertAtRest(Unit unit) {
        assertEquals(0L, Double.doubleToRawLongBits(unit.getVx()), () -> "vx " + unit.getVx());
        assertEquals(0L, Double.doubleToRawLongBits(unit.getVy()), () -> "vy " + unit.getVy());
    }
}
