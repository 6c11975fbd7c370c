package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Loops also process rows that are not in use: these are at rest with mass 1, so that they take no additional time. */
class RowsNotInUseTest {
    private final SplittableRandom random = new SplittableRandom(1);

    private void add(World world, int units) {
        for (int i = 0; i < units; i++) {
            Unit unit =
                    world.add(new Unit(random.nextDouble(1, 9))).setFriction(2).setMaxSpeed(7);
            unit.setPosition(3, 4).setVelocity(5, 6).setFrozen(random.nextInt(9) == 0);
            if (random.nextInt(9) == 0) unit.setMotor(random.nextDouble(), -2, 3);
        }
    }

    private void play(World world) {
        for (Unit unit : world) unit.applyForce(random.nextDouble(), 1);
        world.addAfterStep((w, dt) -> w.get(w.size() - 1).applyForce(2, 1));
        world.advance(0.04);
        for (Unit unit : world) unit.applyForce(1, random.nextDouble());
        assertAtRest(world);
    }

    private static void assertAtRest(World world) {
        Table t = world.state.table;
        for (int i = t.size; i < t.id.length; i++) {
            for (double[] column : t.columns()) assertEquals(column == t.mass ? 1 : 0, column[i]);
            for (double[] column : List.of(t.frameX, t.frameY)) assertEquals(0, column[i]);
            for (double[] column : List.of(t.decay, t.gain, t.lag)) assertTrue(column[i] >= 0 && column[i] <= 1e300);
            assertTrue(t.cap[i] > 0, "otherwise the cap would divide by 0");
            assertEquals(0, t.id[i]);
        }
    }

    @ParameterizedTest
    @EnumSource
    void rowsThatAreNotInUseAreAtRest(Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(60));
        add(world, 1300);
        play(world);
        Snapshot many = world.save();
        world.removeIf(unit -> random.nextInt(3) == 0);
        play(world);
        while (world.size() > 100) world.remove(world.get(random.nextInt(world.size())));
        play(world);
        Snapshot few = world.save();
        world.restore(many);
        play(world);
        world.restore(few);
        play(world);
        world.clear();
        add(world, 520);
        play(world);
    }
}
