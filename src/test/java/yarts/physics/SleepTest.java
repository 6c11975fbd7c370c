package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A tile in which nothing moves falls asleep within 16 steps. A step of it then costs nothing: it is not looked at. */
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
    void aTileSleepsUntilOneOfItsUnitsWakesItAndNoOther(Integrator integrator) {
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

    /** What has moved but is at rest must be drawn on its way for one step, and not for more. */
    @ParameterizedTest
    @EnumSource
    void aMoveAndAnArrivalWakeATileForOneStep(Integrator integrator) {
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

    /** A change of dt or integrator must reach tiles that sleep during it. */
    @ParameterizedTest
    @EnumSource
    void aTileThatSleptDuringAChangeOfTheStepUsesTheNewOne(Integrator integrator) {
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
