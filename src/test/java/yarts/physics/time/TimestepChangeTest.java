package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.snapshot.Saves;

/** Examples of changes of the timestep, which preserve the waiting time and the pending impulse. */
class TimestepChangeTest {
    /** The greatest alpha, as a float. */
    private static final float ALMOST_ONE = Math.nextDown(1f);

    private final World world = new World(Integrator.EXACT, Timestep.fixed(60));
    private final Unit unit = world.add(new Unit(1));

    /** {@return the waiting seconds of a world} At 1 step/s they are alpha, because they are less than 1 s. */
    static double waiting(World world) {
        World copy = new World();
        copy.restore(world.save());
        copy.setTimestep(Timestep.fixed(1));
        return copy.getAlpha();
    }

    private static void assertBelowOne(double alpha) {
        assertTrue(alpha >= 0 && alpha < 1 && (float) alpha < 1, () -> "alpha " + alpha);
    }

    /** The rate changes within a step. If a change preserved alpha, 60 s would become up to 120 s. */
    @ParameterizedTest
    @ValueSource(ints = {60, 75, 90, 100, 144, 240})
    void sixtySecondsOfFramesAreSixtySecondsOfTheGameAtChangingRates(int framesPerSecond) {
        Timestep slow = Timestep.fixed(20), fast = Timestep.fixed(60);
        for (int i = 0; i < 60 * framesPerSecond; i++) {
            world.setTimestep(world.getAlpha() > 0.5 ? slow : fast);
            assertBelowOne(world.getAlpha());
            world.advance(1.0 / framesPerSecond);
        }
        assertEquals(0, world.getDroppedTime());
        assertEquals(60, world.getTime() + waiting(world), 1e-8);
    }

    /** The clock rounds times to 1e-9 of a step and carries the rounding error over. */
    @Test
    void aVariableStepAfterAChangeIsAsLongAsTheWaitingTime() {
        for (double fraction : new double[] {0, 0.4, -0.4}) {
            World paused = new World(Integrator.EXACT, Timestep.fixed(1));
            double waiting = 0.01 + fraction * 1e-9;
            paused.advance(waiting);
            paused.setTimestep(Timestep.variable(0.1));
            assertEquals(1, paused.advance(0));
            assertEquals(waiting, paused.getTime(), 1e-17);
        }
    }

    /** 54 steps are due for 0.9 s, and 15 run. */
    @Test
    void waitingTimeBeyondTheStepLimitIsDroppedAfterAChange() {
        world.setTimestep(Timestep.fixed(1));
        unit.applyForce(10, 0);
        world.advance(0.9);
        assertEquals(9, unit.getPendingImpulseX(), 1e-15);
        world.setTimestep(Timestep.fixed(60));
        assertEquals(15, world.advance(0));
        assertEquals(0.25, world.getTime());
        assertEquals(0.65, world.getDroppedTime());
        assertEquals(2.5, unit.getVx(), 1e-14);
        assertEquals(0, unit.getPendingImpulseX());
    }

    /** Less would wait longer. */
    @Test
    void aNanosecondIsAVariableStepAfterAChange() {
        World paused = new World(Integrator.EXACT, Timestep.fixed(1));
        paused.advance(1e-9);
        paused.setTimestep(Timestep.variable(1));
        assertEquals(1, paused.advance(0));
        assertEquals(1e-9, paused.getTime());
    }

    /** The step began 0.4 ns too early, so a negative time waits. It must not become a step. */
    @Test
    void aStepThatBeganTooEarlyIsNotTakenBack() {
        World early = new World(Integrator.EXACT, Timestep.fixed(1));
        Unit light = early.add(new Unit(1e-50).setFriction(1));
        assertEquals(1, early.advance(0.9999999996));
        early.setTimestep(Timestep.variable(1));
        light.setVelocity(10, 0);
        assertEquals(0, early.advance(0));
        assertEquals(10, light.getVx());
        assertEquals(1, early.getTime());
        assertEquals(1, early.advance(0.5));
        assertEquals(1.5, early.getTime());
    }

