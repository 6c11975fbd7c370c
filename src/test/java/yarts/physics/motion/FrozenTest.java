package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.StepListener;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** Forces and impulses do not change a frozen unit, and have no effect after its release either. */
class FrozenTest {
    private final World world = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(3));
    private final Unit unit = world.add(new Unit(2).setPosition(1, 2).setVelocity(3, -4));
    private final Unit other = world.add(new Unit(2).setVelocity(3, -4));

    private static void assertStill(Unit unit) {
        assertEquals(1, unit.getX());
        assertEquals(2, unit.getY());
        assertEquals(3, unit.getVx());
        assertEquals(-4, unit.getVy());
    }

    private static void assertNoForces(Unit unit) {
        assertEquals(0, unit.getFx());
        assertEquals(0, unit.getFy());
        assertEquals(0, unit.getPendingImpulseX());
        assertEquals(0, unit.getPendingImpulseY());
    }

    @ParameterizedTest
    @EnumSource
    void aFrozenUnitKeepsItsStateInEveryKindOfStep(Integrator integrator) {
        for (Timestep timestep : new Timestep[] {Timestep.fixed(10), Timestep.variable(0.1)}) {
            world.setTimestep(timestep);
            world.setIntegrator(integrator);
            unit.setFriction(1).setMaxSpeed(5).setFrozen(true);
            assertTrue(unit.isFrozen());
            for (double dt : new double[] {0, 0.03, 0.1, 0.25, 1e9}) {
                unit.applyForce(5, 6);
                world.step(dt);
                assertStill(unit);
                unit.applyForce(5, 6);
                unit.applyImpulse(7, 8);
                world.advance(dt);
                assertStill(unit);
                unit.applyForce(5, 6);
                unit.integrate(dt, integrator);
                assertStill(unit);
                assertEquals(1, unit.getInterpolatedX());
                assertEquals(1, unit.getInterpolatedX(0));
                assertEquals(2, unit.getInterpolatedY(0.5));
            }
        }
        assertEquals(1, unit.getId());
        assertSame(unit, world.get(0));
        assertSame(world, unit.getWorld());
        assertNotEquals(0, other.getX());
    }

    /** To the bit as if the time had not passed. */
    @ParameterizedTest
    @EnumSource
    void aReleasedUnitContinuesWithItsVelocity(Integrator integrator) {
        world.setIntegrator(integrator);
        Unit alone = new Unit(2).setPosition(1, 2).setVelocity(3, -4).setFriction(0.7);
        unit.setFriction(0.7).setFrozen(true);
        for (int i = 0; i < 5; i++) {
            unit.applyForce(100, 100);
            world.step(0.1 * i);
        }
        unit.setFrozen(false);
        assertFalse(unit.isFrozen());
        for (int i = 0; i < 5; i++) {
            unit.applyForce(5, -6);
            alone.applyForce(5, -6);
            world.step(0.3);
            alone.integrate(0.3, integrator);
            assertEquals(alone.getX(), unit.getX());
            assertEquals(alone.getY(), unit.getY());
            assertEquals(alone.getVx(), unit.getVx());
            assertEquals(alone.getVy(), unit.getVy());
        }
    }

    @Test
    void freezingDiscardsAForceThatHasNotActed() {
        unit.applyForce(100, 100);
        world.advance(0.05);
        unit.applyForce(100, 100);
        unit.setFrozen(true);
        assertNoForces(unit);
        unit.setFrozen(false);
        world.advance(0.1);
        assertEquals(3, unit.getVx());
    }

    @Test
    void aForceOnAFrozenUnitDoesNotActAfterItsRelease() {
        unit.setFrozen(true);
        unit.applyForce(100, 100);
        world.advance(0.05); // no step
        unit.applyForce(100, 100);
        world.applyForces(new double[] {100, 100, 0, 0}, 0);
        unit.setFrozen(false);
        assertNoForces(unit);
        assertEquals(1, world.advance(0.1));
        assertEquals(3, unit.getVx());
        assertEquals(-4, unit.getVy());
    }

    @Test
    void aRepeatedFreezeOrReleaseChangesNothing() {
        unit.applyForce(10, 0);
        unit.setFrozen(false);
        assertEquals(10, unit.getFx());
        world.step(1);
        assertEquals(8, unit.getVx());
    }

    @Test
    void velocityAndPositionOfAFrozenUnitCanBeSet() {
        unit.setFrozen(true).setVelocity(30, 40).setMaxSpeed(5).setPosition(7, 8);
        world.step(1);
        assertEquals(7, unit.getX());
        assertEquals(5, unit.getSpeed());
        unit.setFrozen(false);
        world.step(1);
        assertEquals(10, unit.getX(), 1e-14);
        assertEquals(12, unit.getY(), 1e-14);
    }

    /** The unit moved before it was frozen: the interpolated position reaches its position, and then stays. */
    @Test
    void theInterpolatedPositionComesToRest() {
        world.advance(0.15);
        unit.setFrozen(true);
        assertEquals(1.15, unit.getInterpolatedX(), 1e-15);
        world.advance(0.1);
        assertEquals(1.3, unit.getInterpolatedX(), 1e-15);
        double[] xy = new double[4];
        world.copyPositions(xy, 0, 0);
        assertEquals(unit.getX(), xy[0]);
        assertEquals(unit.getY(), xy[1]);
    }

    /** Runs an order in a listener before the second step of a frame of three, or after the first. */
    private void between(boolean after, Runnable order) {
        StepListener listener = (w, dt) -> {
            if (w.getTick() == 1) order.run();
        };
        if (after) world.addAfterStep(listener);
        else world.addBeforeStep(listener);
        assertEquals(3, world.advance(0.3));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aUnitFrozenDuringAFrameMovesOnlyInTheStepsBefore(boolean after) {
        unit.applyForce(20, 0);
        other.applyForce(20, 0);
        between(after, () -> unit.setFrozen(true));
        assertEquals(1.3, unit.getX(), 1e-15);
        assertEquals(4, unit.getVx(), 1e-14);
        assertNoForces(unit);
        assertEquals(6, other.getVx(), 1e-14, "the force acts on the other unit in all steps of the frame");
        unit.setFrozen(false);
        world.advance(0.1);
        assertEquals(4, unit.getVx(), 1e-14);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aUnitReleasedDuringAFrameMovesInTheStepsAfterWithoutEarlierForces(boolean after) {
        unit.setFrozen(true);
        unit.applyForce(20, 0);
        other.applyForce(20, 0);
        between(after, () -> {
            unit.setFrozen(false);
            unit.applyForce(0, 20); // for the next step
        });
        assertEquals(1 + 2 * 0.3, unit.getX(), 1e-14);
        assertEquals(3, unit.getVx());
        assertEquals(-3, unit.getVy(), 1e-14);
        assertEquals(6, other.getVx(), 1e-14);
    }

    /** Compares with a world in which the frozen unit was not pushed. */
    @Test
    void aForceThatActedOnAFrozenUnitHasNoEffectAfterItsRelease() {
        unit.setFrozen(true);
        Snapshot before = world.save();
        for (Runnable time :
                new Runnable[] {() -> world.step(0.2), () -> world.advance(0.1), () -> world.advance(0.32)}) {
            world.restore(before);
            time.run();
            Snapshot calm = world.save();
            long hash = world.stateHash();
            world.restore(before);
            unit.applyForce(5, 6);
            unit.applyImpulse(7, 8);
            time.run();
            unit.setFrozen(false).setFrozen(true);
            assertEquals("", calm.difference(world.save()));
            assertEquals(hash, world.stateHash());
        }
    }

    @Test
    void aPendingForceOnAFrozenUnitHasNoEffectAfterItsRelease() {
        unit.setFrozen(true);
        Snapshot before = world.save();
        world.advance(0.05);
        Snapshot calm = world.save();
        long hash = world.stateHash();
        world.restore(before);
        unit.applyForce(5, 6);
        world.advance(0.05); // no step
        unit.setFrozen(false).setFrozen(true);
        assertEquals("", calm.difference(world.save()));
        assertEquals(hash, world.stateHash());
        assertNoForces(unit);
    }

    @Test
    void hashAndSnapshotContainTheFrozenState() {
        long hash = world.stateHash();
        Snapshot before = world.save();
        unit.setFrozen(true);
        assertNotEquals(hash, world.stateHash());
        assertEquals("unit 1 frozen: 0x0.0p0 (0.0) | 0x1.0p0 (1.0)\n", before.difference(world.save()));
        Snapshot frozen = Snapshot.fromBytes(world.save().toBytes());
        world.restore(before);
        assertFalse(unit.isFrozen());
        assertEquals(hash, world.stateHash());
        World copy = new World();
        copy.restore(frozen);
        assertTrue(copy.get(0).isFrozen());
        assertFalse(copy.get(1).isFrozen());
        copy.get(0).applyForce(1, 1);
        copy.step(1);
        assertStill(copy.get(0));
        copy.get(0).setFrozen(false);
        copy.step(1);
        assertEquals(4, copy.get(0).getX());
    }

    @Test
    void aUnitStaysFrozenWhenItLeavesAndJoinsAWorld() {
        unit.setFrozen(true);
        world.remove(unit);
        assertTrue(unit.isFrozen());
        unit.applyForce(1, 1);
        unit.integrate(1);
        assertStill(unit);
        new World().add(unit).getWorld().step(1);
        assertStill(unit);
        assertArrayEquals(new double[] {1, 2}, new double[] {unit.getInterpolatedX(0), unit.getInterpolatedY(0)});
        unit.setFrozen(false).integrate(1);
        assertEquals(4, unit.getX());
    }

    /** The last unit takes the row of a removed one, from another tile. */
    @ParameterizedTest
    @EnumSource
    void aUnitStaysFrozenWhenItsRowMovesToAnotherTile(Integrator integrator) {
        world.setIntegrator(integrator);
        while (world.size() < Tiles.TILE) world.add(new Unit(1).setVelocity(1, 1));
        Unit last = world.add(new Unit(2).setPosition(1, 2).setVelocity(3, -4)).setFrozen(true);
        world.step(1);
        world.remove(other);
        assertSame(last, world.get(1));
        unit.applyForce(2, 0);
        world.step(1);
        last.applyForce(1, 1);
        world.step(1);
        assertStill(last);
        assertEquals(4, unit.getVx(), "the other units of the tile move");
        last.setFrozen(false);
        world.step(1);
        assertEquals(4, last.getX());
    }

    /** Alone, and in a tile in which another unit moves or not. */
    @ParameterizedTest
    @EnumSource
    void aVelocityBelowRestDoesNotDecayWhileItsUnitIsFrozen(Integrator integrator) {
        for (boolean otherMoves : new boolean[] {true, false}) {
            World world = new World(integrator, Timestep.fixed(60));
            Unit slow = new Unit(1).setFriction(0.5).setVelocity(1.25 * Range.REST, 0);
            Unit alone = new Unit(1).setFriction(0.5).setVelocity(1.25 * Range.REST, 0);
            world.add(slow);
            world.add(new Unit(1)).setVelocity(otherMoves ? 1 : 0, 0);
            world.step(1);
            alone.integrate(1, integrator);
            assertTrue(slow.getVx() > 0 && slow.getVx() < Range.REST, () -> "not below rest, or 0 already: " + slow);
            double v = slow.setFrozen(true).getVx();
            alone.setFrozen(true);
            for (int i = 0; i < 3; i++) {
                world.step(1);
                alone.integrate(1, integrator);
            }
            assertEquals(v, alone.getVx(), 0, "alone");
            assertEquals(v, slow.getVx(), 0, "the other moves: " + otherMoves);
        }
    }
}
