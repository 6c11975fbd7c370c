package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The last unit takes the row of a removed one, in a tile where no other unit has a force, a motor, a top speed of 0 or
 * is frozen. It moves as it would have without the removal.
 */
class MovedRowTest {
    private static Unit play(boolean removal, Consumer<Unit> order) {
        World world = new World(Integrator.EXACT, Timestep.fixed(50));
        for (int i = 0; i < Tiles.TILE; i++) world.add(new Unit(1));
        Unit last = world.add(new Unit(2)).setFriction(1);
        for (int i = 0; i < 40; i++) world.step(); // the first tile sleeps
        order.accept(last);
        if (removal) world.remove(world.get(7));
        assertEquals(removal ? 7 : Tiles.TILE, last.getIndex());
        world.step(0.01); // another dt, so that all coefficients are computed again
        for (int i = 0; i < 3; i++) world.advance(0.03);
        return last;
    }

    @Test
    void aUnitThatTakesAnotherRowMovesTheSame() {
        for (Consumer<Unit> order : List.<Consumer<Unit>>of(
                unit -> unit.applyForce(3, 0),
                unit -> unit.applyForce(0, 3),
                unit -> unit.applyImpulse(1, 2),
                unit -> unit.setMotor(4, 0, 5),
                unit -> unit.setMotor(0, 4, 5),
                unit -> unit.setVelocity(3, 1).setMotor(0, 0, 5),
                unit -> unit.setVelocity(3, 4).setFrozen(true),
                unit -> unit.setMaxSpeed(0).applyForce(3, 4),
                unit -> unit.setMaxSpeed(0).applyForce(1e-163, -1e-163),
                unit -> waitingForce(unit, 3, 0),
                unit -> waitingForce(unit, 0, 3),
                unit -> pendingForce(unit, 3, 0),
                unit -> pendingForce(unit, 0, 3))) {
            Unit stayed = play(false, order), moved = play(true, order);
            for (ToDoubleFunction<Unit> value : List.<ToDoubleFunction<Unit>>of(
                    Unit::getX, Unit::getY, Unit::getVx, Unit::getVy, Unit::getInterpolatedX, Unit::getInterpolatedY)) {
                assertEquals(value.applyAsDouble(stayed), value.applyAsDouble(moved));
            }
        }
    }

    /** From a listener after a step; it acts in the next step. */
    private static void waitingForce(Unit unit, double fx, double fy) {
        World world = unit.getWorld();
        world.addAfterStep((w, dt) -> {
            if (w.getTick() == 41) unit.applyForce(fx, fy);
        });
        world.step();
    }

    /** In a frame without a step. */
    private static void pendingForce(Unit unit, double fx, double fy) {
        unit.applyForce(fx, fy);
        unit.getWorld().advance(0.01);
    }
}
