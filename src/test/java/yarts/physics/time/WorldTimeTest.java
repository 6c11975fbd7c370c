package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** Examples of steps, time, and interpolation between two steps. */
public class WorldTimeTest {
    private final World world = new World(Integrator.EULER, Timestep.fixed(10));
    private final Unit unit = world.add(new Unit(1).setVelocity(10, -20));

    @Test
    void aStepOfAnyLengthCountsAsOneTickAndItsTime() {
        world.step(0.3);
        world.step(0);
        world.step(0.1);
        assertEquals(3, world.getTick());
        assertEquals(0.4, world.getTime(), 1e-15);
        assertEquals(4, unit.getX(), 1e-14);
        assertEquals(0, world.getDroppedTime());
        world.advance(0.25);
        assertEquals(5, world.getTick());
        assertEquals(0.6, world.getTime(), 1e-15);
        assertEquals(0.5, world.getAlpha(), 1e-15);
    }

    @Test
    void timeBeyondTheLimitIsDroppedAndCounted() {
        World world = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(3));
        assertEquals(3, world.advance(1.05));
        assertEquals(0.3, world.getTime(), 1e-15);
        assertEquals(0.7, world.getDroppedTime(), 1e-15);
        assertEquals(0.5, world.getAlpha(), 1e-15);
        World usual = new World();
        assertEquals(15, usual.advance(1), "a quarter of a second");
        World slow = new World(Integrator.EULER, Timestep.fixed(1));
        assertEquals(1, slow.advance(5), "at least one");
    }

    @Test
    void theImpulseOfDroppedTimeIsDropped() {
        World world = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(3));
        Unit unit = world.add(new Unit(1));
        unit.applyForce(10, 0);
        world.advance(1);
        assertEquals(3, unit.getVx(), 1e-14);
        World variable = new World(Integrator.EULER, Timestep.variable(0.1).withMaxSteps(3));
        Unit other = variable.add(new Unit(1));
        other.applyForce(10, 0);
        assertEquals(3, variable.advance(1));
        assertEquals(3, other.getVx(), 1e-14);
        assertEquals(0.7, variable.getDroppedTime(), 1e-15);
    }

    @Test
    void aVariableFrameIsDividedIntoEqualStepsWithTheSameForce() {
        World world = new World(Integrator.EULER, Timestep.variable(0.1).withMaxSteps(5));
        Unit unit = world.add(new Unit(1));
        List<Double> steps = new ArrayList<>();
        world.addBeforeStep((w, dt) -> steps.add(dt));
        unit.applyForce(8, 0);
        assertEquals(3, world.advance(0.25));
        assertEquals(List.of(0.25 / 3, 0.25 / 3, 0.25 / 3), steps);
        assertEquals(2, unit.getVx(), 1e-14);
        assertEquals(1, world.advance(0.1));
        assertEquals(1, world.advance(1e-3));
        assertEquals(0, world.advance(0));
        assertEquals(0.351, world.getTime(), 1e-15);
        assertEquals(0, world.getAlpha());
        assertEquals(unit.getX(), unit.getInterpolatedX());
    }

    /** The time of steps that an exception prevents is dropped and counted. */
    @Test
    void theVariableStepsThatDidNotRunAreDropped() {
        World world = new World(Integrator.EULER, Timestep.variable(0.25).withMaxSteps(4));
        world.addBeforeStep((w, dt) -> {
            if (w.getTick() == 1) throw new IllegalStateException("the second step");
        });
        assertThrows(IllegalStateException.class, () -> world.advance(1));
        assertEquals(0.25, world.getTime());
        assertEquals(0.75, world.getDroppedTime());
    }

    @Test
    void aVariableFrameIsDividedIntoTheFewestSteps() {
        World world = new World(Integrator.EULER, Timestep.variable(0.25).withMaxSteps(100));
        double[] elapsed = {0.1, 0.25, 0.26, 0.5, 0.75, 0.8, 1, 20};
        int[] steps = {1, 1, 2, 2, 3, 4, 4, 80};
        for (int i = 0; i < steps.length; i++) assertEquals(steps[i], world.advance(elapsed[i]));
    }

    @Test
    void aForceIsDiscardedIfTheTimeIsZero() {
        unit.applyForce(1000, 1000);
        world.step(0);
        assertEquals(0, unit.getFx());
        unit.applyForce(1000, 1000);
        assertEquals(0, world.advance(0));
        assertEquals(0, unit.getFx());
        world.advance(1);
        assertEquals(10, unit.getVx());
        assertEquals(-20, unit.getVy());
    }

    @Test
    void theInterpolatedPositionLiesBetweenTheLastTwoSteps() {
        world.advance(0.225);
        assertEquals(2, unit.getX(), 1e-15);
        assertEquals(1.25, unit.getInterpolatedX(), 1e-15);
        assertEquals(-2.5, unit.getInterpolatedY(), 1e-15);
        float[] xy = new float[2];
        world.copyPositions(xy, 0);
        assertArrayEquals(new float[] {1.25f, -2.5f}, xy);
        world.advance(0.05);
        assertEquals(2, unit.getX(), 1e-15);
        assertEquals(1.75, unit.getInterpolatedX(), 1e-15);
    }

    @Test
    void aTeleportIsDrawnAtTheNewPositionAtOnce() {
        world.advance(0.25);
        unit.setPosition(1000, 2000);
        assertEquals(1000, unit.getInterpolatedX());
        assertEquals(2000, unit.getInterpolatedY());
        world.advance(0.1);
        assertEquals(1000.5, unit.getInterpolatedX(), 1e-12);
        assertEquals(1999, unit.getInterpolatedY(), 1e-12);
    }

    @Test
    void withoutAFixedStepTheInterpolatedPositionIsThePosition() {
        world.advance(0.15);
        world.step(1);
        assertEquals(unit.getX(), unit.getInterpolatedX());
        Unit late = world.add(new Unit(1).setPosition(5, 6));
        world.advance(0.16);
        world.remove(late);
        assertEquals(5, late.getInterpolatedX());
        world.add(late);
        assertEquals(5, late.getInterpolatedX());
        unit.integrate(1);
        assertEquals(unit.getX(), unit.getInterpolatedX());
    }

    @Test
    void alphaOneNanosecondBeforeAStepIsBelowOneAsAFloat() {
        world.advance(0.099_999_999_9999);
        assertEquals(1, world.getTick(), "rounded to 1e-9 of a step");
        World slow = new World(Integrator.EULER, Timestep.fixed(1));
        slow.advance(0.999_999_999);
        assertEquals(0, slow.getTick());
        assertEquals(Math.nextDown(1f), (float) slow.getAlpha());
    }

    /** Also after a step(dt), and after integrate of one unit. */
    @Test
    void aGameThatKeepsTheTimeInterpolatesBetweenAnyTwoSteps() {
        world.step(0.4);
        assertEquals(4, unit.getX());
        assertEquals(4, unit.getInterpolatedX());
        assertEquals(1, unit.getInterpolatedX(0.25));
        assertEquals(-2, unit.getInterpolatedY(0.25));
        double[] xy = new double[2];
        world.copyPositions(xy, 0, 0.25);
        assertArrayEquals(new double[] {1, -2}, xy);
        float[] floats = new float[2];
        world.copyPositions(floats, 0, 0.25);
        assertArrayEquals(new float[] {1, -2}, floats);
        unit.integrate(1);
        assertEquals(14, unit.getInterpolatedX(0));
        unit.setVelocity(0.1, 0).setPosition(1e16, 0); // where rounding would end before the position
        world.step(1e9);
        assertEquals(unit.getX(), unit.getInterpolatedX(1));
        assertEquals(1e16, unit.getInterpolatedX(0));
    }

    @Test
    void invalidTimesThrowAndChangeNothing() {
        unit.applyForce(1, 1);
        for (double bad : new double[] {-1, -Double.MIN_VALUE, Double.NaN, Double.POSITIVE_INFINITY, 1.1e9}) {
            Exception step = assertThrows(IllegalArgumentException.class, () -> world.step(bad));
            Exception advance = assertThrows(IllegalArgumentException.class, () -> world.advance(bad));
            assertEquals("dt must be finite, >= 0 and <= 1.0E9 s, was " + bad, step.getMessage());
            assertEquals("elapsed must be finite, >= 0 and <= 1.0E9 s, was " + bad, advance.getMessage());
        }
        assertEquals(0, world.getTick());
        assertEquals(1, unit.getFx());
        world.step(-0.0);
        assertEquals(0.0, world.getTime());
    }

    @Test
    void toStringOfATimestepHasItsValues() {
        assertEquals("Timestep.fixed(60).withMaxSteps(15)", Timestep.fixed(60).toString());
        assertEquals("Timestep.fixed(3).withMaxSteps(1)", Timestep.fixed(3).toString());
        assertEquals(
                "Timestep.variable(0.05).withMaxSteps(5)",
                Timestep.variable(0.05).toString());
        assertEquals(
                "Timestep.variable(2.0).withMaxSteps(7)",
                Timestep.variable(2).withMaxSteps(7).toString());
    }

    @Test
    void aStepOfMinusZeroSecondsIsAStepOfZeroSeconds() {
        World world = new World();
        List<Double> steps = new ArrayList<>();
        world.addBeforeStep((w, dt) -> steps.add(dt));
        world.step(-0.0);
        assertEquals(List.of(0.0), steps); // as objects, 0.0 and -0.0 are different
    }
}
