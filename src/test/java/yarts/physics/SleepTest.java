package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A tile in which nothing moves falls asleep within 16 steps. Then a step skips it. */
class SleepTest {
    private static final int SOON = 16;

    private final World world = new World(Integrator.EULER, Timestep.fixed(60));

    private boolean asleep(int tile) {
        return world.state.table.asleep[tile];
    }

    private void assertAsleep(boolean first, boolean second) {
        for (int i = 0; i < SOON; i++) world.step();
        assertEquals(first, asleep(0), "the first tile");
        assertEquals(second, asleep(1), "the second tile");
    }

    @ParameterizedTest
    @EnumSource
    void aTileSleepsUntilAChangeOfOneOfItsUnits(Integrator integrator) {
        world.setIntegrator(integrator);
        for (int i = 0; i < Table.TILE + 40; i++) world.add(new Unit(1));
        assertAsleep(true, true);
        for (int i : new int[] {0, 7, Table.TILE - 1}) {
            world.get(i).setVelocity(0, 1);
            assertFalse(asleep(0));
            assertAsleep(false, true);
            assertAsleep(false, true);
            assertEquals(2 * SOON / 60.0, world.get(i).getY(), 1e-14);
            world.get(i).setFrozen(true);
            assertAsleep(true, true);
            world.get(i).setFrozen(false);
            assertFalse(asleep(0));
            assertAsleep(false, true);
            world.get(i).setVelocity(0, 0).setPosition(0, 0);
            assertAsleep(true, true);
        }
        for (int i : new int[] {Table.TILE, Table.TILE + 39}) {
            world.get(i).applyForce(1, 0);
            assertAsleep(true, false);
            assertAsleep(true, false);
            world.get(i).setVelocity(0, 0);
            assertAsleep(true, true);
        }
        world.get(3).integrate(1, integrator);
        assertAsleep(true, true);
        world.get(3).applyForce(1, 1);
        world.get(3).integrate(1, integrator);
        world.get(3).integrate(1, integrator);
        assertAsleep(false, true);
        assertTrue(world.get(3).getX() > 0);
    }

    /** A unit at rest that has been moved must be interpolated for exactly one step. */
    @ParameterizedTest
    @EnumSource
    void aMoveAndANewRowWakeATileForOneStep(Integrator integrator) {
        world.setIntegrator(integrator);
        for (int i = 0; i < Table.TILE + 1; i++) world.add(new Unit(1));
        assertAsleep(true, true);
        world.get(5).moveTo(3, 0);
        assertEquals(0, world.get(5).getInterpolatedX(0));
        world.step();
        assertEquals(3, world.get(5).getInterpolatedX(0));
        assertAsleep(true, true);
        Unit last = world.get(Table.TILE).moveTo(7, 0);
        world.remove(world.get(0));
        assertEquals(0, last.getInterpolatedX(0), "in the row of the first, in a sleeping tile");
        for (int i = 0; i < 3 * SOON; i++) {
            world.step();
            assertEquals(7, last.getX());
            assertEquals(7, last.getInterpolatedX(0));
        }
    }

    /** Motors that brake: the units come to rest within seconds, and the world sleeps. */
    @ParameterizedTest
    @EnumSource
    void aParkedArmyWithBrakesSleeps(Integrator integrator) {
        world.setIntegrator(integrator);
        for (int i = 0; i < Table.TILE + 40; i++) {
            Unit unit = world.add(new Unit(1 + i % 7).setFriction((1 + i % 7) / 5.0))
                    .setVelocity(i % 11, -i % 13);
            unit.setMotor(0, 0, 5 * unit.getMass());
        }
        for (int i = 0; i < 60 * 4; i++) world.step();
        for (Unit unit : world) assertEquals(0, unit.getSpeed());
        assertAsleep(true, true);
        double x = world.get(7).getX();
        world.get(7).applyForce(0.9 * world.get(7).getMotorForce(), 0);
        world.step();
        assertFalse(asleep(0), "a force wakes the tile, although the brake holds");
        assertAsleep(true, true);
        assertEquals(x, world.get(7).getX());
    }