    /** A force of 0 s has no impulse, even if the waiting time becomes steps. */
    @Test
    void aForceForZeroSecondsIsDiscardedAfterAChange() {
        for (Timestep next : List.of(Timestep.fixed(21), Timestep.variable(1))) {
            World paused = new World(Integrator.EULER, Timestep.fixed(2));
            Unit resting = paused.add(new Unit(1));
            paused.advance(0.31830296518763124);
            paused.setTimestep(next);
            resting.applyForce(1e6, -1e6);
            assertTrue(paused.advance(0) > 0);
            assertEquals("0.0 0.0", resting.getVx() + " " + resting.getVy());
            assertEquals(0, resting.getPendingImpulseX());
        }
    }

    /** With variable steps, a unit is drawn where it is. */
    @Test
    void aChangeToVariableStepsAndBackDoesNotChangeWhereAUnitIsDrawn() {
        world.setTimestep(Timestep.fixed(10));
        unit.setVelocity(10, 0);
        world.advance(0.15);
        assertEquals(0.5, unit.getInterpolatedX());
        world.setTimestep(Timestep.variable(0.1));
        assertEquals(1, unit.getInterpolatedX());
        world.setTimestep(Timestep.fixed(10));
        assertEquals(0.5, unit.getInterpolatedX());
    }

    /** 600 N for 0.01 s. If a change preserved the fraction of a step, 18 N·s would arrive at 20 steps/s. */
    @Test
    void sixNewtonSecondsArriveInStepsOfAnyLength() {
        for (Timestep next : List.of(
                Timestep.fixed(20),
                Timestep.fixed(120),
                Timestep.fixed(1).withMaxSteps(9),
                Timestep.fixed(1000),
                Timestep.variable(0.05),
                Timestep.variable(1e-3),
                Timestep.variable(5))) {
            World world = new World(Integrator.EXACT, Timestep.fixed(60));
            Unit unit = world.add(new Unit(1));
            unit.applyForce(600, 0);
            assertEquals(0, world.advance(0.01));
            world.setTimestep(next);
            assertEquals(6, unit.getPendingImpulseX());
            assertEquals(0, unit.getFx());
            assertEquals(0.01, waiting(world), 1e-9);
            for (int i = 0; i < 40; i++) world.advance(0.05);
            assertEquals(6, unit.getVx() + unit.getPendingImpulseX(), 1e-12, next.toString());
            assertEquals(0, unit.getPendingImpulseX(), 1e-12);
            assertEquals(0, world.getDroppedTime());
            assertEquals(2.01, world.getTime() + waiting(world), 1e-8, next.toString());
        }
    }

    @ParameterizedTest
    @CsvSource({"10, 0.25", "20, 0.5", "1, 0.025", "30, 0.75", "39, 0.975", "7, 0.175"})
    void alphaFollowsFromTheWaitingTime(int rate, double alpha) {
        world.setTimestep(Timestep.fixed(10));
        world.advance(0.025);
        world.setTimestep(Timestep.fixed(rate));
        assertEquals(alpha, world.getAlpha(), 1e-9);
    }

    @ParameterizedTest
    @ValueSource(ints = {40, 41, 100, 1000, 1_000_000})
    void alphaStaysBelowOneIfMoreThanAStepWaits(int rate) {
        world.setTimestep(Timestep.fixed(10));
        world.advance(0.025);
        world.setTimestep(Timestep.fixed(rate));
        assertEquals(ALMOST_ONE, world.getAlpha());
        world.setTimestep(Timestep.fixed(10));
        assertEquals(0.25, world.getAlpha(), 1e-9, "no time is lost");
    }

    /** n frames of 1.0/n s are a second, also if the waiting time is counted at another rate between them. */
    @Test
    void noStepIsLateAfterAChangeOfTheRateAndBack() {
        Timestep usual = Timestep.fixed(60).withMaxSteps(60);
        for (int n = 1; n <= 300; n++) {
            for (Timestep other : List.of(Timestep.fixed(7), Timestep.fixed(144), Timestep.variable(0.1))) {
                World world = new World(Integrator.EXACT, usual);
                for (int i = 0; i < 3 * n; i++) {
                    world.setTimestep(other);
                    world.setTimestep(usual);
                    world.advance(1.0 / n);
                }
                assertEquals(180, world.getTick(), n + " frames per second, " + other);
                assertEquals(0, world.getAlpha(), 1e-8);
            }
        }
    }

