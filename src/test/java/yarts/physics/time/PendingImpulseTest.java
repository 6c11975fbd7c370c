package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The impulse that waits for a step has getters. A unit that leaves the world loses it. */
class PendingImpulseTest {
    private final World world = new World(Integrator.EULER, Timestep.fixed(10));
    private final Unit unit = world.add(new Unit(1)), other = world.add(new Unit(1));

    private static void assertNothingWaits(Unit unit) {
        assertEquals(
                List.of(0.0, 0.0, 0.0, 0.0),
                List.of(unit.getFx(), unit.getFy(), unit.getPendingImpulseX(), unit.getPendingImpulseY()));
    }

    @Test
    void theGettersReturnTheImpulseOfTheNextStep() {
        unit.applyForce(100, -40);
        assertEquals(100, unit.getFx());
        assertEquals(0, world.advance(0.05));
        assertEquals(0, unit.getFx(), "it has acted, for 0.05 s");
        assertEquals(5, unit.getPendingImpulseX(), 1e-15);
        assertEquals(-2, unit.getPendingImpulseY(), 1e-15);
        double[] seen = {0, 0};
        world.addBeforeStep((w, dt) -> {
            seen[0] = unit.getFx();
            seen[1] = unit.getPendingImpulseX();
        });
        assertEquals(1, world.advance(0.05));
        assertEquals(50, seen[0], 1e-13, "5 N·s over a step of 0.1 s");
        assertEquals(0, seen[1]);
        assertEquals(5, unit.getVx(), 1e-14);
        assertNothingWaits(unit);
    }

    @Test
    void aForceIsPendingForTheRemainderOnly() {
        unit.applyForce(100, 0);
        assertEquals(1, world.advance(0.125));
        assertEquals(10, unit.getVx(), 1e-14);
        assertEquals(2.5, unit.getPendingImpulseX(), 1e-14);
        assertEquals(0, other.getPendingImpulseX());
    }

    /** A unit from an object pool: removed, stopped, added again. */
    @Test
    void aPooledUnitReturnsAtRest() {
        unit.applyForce(100, 100);
        world.advance(0.05);
        unit.applyForce(100, 100);
        world.remove(unit);
        assertNothingWaits(unit);
        unit.setVelocity(0, 0);
        world.add(unit);
        assertNothingWaits(unit);
        world.advance(0.1);
        assertEquals(0, unit.getSpeed());
    }

    @Test
    void aUnitThatLeavesInAnyWayLosesItsPendingImpulse() {
        List<Consumer<World>> ways = List.of(
                w -> w.remove(w.get(0)),
                w -> w.removeIf(any -> true),
                World::clear,
                w -> {
                    for (var units = w.iterator(); units.hasNext(); ) {
                        units.next();
                        units.remove();
                    }
                },
                w -> w.restore(new World().save()));
        for (Consumer<World> way : ways) {
            World w = new World(Integrator.EULER, Timestep.fixed(10));
            Unit leaver = w.add(new Unit(1).setVelocity(1, 2));
            leaver.applyForce(100, 100);
            w.advance(0.05);
            leaver.applyForce(100, 100);
            way.accept(w);
            assertEquals(0, w.size());
            assertNothingWaits(leaver);
            leaver.integrate(1);
            assertEquals(1, leaver.getVx());
            assertEquals(2, leaver.getVy());
        }
    }

    @Test
    void aUnitThatJoinsHasNoForce() {
        Unit late = new Unit(1);
        late.applyForce(7, 7);
        world.add(late);
        assertNothingWaits(late);
        world.step(1);
        assertEquals(0, late.getSpeed());
    }

    @Test
    void theLastUnitKeepsItsPendingImpulseWhenItTakesAnotherRow() {
        other.applyForce(100, 0);
        world.advance(0.05);
        other.applyForce(0, 100);
        world.remove(unit);
        assertEquals(5, other.getPendingImpulseX(), 1e-15);
        assertEquals(100, other.getFy());
        world.advance(0.05);
        assertEquals(5, other.getVx(), 1e-14);
        assertEquals(5, other.getVy(), 1e-14);
    }

    @Test
    void clearForcesDiscardsThePendingImpulse() {
        unit.applyForce(100, 0);
        world.advance(0.05);
        unit.clearForces();
        assertNothingWaits(unit);
        world.advance(0.05);
        assertEquals(0, unit.getVx());
    }

