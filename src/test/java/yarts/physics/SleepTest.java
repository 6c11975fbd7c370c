package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A block in which nothing moves sleeps, and then a step of it costs nothing: it is not even looked at. */
class SleepTest {
    private final World world = new World(Integrator.EULER, Timestep.fixed(60));

    private boolean asleep(int block) {
        return world.state.table.block(block).asleep;
    }

    private void assertAsleep(boolean first, boolean second) {
        world.step();
        assertEquals(first, asleep(0), "the first block");
        assertEquals(second, asleep(1), "the second block");
    }

    @ParameterizedTest
    @EnumSource
    void aBlockSleepsUntilItsFirstMoverWakesAndNoOtherDoes(Integrator integrator) {
        world.setIntegrator(integrator);
        for (int i = 0; i < Columns.BLOCK + 40; i++) world.add(new Unit(1));
        assertAsleep(true, true);
        for (int i : new int[] {0, 7, Columns.BLOCK - 1}) {
            world.get(i).setVelocity(0, 1);
            assertFalse(asleep(0));
            assertAsleep(false, true);
            assertAsleep(false, true);
            assertEquals(2 / 60.0, world.get(i).getY(), 1e-15);
            world.get(i).setFrozen(true);
            assertAsleep(true, true);
            world.get(i).setFrozen(false);
            assertAsleep(false, true);
            world.get(i).setVelocity(0, 0).setPosition(0, 0);
            assertAsleep(true, true);
        }
        for (int i : new int[] {Columns.BLOCK, Columns.BLOCK + 39}) {
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
        assertAsleep(false, true);
        assertTrue(world.get(3).getX() > 0);
    }
}