    /**
     * The frames of 1.0/n s leave a rounding error of some millionths of 1e-9 of a step, which must not be rounded up.
     */
    @Test
    void noStepIsLateAfterAChangeOfTheRateAndBackWithARoundingError() {
        Timestep usual = Timestep.fixed(10);
        for (int n = 1; n <= 300; n++) {
            for (Timestep other : List.of(Timestep.fixed(7), Timestep.fixed(144), Timestep.variable(0.1))) {
                World world = new World(Integrator.EXACT, usual);
                for (int i = 0; i < n; i++) world.advance(1.0 / n);
                assertEquals(0, world.advance(0.025));
                world.setTimestep(other);
                world.setTimestep(usual);
                assertEquals(1, world.advance(0.075), n + " frames per second, " + other);
            }
        }
    }

    @Test
    void theWaitingTimeIsRunInTheNewSteps() {
        world.setTimestep(Timestep.fixed(1));
        assertEquals(0, world.advance(0.9));
        world.setTimestep(Timestep.fixed(60).withMaxSteps(100));
        assertEquals(54, world.advance(0.001));
        assertEquals(0.9, world.getTime(), 1e-15);
        assertEquals(0.06, world.getAlpha(), 1e-8);
        assertEquals(0, world.getDroppedTime());
    }

    @Test
    void theWaitingTimeBeyondTheCatchUpLimitIsDropped() {
        world.setTimestep(Timestep.fixed(1));
        world.advance(0.9);
        world.setTimestep(Timestep.fixed(60));
        assertEquals(0, world.getDroppedTime());
        assertEquals(15, world.advance(0.001));
        assertEquals(0.25, world.getTime(), 1e-15);
        assertEquals(0.65, world.getDroppedTime(), 1e-15);
        assertEquals(0.06, world.getAlpha(), 1e-8);
    }

    /**
     * 0.045 s wait, with 9 N·s; a frame of 0.001 s without a force ends them. Two steps of 1/60 s cover the first
     * 0.0333 s of 0.046 s, of which 0.0117 s are older than the frame: 9 N·s · 0.0117/0.045 stay pending.
     */
    @Test
    void impulseOfTimeOlderThanTheFrameStaysPending() {
        world.setTimestep(Timestep.fixed(20));
        unit.applyForce(200, 100);
        assertEquals(0, world.advance(0.045));
        world.setTimestep(Timestep.fixed(60));
        assertEquals(9, unit.getPendingImpulseX(), 1e-14);
        unit.applyForce(0, 100);
        assertEquals(2, world.advance(0.001));
        double after = 0.046 - 2 / 60.0, old = after - 0.001;
        assertEquals(9 * (1 - old / 0.045), unit.getVx(), 1e-7);
        assertEquals(9 * old / 0.045, unit.getPendingImpulseX(), 1e-7);
        assertEquals(9, unit.getVx() + unit.getPendingImpulseX(), 1e-14);
        assertEquals(100 * (0.046 - after), unit.getVy(), 1e-7, "a constant force stays constant");
        assertEquals(100 * after, unit.getPendingImpulseY(), 1e-7);
        assertEquals(4.6, unit.getVy() + unit.getPendingImpulseY(), 1e-14);
    }

    /** A constant push gives each step the same force, at any sequence of rates. */
    @ParameterizedTest
    @ValueSource(ints = {1, 10, 30, 60, 100, 144, 1000})
    void aConstantForceIsConstantThroughAChangeOfTheRate(int rate) {
        double[] seen = {0, 0};
        world.addBeforeStep((w, dt) -> {
            assertEquals(100, unit.getFx(), 1e-4);
            seen[0]++;
        });
        for (int i = 0; i < 300; i++) {
            world.setTimestep((i % 3 == 0 ? Timestep.fixed(60) : Timestep.fixed(rate)).withMaxSteps(5000));
            unit.applyForce(100, 0);
            world.advance(0.007);
            assertEquals(100 * 0.007 * (i + 1), unit.getVx() + unit.getPendingImpulseX(), 1e-10);
        }
        assertTrue(seen[0] > 10);
    }

