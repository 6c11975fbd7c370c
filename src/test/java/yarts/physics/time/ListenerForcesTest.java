package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.StepListener;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/** A force applied in a step listener acts for exactly one step, whether step() or advance() runs it. */
class ListenerForcesTest {
    private static final class Stop extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    private final World world = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(9));
    private final Unit unit = world.add(new Unit(1)), other = world.add(new Unit(1));

    /** Runs a step, after which a listener applies a force to the unit; 10 N add 1 m/s in a step of 0.1 s. */
    private void applyAfterAStep(double fx, double fy) {
        StepListener push = (w, dt) -> unit.applyForce(fx, fy);
        world.addAfterStep(push);
        world.step();
        assertTrue(world.removeStepListener(push));
        assertEquals(0, unit.getSpeed(), "the force has not acted yet");
    }

    private static void assertNothingWaits(Unit unit) {
        assertEquals(
                List.of(0.0, 0.0, 0.0, 0.0),
                List.of(
                        unit.getFx() + 0.0,
                        unit.getFy() + 0.0,
                        unit.getPendingImpulseX() + 0.0,
                        unit.getPendingImpulseY() + 0.0));
    }

    private interface Law {
        double force(Unit unit);
    }

    /** Positions and velocities after each step of 1/60 s, with a force applied after every step. */
    private static List<Double> path(int framesPerSecond, int seconds, double friction, double constant, Law law) {
        World world = new World(Integrator.EXACT, Timestep.fixed(60).withMaxSteps(60));
        Unit unit = world.add(new Unit(1).setFriction(friction));
        List<Double> path = new ArrayList<>();
        if (constant != 0) world.addBeforeStep((w, dt) -> unit.applyForce(constant, 0));
        world.addAfterStep((w, dt) -> {
            path.addAll(List.of(unit.getX(), unit.getVx(), unit.getFx()));
            unit.applyForce(law.force(unit), 0);
        });
        if (framesPerSecond == 0) for (int i = 0; i < seconds * 60; i++) world.step();
        else for (int i = 0; i < seconds * framesPerSecond; i++) world.advance(1.0 / framesPerSecond);
        assertEquals(seconds * 60L, world.getTick());
        path.addAll(List.of(unit.getX(), unit.getVx(), unit.getFx()));
        return path;
    }

    /** The first of 600 steps has no force yet: 599 · 6 N / 60 s⁻¹ / 1 kg. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 7, 15, 24, 30, 50, 60, 75, 144, 240, 1000})
    void sixNewtonsAfterEveryStepGive59Point9MetersPerSecondAtEveryFrameRate(int framesPerSecond) {
        List<Double> path = path(framesPerSecond, 10, 0, 0, unit -> 6);
        assertEquals(59.9, path.get(path.size() - 2), 1e-11);
        assertEquals(path(0, 10, 0, 0, unit -> 6), path, "the bits of step()");
    }

    /** 50 N against a spring of 100 N/m with its end at 1 m: at rest at 1.5 m. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 7, 15, 30, 60, 75, 144, 240, 1000})
    void aSpringAppliedAfterEveryStepRestsAtTheSamePlaceAtEveryFrameRate(int framesPerSecond) {
        Law spring = unit -> 100 * (1 - unit.getX());
        List<Double> path = path(framesPerSecond, 20, 10, 50, spring);
        assertEquals(1.5, path.get(path.size() - 3), 1e-12);
        assertEquals(path(0, 20, 10, 50, spring), path, "the bits of step()");
    }

    @Test
    void aForceAppliedAfterAStepActsForOneStepOfTheNextCall() {
        record Call(Consumer<World> run, double firstStep) {}
        for (Call call : List.of(
                new Call(World::step, 0.1),
                new Call(w -> w.step(0.5), 0.5),
                new Call(w -> w.advance(0.1), 0.1),
                new Call(w -> w.advance(0.15), 0.1),
                new Call(w -> w.advance(0.3), 0.1),
                new Call(w -> w.advance(5), 0.1))) {
            applyAfterAStep(10, -20);
            call.run.accept(world);
            assertEquals(10 * call.firstStep, unit.getVx(), 1e-14);
            assertEquals(-20 * call.firstStep, unit.getVy(), 1e-14);
            assertNothingWaits(unit);
            world.step();
            assertEquals(10 * call.firstStep, unit.getVx(), 1e-14, "the step after it has no force");
            unit.setVelocity(0, 0);
        }
    }

    @Test
    void aForceAppliedAfterAStepActsForOneOfTheStepsOfAVariableFrame() {
        world.setTimestep(Timestep.variable(0.25));
        for (double[] row : new double[][] {{0.2, 0.2}, {0.5, 0.25}, {0.01, 0.01}, {10, 0.25}}) {
            applyAfterAStep(10, 0);
            world.advance(row[0]);
            assertEquals(10 * row[1], unit.getVx(), 1e-14);
            assertNothingWaits(unit);
            unit.setVelocity(0, 0);
        }
    }

    @Test
    void aForceAppliedBeforeAStepActsOnlyForThatStep() {
        world.addBeforeStep((w, dt) -> unit.applyForce(w.getTick() == 1 ? 10 : 0, 0));
        world.advance(0.35);
        assertEquals(1, unit.getVx(), 1e-15);
        assertNothingWaits(unit);
    }

    @Test
    void inAFrameWithoutAStepTheForceContinuesToWait() {
        applyAfterAStep(10, 20);
        for (int i = 0; i < 4; i++) {
            assertEquals(0, world.advance(0.02));
            assertEquals(10, unit.getFx());
            assertEquals(20, unit.getFy());
            assertEquals(0, unit.getPendingImpulseX());
            assertEquals(0, unit.getPendingImpulseY());
        }
        assertEquals(1, world.advance(0.02));
        assertEquals(1, unit.getVx(), 1e-15);
        assertEquals(2, unit.getVy(), 1e-15);
        assertNothingWaits(unit);
    }

    /** 10 N for a step of 0.1 s, and 6 N for a frame of 0.25 s. */
    @Test
    void forcesOfAStepAndOfAFrameAddUpAndActForTheirOwnTimes() {
        applyAfterAStep(10, 0);
        unit.applyForce(6, 0);
        assertEquals(16, unit.getFx(), "both have not acted yet");
        assertEquals(2, world.advance(0.25));
        assertEquals(10 * 0.1 + 6 * 0.2, unit.getVx(), 1e-14);
        assertEquals(6 * 0.05, unit.getPendingImpulseX(), 1e-14);
        assertEquals(0, unit.getFx());
        world.advance(0.05);
        assertEquals(10 * 0.1 + 6 * 0.25, unit.getVx(), 1e-14);
    }

    @Test
    void allForcesActForTheTimeOfASingleStep() {
        applyAfterAStep(10, 0);
        unit.applyForce(6, 0);
        world.step(0.5);
        assertEquals(8, unit.getVx());
        assertNothingWaits(unit);
    }

    /** The sum of both is 0, but they act for different times. */
    @Test
    void aWaitingForceAndAFramesForceDoNotCancel() {
        applyAfterAStep(10, 0);
        unit.applyForce(-10, 0);
        assertEquals(0, unit.getFx());
        assertEquals(0, world.advance(0.05));
        assertEquals(10, unit.getFx());
        assertEquals(-0.5, unit.getPendingImpulseX(), 1e-15);
        assertEquals(1, world.advance(0.05));
        assertEquals(1 - 0.5, unit.getVx(), 1e-14);
    }

    @Test
    void allListenersSeeTheForcesOfTheNextStep() {
        List<Double> seen = new ArrayList<>();
        world.addBeforeStep((w, dt) -> seen.add(unit.getFx()));
        world.addBeforeStep((w, dt) -> unit.applyForce(1, 0));
        world.addBeforeStep((w, dt) -> seen.add(unit.getFx()));
        world.addAfterStep((w, dt) -> seen.add(unit.getFx()));
        world.addAfterStep((w, dt) -> unit.applyForce(2, 0));
        world.addAfterStep((w, dt) -> seen.add(unit.getFx()));
        world.step();
        world.advance(0.2);
        assertEquals(List.of(0.0, 1.0, 0.0, 2.0, 2.0, 3.0, 0.0, 2.0, 2.0, 3.0, 0.0, 2.0), seen);
    }

    @Test
    void forcesAppliedToAllUnitsAfterAStepWaitAsThoseAppliedToEach() {
        StepListener push = (w, dt) -> w.applyForces(new double[] {0, 10, -20, 30, 0}, 1);
        world.addAfterStep(push);
        world.advance(0.15);
        world.removeStepListener(push);
        assertEquals(0, world.advance(0.04));
        assertEquals(List.of(10.0, -20.0), List.of(unit.getFx(), unit.getFy()));
        assertEquals(List.of(30.0, 0.0), List.of(other.getFx(), other.getFy()));
        world.advance(0.02);
        assertEquals(1, unit.getVx(), 1e-15);
        assertEquals(-2, unit.getVy(), 1e-15);
        assertEquals(3, other.getVx(), 1e-15);
    }

    @Test
    void aChangeOfTimestepOrIntegratorKeepsTheWaitingForce() {
        for (Timestep next : List.of(Timestep.fixed(4), Timestep.fixed(100), Timestep.variable(0.25))) {
            world.setTimestep(Timestep.fixed(10));
            world.setIntegrator(Integrator.EULER);
            unit.setVelocity(0, 0);
            applyAfterAStep(10, 0);
            world.setTimestep(next);
            world.setIntegrator(Integrator.EXACT);
            assertEquals(10, unit.getFx());
            world.step();
            assertEquals(10 * next.getMaxStep(), unit.getVx(), 1e-14);
        }
    }

    @ParameterizedTest
    @CsvSource({"10, 0", "0, 10", "-10, 10"})
    void aWaitingForceIsPartOfTheHashAndOfTheSnapshot(double fx, double fy) {
        applyAfterAStep(fx, fy);
        long waiting = world.stateHash();
        Snapshot saved = world.save();
        unit.clearForces();
        assertNotEquals(waiting, world.stateHash());
        assertNotEquals("", saved.difference(world.save()));
        unit.applyForce(fx, fy);
        assertEquals(List.of(fx, fy), List.of(unit.getFx() + 0.0, unit.getFy() + 0.0));
        assertNotEquals(waiting, world.stateHash(), "a force for a frame differs from a force for a step");
        assertNotEquals("", saved.difference(world.save()));
        world.restore(saved);
        assertEquals(waiting, world.stateHash());
        assertEquals("", saved.difference(world.save()));
    }

    @Test
    void aWorldRestoredWithWaitingForcesContinuesAsTheSavedOne() {
        while (world.size() < 1100) world.add(new Unit(world.size()).setFriction(1));
        StepListener push = (w, dt) -> {
            for (int i = 0; i < w.size(); i += 7) w.get(i).applyForce(i - 500, 1000 - i);
        };
        world.addAfterStep(push);
        world.advance(0.27);
        world.removeStepListener(push);
        world.advance(0.01);
        for (int i = 0; i < world.size(); i += 5) world.get(i).applyForce(i, -i);
        Snapshot saved = world.save();
        World another = new World(), loaded = new World();
        another.restore(saved);
        loaded.restore(Snapshot.fromBytes(saved.toBytes()));
        List<List<Long>> expected = play(world);
        assertEquals(expected, play(another));
        assertEquals(expected, play(loaded));
        world.restore(saved);
        assertEquals(expected, play(world));
    }

    /** Plays some frames, the first without a step; returns all values of the world before and after each. */
    private static List<List<Long>> play(World world) {
        List<List<Long>> frames = new ArrayList<>(List.of(List.of(world.stateHash()), Churn.bits(world)));
        for (double elapsed : new double[] {0.001, 0.1, 0.25, 0.02, 0.3}) {
            world.advance(elapsed);
            frames.add(List.of(world.stateHash()));
            frames.add(Churn.bits(world));
        }
        return frames;
    }

    @Test
    void everyCallThatClearsForcesClearsWaitingForces() {
        World away = new World();
        Snapshot empty = away.save();
        List<Consumer<Unit>> ways = List.of(
                Unit::clearForces,
                u -> u.setFrozen(true),
                u -> u.setFrozen(true).setFrozen(false),
                u -> {
                    world.remove(u);
                    u.applyForce(50, 60);
                    world.add(u);
                },
                u -> {
                    world.remove(u);
                    away.add(u);
                    away.remove(u);
                    world.add(u);
                },
                u -> {
                    world.clear();
                    world.add(u);
                },
                u -> {
                    world.removeIf(any -> any == u);
                    world.add(u);
                },
                u -> {
                    world.restore(empty);
                    world.add(u);
                },
                world::remove,
                u -> world.clear(),
                u -> world.restore(empty));
        for (int i = 0; i < ways.size(); i++) {
            applyAfterAStep(10, 20);
            unit.applyForce(30, 40);
            ways.get(i).accept(unit);
            assertNothingWaits(unit);
            if (unit.getWorld() == null) unit.integrate(1);
            else world.step(1);
            world.advance(0.3);
            assertEquals(0, unit.getSpeed(), "way " + i);
            unit.setFrozen(false);
            if (unit.getWorld() == null) world.add(unit);
            world.setTimestep(Timestep.fixed(10).withMaxSteps(9));
            world.setIntegrator(Integrator.EULER);
        }
    }

    @Test
    void aForceOnAFrozenUnitIsDiscardedWhenItIsReleased() {
        unit.setFrozen(true);
        applyAfterAStep(10, 20);
        world.step();
        applyAfterAStep(10, 20);
        assertEquals(0, unit.getSpeed());
        unit.setFrozen(false);
        assertNothingWaits(unit);
        world.advance(0.3);
        assertEquals(0, unit.getSpeed());
    }

    @Test
    void aListenerThatFreezesAUnitClearsTheForcesOfTheStep() {
        world.addAfterStep((w, dt) -> {
            unit.applyForce(10, 20);
            other.applyForce(10, 20);
            unit.setFrozen(true);
        });
        world.step();
        assertNothingWaits(unit);
        assertEquals(10, other.getFx());
        unit.setFrozen(false);
        assertNothingWaits(unit);
    }

    @Test
    void anAdvanceByZeroSecondsDiscardsOnlyTheForcesOfTheFrame() {
        for (Timestep timestep : List.of(Timestep.fixed(10), Timestep.variable(0.1))) {
            world.setTimestep(timestep);
            unit.setVelocity(0, 0);
            applyAfterAStep(10, 20);
            unit.applyForce(30, 40);
            assertEquals(0, world.advance(0));
            assertEquals(10, unit.getFx());
            assertEquals(20, unit.getFy());
            world.advance(0.1);
            assertEquals(1, unit.getVx(), 1e-15);
            assertEquals(2, unit.getVy(), 1e-15);
        }
    }

    @Test
    void aStepOfZeroSecondsDiscardsAllForcesExceptThoseAppliedAfterIt() {
        applyAfterAStep(10, 20);
        unit.applyForce(30, 40);
        world.addAfterStep((w, dt) -> other.applyForce(50 * dt + 5, 0));
        world.step(0);
        assertNothingWaits(unit);
        assertEquals(5, other.getFx());
        world.step(1);
        assertEquals(0, unit.getSpeed());
        assertEquals(5, other.getVx());
    }

    @Test
    void aListenerThatCancelsAStepDiscardsAllForcesOfTheStep() {
        for (boolean advance : new boolean[] {false, true}) {
            World plain = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(9));
            plain.restore(world.save());
            plain.step();
            applyAfterAStep(10, 20);
            unit.applyForce(30, 40);
            StepListener push = (w, dt) -> unit.applyForce(50, 60),
                    stop =
                            (w, dt) -> {
                                throw new Stop();
                            };
            world.addBeforeStep(push);
            world.addBeforeStep(stop);
            assertThrows(Stop.class, () -> {
                if (advance) world.advance(0.2);
                else world.step(0.1);
            });
            assertNothingWaits(unit);
            if (!advance) assertEquals(plain.stateHash(), world.stateHash(), "as without the call");
            world.removeStepListener(push);
            world.removeStepListener(stop);
            world.advance(0.3);
            assertEquals(0, unit.getSpeed());
        }
    }

    /** The second step of three, and the frame has a force of its own. */
    @Test
    void aListenerThatCancelsALaterStepOfAFrameLeavesOnlyThePendingImpulse() {
        applyAfterAStep(10, 0);
        unit.applyForce(6, 0);
        world.addBeforeStep((w, dt) -> {
            if (w.getTick() == 2) throw new Stop();
        });
        world.addAfterStep((w, dt) -> unit.applyForce(20, 0));
        assertThrows(Stop.class, () -> world.advance(0.35));
        assertEquals(10 * 0.1 + 6 * 0.1, unit.getVx(), 1e-14);
        assertEquals(0, unit.getFx());
        assertEquals(6 * 0.05, unit.getPendingImpulseX(), 1e-14);
    }

    /** The forces that it and other listeners applied before the exception, but not those of the frame. */
    @Test
    void forcesAppliedAfterAStepWaitEvenIfAListenerThrows() {
        for (boolean advance : new boolean[] {false, true}) {
            unit.setVelocity(0, 0);
            StepListener push = (w, dt) -> unit.applyForce(7, 0),
                    stop =
                            (w, dt) -> {
                                unit.applyForce(0, 8);
                                throw new Stop();
                            };
            world.addAfterStep(push);
            world.addAfterStep(stop);
            unit.applyForce(10, 0);
            assertThrows(Stop.class, () -> {
                if (advance) world.advance(0.3);
                else world.step();
            });
            world.removeStepListener(push);
            world.removeStepListener(stop);
            assertEquals(1, unit.getVx(), 1e-14);
            assertEquals(7, unit.getFx());
            assertEquals(8, unit.getFy());
            world.advance(0.3);
            assertEquals(1.7, unit.getVx(), 1e-14);
            assertEquals(0.8, unit.getVy(), 1e-14);
        }
    }

    @Test
    void integrateOfAMemberUsesAllItsForces() {
        applyAfterAStep(10, 20);
        unit.applyForce(1, 2);
        unit.integrate(0.5);
        assertEquals(5.5, unit.getVx());
        assertEquals(11, unit.getVy());
        assertEquals(0, unit.getFx());
        assertEquals(0, unit.getFy());
        world.advance(0.3);
        assertEquals(5.5, unit.getVx());
        assertEquals(11, unit.getVy());
    }

    /** It is distributed over the steps of the next frame of that world. */
    @Test
    void aForceOnAUnitOfAnotherWorldCountsAsAppliedBetweenFrames() {
        World there = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(9));
        Unit far = there.add(new Unit(1));
        for (boolean before : new boolean[] {false, true}) {
            StepListener push = (w, dt) -> far.applyForce(10, 0);
            if (before) world.addBeforeStep(push);
            else world.addAfterStep(push);
            world.step();
            world.removeStepListener(push);
            assertEquals(10, far.getFx());
            assertEquals(0, there.advance(0.05));
            assertEquals(0.5, far.getPendingImpulseX(), 1e-15);
            assertEquals(0, far.getFx());
            assertEquals(1, there.advance(0.05));
            assertEquals(0.5, far.getVx(), 1e-14);
            far.setVelocity(0, 0);
        }
    }

    /** A listener steps another world, whose own listener pushes a unit of the first. */
    @Test
    void aForceFromAWorldThatAListenerStepsActsForTheStepOfThatListener() {
        World inner = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(9));
        inner.add(new Unit(1));
        inner.addAfterStep((w, dt) -> unit.applyForce(10, 0));
        StepListener step = (w, dt) -> inner.step();
        world.addBeforeStep(step);
        world.step();
        assertEquals(1, unit.getVx(), 1e-15, "applied before the step");
        assertNothingWaits(unit);
        world.removeStepListener(step);
        world.addAfterStep(step);
        world.step();
        assertEquals(1, unit.getVx(), 1e-15);
        assertEquals(10, unit.getFx(), "applied after the step");
        world.removeStepListener(step);
        world.advance(0.3);
        assertEquals(2, unit.getVx(), 1e-15);
    }

    @ParameterizedTest
    @CsvSource({"1, 10, 0", "1, 0, 10", "600, 10, 0", "600, 0, 10", "1100, 10, 0", "1100, 0, 10"})
    void theLastUnitKeepsItsWaitingForceWhenItTakesAnotherRow(int units, double fx, double fy) {
        while (world.size() < units + 2) world.add(new Unit(1));
        Unit last = world.get(world.size() - 1);
        StepListener push = (w, dt) -> last.applyForce(fx, fy);
        world.addAfterStep(push);
        world.step();
        world.removeStepListener(push);
        long hash = world.stateHash();
        world.remove(unit);
        assertEquals(0, last.getIndex());
        assertNotEquals(hash, world.stateHash());
        assertEquals(0, world.advance(0.05));
        assertEquals(fx, last.getFx());
        assertEquals(fy, last.getFy());
        assertEquals(0, last.getPendingImpulseX());
        assertEquals(0, last.getPendingImpulseY());
        world.advance(0.05);
        assertEquals(fx / 10, last.getVx(), 1e-15);
        assertEquals(fy / 10, last.getVy(), 1e-15);
        for (Unit each : world) if (each != last) assertEquals(0, each.getSpeed());
    }

    /** Also in the listener itself; a unit that is added in the free row has no waiting force. */
    @Test
    void aUnitThatTakesTheRowOfAnotherKeepsItsOwnWaitingForce() {
        Unit late = new Unit(1);
        StepListener change = (w, dt) -> {
            unit.applyForce(10, 0);
            other.applyForce(0, 20);
            w.remove(unit);
            w.add(late);
        };
        world.addAfterStep(change);
        world.advance(0.1);
        world.removeStepListener(change);
        assertNothingWaits(unit);
        assertNothingWaits(late);
        assertEquals(20, other.getFy());
        world.advance(0.2);
        assertEquals(0, late.getSpeed());
        assertEquals(2, other.getVy(), 1e-15);
    }

    @Test
    void aWaitingForceMovesAUnitInASleepingTile() {
        while (world.size() < 1100) world.add(new Unit(1));
        for (int i = 0; i < 20; i++) world.step();
        for (Unit pushed : List.of(world.get(0), world.get(511), world.get(512), world.get(1099))) {
            StepListener push = (w, dt) -> pushed.applyForce(10, 0);
            world.addAfterStep(push);
            world.step();
            world.removeStepListener(push);
            assertEquals(0, pushed.getVx());
            assertEquals(0, world.advance(0.05));
            assertEquals(1, world.advance(0.05));
            assertEquals(1, pushed.getVx(), 1e-15);
            pushed.setVelocity(0, 0);
            for (int i = 0; i < 5; i++) world.step();
        }
        for (Unit each : world) assertEquals(0, each.getSpeed());
    }
}