    /** The waiting time becomes a part of a step of another length, with the same force. */
    @Test
    void anotherRateKeepsTheWaitingTimeAndTheConstantForce() {
        for (int rate : new int[] {1, 10, 30, 100}) {
            World w = new World(Integrator.EULER, Timestep.fixed(10));
            Unit pushed = w.add(new Unit(1));
            pushed.applyForce(100, 0);
            w.advance(0.025);
            w.setTimestep(Timestep.fixed(rate));
            assertEquals(Timestep.fixed(rate).toString(), w.getTimestep().toString());
            assertEquals(2.5, pushed.getPendingImpulseX(), 1e-14);
            assertEquals(Math.min(0.025 * rate, Math.nextDown(1f)), w.getAlpha(), 1e-15);
            double[] seen = {0};
            w.addBeforeStep((x, dt) -> seen[0] = pushed.getFx());
            pushed.applyForce(100, 0);
            double step = 1.0 / rate;
            assertTrue(w.advance(Math.max(step - 0.025, step)) > 0);
            assertEquals(100, seen[0], 1e-12, "a constant force stays constant");
        }
    }

    @Test
    void variableStepsCoverTheWaitingTimeInTheNextAdvance() {
        unit.applyForce(100, 0);
        world.advance(0.05);
        world.setTimestep(Timestep.variable(1));
        assertEquals(0, world.getAlpha());
        assertEquals(5, unit.getPendingImpulseX(), 1e-15);
        assertEquals(1, world.advance(0.1));
        assertEquals(0.15, world.getTime(), 1e-15);
        assertEquals(0, world.getDroppedTime());
        assertEquals(5, unit.getVx(), 1e-14);
        assertEquals(0, unit.getPendingImpulseX());
        world.advance(0.1);
        assertEquals(0.25, world.getTime(), 1e-15, "it waits no longer");
    }

    private Unit pushedInAnotherTile(double fx, double fy) {
        while (world.size() <= Tiles.TILE) world.add(new Unit(1));
        world.advance(0.1); // so that nothing is pending before the test continues
        Unit last = world.get(Tiles.TILE);
        last.applyForce(fx, fy);
        return last;
    }

    /** For each component, also if no other unit of its new tile has a pending impulse. */
    @ParameterizedTest
    @CsvSource({"100, 0", "0, 100"})
    void theLastUnitKeepsItsPendingImpulseInAnotherTile(double fx, double fy) {
        Unit last = pushedInAnotherTile(fx, fy);
        world.advance(0.05);
        long hash = world.stateHash();
        world.remove(unit);
        assertNotEquals(hash, world.stateHash());
        assertEquals(fx / 20, last.getPendingImpulseX(), 1e-14);
        assertEquals(fy / 20, last.getPendingImpulseY(), 1e-14);
        world.advance(0.05);
        assertEquals(fx / 20, last.getVx(), 1e-14);
        assertEquals(fy / 20, last.getVy(), 1e-14);
    }

    /** The same for the force of a frame's steps and the force that waits for the next step. */
    @ParameterizedTest
    @CsvSource({"100, 0", "0, 100"})
    void theLastUnitKeepsTheForceOfTheFrameInAnotherTile(double fx, double fy) {
        Unit last = pushedInAnotherTile(fx, fy);
        world.addBeforeStep((w, dt) -> {
            if (w.getTick() == 2) w.remove(unit);
        });
        world.setTimestep(Timestep.fixed(10).withMaxSteps(3));
        assertEquals(3, world.advance(0.3));
        assertEquals(0.3 * fx, last.getVx(), 1e-12);
        assertEquals(0.3 * fy, last.getVy(), 1e-12);
    }

    @Test
    void everyChangePreservesTimeAndTicks() {
        world.advance(0.25);
        world.setTimestep(Timestep.fixed(4));
        assertEquals(0.2, world.getTime(), 1e-15);
        assertEquals(0.2, world.getAlpha(), 1e-15);
        world.advance(0.2);
        assertEquals(0.45, world.getTime(), 1e-15);
        assertEquals(3, world.getTick());
        world.setTimestep(Timestep.variable(0.5).withMaxSteps(1));
        world.advance(0.75);
        assertEquals(0.95, world.getTime(), 1e-15);
        assertEquals(0.25, world.getDroppedTime(), 1e-15);
        world.setTimestep(Timestep.fixed(10).withMaxSteps(1));
        world.advance(0.3);
        assertEquals(1.05, world.getTime(), 1e-15);
        assertEquals(0.45, world.getDroppedTime(), 1e-15);
        assertEquals(5, world.getTick());
        world.step();
        assertEquals(1.15, world.getTime(), 1e-15);
    }
}