    @Test
    void theWaitingTimeIsAddedToTheNextVariableFrame() {
        unit.applyForce(600, 0);
        world.advance(0.01);
        world.setTimestep(Timestep.variable(0.04));
        assertBelowOne(world.getAlpha());
        assertEquals(0, world.getDroppedTime());
        assertEquals(0, world.getTime());
        assertEquals(6, unit.getPendingImpulseX());
        unit.applyForce(100, 0);
        double[] steps = {0, 0};
        world.addBeforeStep((w, dt) -> {
            steps[0]++;
            steps[1] = dt;
        });
        assertEquals(2, world.advance(0.05));
        assertEquals(0.06, world.getTime(), 1e-9);
        assertEquals(0.03, steps[1], 1e-9, "two equal steps of the whole time");
        assertEquals(6 + 5, unit.getVx(), 1e-12);
        assertEquals(0, unit.getPendingImpulseX());
        assertEquals(1, world.advance(0.02));
        assertEquals(0.08, world.getTime(), 1e-9, "and then no time waits");
    }

    @Test
    void theWaitingTimeSurvivesVariableStepsThatDoNotRun() {
        unit.applyForce(600, 0);
        world.advance(0.01);
        world.setTimestep(Timestep.variable(0.04));
        world.step(0.5);
        world.setTimestep(Timestep.variable(0.02));
        assertEquals(6, unit.getPendingImpulseX());
        world.setTimestep(Timestep.fixed(60));
        assertEquals(0.6, world.getAlpha(), 1e-9);
        assertEquals(6, unit.getPendingImpulseX());
        assertEquals(1, world.advance(0.007));
        assertEquals(0.02, world.getAlpha(), 1e-8);
        assertEquals(6, unit.getVx() + unit.getPendingImpulseX(), 1e-12);
    }

    @Test
    void impulseOfLessThanANanosecondStaysPendingInVariableSteps() {
        world.setTimestep(Timestep.fixed(1_000_000));
        unit.applyForce(1e12, 0);
        assertEquals(0, world.advance(5e-10));
        double pending = unit.getPendingImpulseX();
        assertEquals(500, pending, 1);
        world.setTimestep(Timestep.variable(0.01));
        assertEquals(pending, unit.getPendingImpulseX());
        world.advance(1e-10);
        assertEquals(pending, unit.getPendingImpulseX() + unit.getVx(), 1e-9);
        world.advance(0.01);
        assertEquals(pending, unit.getVx(), 1e-9, "it acts in a later step");
        assertEquals(0, unit.getPendingImpulseX());
    }

    @Test
    void aChangeDoesNotChangeTimeTicksAndDroppedTime() {
        world.advance(0.777);
        double time = world.getTime(), dropped = world.getDroppedTime();
        assertTrue(dropped > 0);
        for (Timestep next : List.of(
                Timestep.fixed(7),
                Timestep.variable(0.3),
                Timestep.variable(1),
                Timestep.fixed(999),
                Timestep.fixed(60))) {
            world.setTimestep(next);
            assertEquals(next, world.getTimestep());
            assertEquals(time, world.getTime(), 1e-15);
            assertEquals(dropped, world.getDroppedTime(), 1e-15);
            assertEquals(15, world.getTick());
        }
    }

    @Test
    void anotherCatchUpLimitDoesNotChangeTheWaitingTime() {
        unit.applyForce(600, 6);
        world.advance(1 / 90.0);
        double alpha = world.getAlpha(), pending = unit.getPendingImpulseX();
        world.setTimestep(Timestep.fixed(60).withMaxSteps(3));
        assertEquals(alpha, world.getAlpha());
        assertEquals(pending, unit.getPendingImpulseX());
        long hash = world.stateHash();
        world.setTimestep(world.getTimestep());
        assertEquals(hash, world.stateHash());
    }