    /** Also if the motor is so weak that the velocity stays 0 in a step. */
    @ParameterizedTest
    @EnumSource
    void aTileWithAMotorThatDrivesDoesNotSleep(Integrator integrator) {
        world.setIntegrator(integrator);
        for (int i = 0; i < Table.TILE + 40; i++) world.add(new Unit(1)).setMotor(0, 0, 1);
        assertAsleep(true, true);
        for (double force : new double[] {1e-3, 1e-100, Double.MIN_VALUE}) {
            for (int i : new int[] {0, Table.TILE - 1}) {
                world.get(i).setMotor(0, -1, force);
                assertFalse(asleep(0));
                assertAsleep(false, true);
                assertAsleep(false, true);
                assertEquals(force == 1e-3, world.get(i).getY() < -1e-6);
                world.get(i).setVelocity(0, 0).setMotor(0, 0, force);
                assertFalse(asleep(0));
                assertAsleep(true, true);
                world.get(i).setPosition(0, 0).setMotor(1, 1, 0);
                assertAsleep(true, true);
            }
        }
        world.get(3).setMotor(5, 0, 60);
        world.step();
        assertEquals(1, world.get(3).getVx(), "at once, although the tile slept");
    }

    /** Frozen and pinned units do not move, so their motors do not wake the tile before their release. */
    @ParameterizedTest
    @EnumSource
    void theMotorOfAUnitThatCannotMoveDoesNotKeepItsTileAwake(Integrator integrator) {
        world.setIntegrator(integrator);
        for (int i = 0; i < Table.TILE + 40; i++) world.add(new Unit(1));
        Unit frozen = world.get(5).setVelocity(3, 0).setFrozen(true).setMotor(5, 0, 60);
        Unit pinned = world.get(Table.TILE).setMotor(5, 0, 60).setMaxSpeed(0);
        assertAsleep(true, true);
        frozen.setFrozen(false);
        pinned.setMaxSpeed(9);
        world.step();
        assertEquals(4, frozen.getVx());
        assertEquals(1, pinned.getVx());
        frozen.setFrozen(true);
        pinned.setMaxSpeed(0);
        assertAsleep(true, true);
        Unit last = world.get(world.size() - 1).setMotor(0, 5, 60);
        world.remove(frozen);
        assertFalse(asleep(0), "the last unit has taken its row");
        assertAsleep(false, true);
        assertEquals(5, last.getVy());
    }

    /** So a game that switches its motors off does not pay for them, with and without forces. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aTileIgnoresMotorsThatAreOff(boolean pushed) {
        for (int i = 0; i < Table.TILE + 40; i++) world.add(new Unit(1)).setVelocity(1, 0);
        Unit first = world.get(0), second = world.get(1);
        first.setMotor(1, 0, 1);
        second.setMotor(0, 1, 0);
        world.get(2).setMotor(0, 0, 1);
        for (int motors = 3; motors >= 0; motors--) {
            for (int i = 0; i < SOON; i++) {
                if (pushed) for (Unit unit : world) unit.applyForce(0, 1);
                world.step();
            }
            assertEquals(motors > 0, world.state.table.motored[0], motors + " motors");
            assertFalse(world.state.table.motored[1]);
            if (motors == 3) first.setMotor(0, 0, 0);
            if (motors == 2) world.remove(world.get(2));
            if (motors == 1) second.setMotor(0, 0, 0);
        }
    }

    /** A change of dt or integrator must also apply to sleeping tiles. */
    @ParameterizedTest
    @EnumSource
    void aTileThatSleptDuringAChangeOfTheIntegratorUsesTheNewOne(Integrator integrator) {
        Unit unit = world.add(new Unit(2).setFriction(3));
        unit.applyForce(1, 0);
        world.step();
        unit.setVelocity(0, 0);
        assertTrue(world.size() == 1);
        for (int i = 0; i < SOON; i++) world.step();
        assertTrue(asleep(0));
        world.setIntegrator(integrator);
        world.step(0.5);
        Unit alone = new Unit(2).setFriction(3).setPosition(unit.getX(), 0);
        for (Unit each : new Unit[] {unit, alone}) each.applyForce(5, 4);
        world.step(0.5);
        alone.integrate(0.5, integrator);
        assertEquals(alone.getVx(), unit.getVx());
        assertEquals(alone.getX(), unit.getX());
    }
}
