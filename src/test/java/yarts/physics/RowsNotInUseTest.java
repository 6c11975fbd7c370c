package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Loops run over rows that are not in use, too: those are at rest, and of mass 1, so that they cost no more than others. */
class RowsNotInUseTest {
    private final SplittableRandom random = new SplittableRandom(1);

    private void add(World world, int units) {
        for (int i = 0; i < units; i++) {
            Unit unit =
                    world.add(new Unit(random.nextDouble(1, 9))).setFriction(2).setMaxSpeed(7);
            unit.setPosition(3, 4).setVelocity(5, 6).setFrozen(random.nextInt(9) == 0);
        }
    }

    private void play(World world) {
        for (Unit unit : world) unit.applyForce(random.nextDouble(), 1);
        world.advance(0.04);
        for (Unit unit : world) unit.applyForce(1, random.nextDouble());
        assertAtRest(world);
    }

    private static void assertAtRest(World world) {
        Table table = world.state.table;
        for (int k = 0; k < table.blocks() || k * Columns.BLOCK < 1536; k++) {
            Columns c = table.block(k);
            for (int i = c.end; i < Math.min(c.start + Columns.BLOCK, c.capacity()); i++) {
                for (double[] column : List.of(c.x, c.y, c.vx, c.vy, c.fx, c.fy, c.frozen, c.frameX, c.frameY)) {
                    assertEquals(0, column[i]);
                }
                for (double[] column : List.of(c.pendingX, c.pendingY, c.previousX, c.previousY, c.friction)) {
                    assertEquals(0, column[i]);
                }
                assertEquals(1, c.mass[i]);
                for (double[] column : List.of(c.decay, c.gain, c.cap))
                    assertTrue(column[i] >= 0 && column[i] <= 1e300);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void areAtRest(Integrator integrator) {
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

    /** Making one takes no arrays of its own. */
    @Test
    void unitsOutsideAWorldShareTheirArrays() {
        Set<Columns> arrays = new HashSet<>();
        for (int i = 0; i < 4 * Columns.LANES; i++) arrays.add(new Unit(1).columns);
        assertTrue(arrays.size() <= 5, arrays.size() + " for " + 4 * Columns.LANES);
    }
}