    /** 0.999999999 s at 1 step/s are 999,999.999 steps at a million: the longest time that waits. */
    @Test
    void theLongestWaitingTimeIsSavedAndRestored() {
        world.setTimestep(Timestep.fixed(1));
        unit.applyForce(600, 6);
        assertEquals(0, world.advance(0.999_999_999));
        world.setTimestep(Timestep.fixed(1_000_000).withMaxSteps(2_000_000));
        byte[] save = Saves.of(world);
        World loaded = Saves.restored(Snapshot.fromBytes(save));
        assertEquals(world.stateHash(), loaded.stateHash());
        assertEquals(ALMOST_ONE, loaded.getAlpha());
        for (World w : List.of(world, loaded)) {
            assertEquals(1_000_000, w.advance(1e-9), "one nanosecond completes the last step");
            assertEquals(0, w.getAlpha());
            assertEquals(1, w.getTime(), 1e-15);
            assertEquals(600 * 0.999_999_999, w.get(0).getVx(), 1e-6);
        }
        assertEquals(world.stateHash(), loaded.stateHash());
    }

    /** 1e-15 s less than a second, which a conversion to 1 step/s must not round up to a second. */
    @Test
    void roundingDoesNotRaiseTheWaitingTimeToASecond() {
        Timestep slow = Timestep.fixed(1), fast = Timestep.fixed(1_000_000);
        world.setTimestep(fast);
        assertEquals(0, world.advance(1.00999998999999E-7));
        world.setTimestep(slow);
        world.advance(0.999_999_899);
        world.setTimestep(fast);
        world.setTimestep(slow);
        assertBelowOne(world.getAlpha());
        World loaded = Saves.restored(Snapshot.fromBytes(Saves.of(world)));
        assertEquals(world.stateHash(), loaded.stateHash());
    }

    @Test
    void aSnapshotBetweenVariableStepsContainsTheWaitingTime() {
        unit.applyForce(600, 6);
        world.advance(0.01);
        world.setTimestep(Timestep.variable(0.04));
        World loaded = Saves.restored(Snapshot.fromBytes(Saves.of(world)));
        assertEquals(world.stateHash(), loaded.stateHash());
        for (World w : List.of(world, loaded)) {
            assertEquals(1, w.advance(0.02));
            assertEquals(0.03, w.getTime(), 1e-9);
            assertEquals(6, w.get(0).getVx(), 1e-12);
        }
        assertEquals(world.stateHash(), loaded.stateHash());
    }

    /**
     * 1/144 s is not a whole number of billionths of a step, and a billionth at one rate is not a whole number at
     * another.
     */
    @Test
    void aMillionChangesLoseNoTime() {
        Timestep[] rates = {Timestep.fixed(60), Timestep.fixed(144), Timestep.fixed(1), Timestep.fixed(997)};
        int frames = 1_000_000;
        for (int i = 0; i < frames; i++) {
            world.setTimestep(rates[i & 3].withMaxSteps(2000));
            world.advance(1 / 144.0);
        }
        assertEquals(0, world.getDroppedTime());
        assertEquals(frames * (1 / 144.0), world.getTime() + waiting(world), 2e-9);
    }

    /**
     * As in the guide: at 10 m/s and 0.01 s after a step, the unit is drawn 0.4 of 1/60 s back, and then 0.8 of 1/60 s.
     */
    @Test
    void atAChangeUnitsMayBeDrawnBackByPartOfAStep() {
        unit.setVelocity(10, 0);
        world.advance(1 / 60.0);
        world.advance(0.01);
        double drawn = unit.getInterpolatedX(), x = unit.getX();
        assertEquals(x - 10 * (1 / 60.0 - 0.01), drawn, 1e-9);
        world.setTimestep(Timestep.fixed(20));
        assertEquals(x, unit.getX());
        assertEquals(x - 10 / 60.0 * 0.8, unit.getInterpolatedX(), 1e-9);
        assertEquals(-0.0667, unit.getInterpolatedX() - drawn, 1e-4);
    }
}
