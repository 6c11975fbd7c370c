package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The speed of a unit at its cap is the top speed, permanently. {@link SpeedCapPropertyTest} has any direction and cap.
 */
class TopSpeedTest {
    @ParameterizedTest
    @EnumSource
    void aUnitThatIsPushedAtItsTopSpeedHasThatSpeed(Integrator integrator) {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 1000; i++) {
            double top = i == 0 ? 15 : random.nextDouble(1e-3, 1e3);
            Unit unit = new Unit(1).setMaxSpeed(top).setFriction(random.nextDouble());
            double fx = random.nextDouble(-1e6, 1e6), fy = random.nextDouble(-1e6, 1e6);
            for (int step = 0; step < 50; step++) {
                unit.applyForce(fx, fy);
                unit.integrate(1, integrator);
                assertEquals(top, unit.getSpeed());
                assertTrue(speed(unit.getVx(), unit.getVy()) <= top);
            }
        }
    }

    /** Also for forces whose velocity would have a square of 0, and after a change of dt. */
    @ParameterizedTest
    @EnumSource
    void noForceMovesAUnitWithATopSpeedOfZero(Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(2));
        Unit free = world.add(new Unit(1)), pinned = world.add(new Unit(1));
        world.step(0.5);
        pinned.setMaxSpeed(0);
        for (int exponent = -1074; exponent <= 165; exponent++) {
            double force = Math.scalb(1.5, exponent);
            free.applyForce(force, force);
            pinned.applyForce(force, -force);
            world.step(exponent % 3 == 0 ? 1 : 0.5);
            for (double v : new double[] {pinned.getVx(), pinned.getVy(), pinned.getX(), pinned.getY()}) {
                assertEquals(0, v, "force " + force);
            }
        }
        assertTrue(free.getX() > 1);
    }

    /** No setter, impulse of 0 or step changes a velocity at the top speed, to the bit. */
    @Test
    void noVelocityIsReducedTwice() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 100_000; i++) {
            double top = random.nextDouble(1e-3, 1e3);
            Unit unit = new Unit(1)
                    .setMaxSpeed(top)
                    .setVelocity(random.nextDouble(-1e4, 1e4), random.nextDouble(-1e4, 1e4));
            double vx = unit.getVx(), vy = unit.getVy();
            unit.setVelocity(vx, vy);
            unit.setMaxSpeed(top);
            unit.applyImpulse(0, 0);
            unit.integrate(1);
            assertEquals(vx, unit.getVx());
            assertEquals(vy, unit.getVy());
        }
    }

    /**
     * The reason why getSpeed returns the top speed for nearby speeds: in this direction, no pair of doubles within two
     * ulp of the exact velocity has a speed that rounds to the top speed. This is so for one direction in forty.
     */
    @Test
    void noVelocityNearThisDirectionHasExactlyTheTopSpeed() {
        double top = 1.1932979995092468, x = 1.1772908351197984, y = 0.19479837056735777;
        for (int i = -2; i <= 2; i++) {
            for (int j = -2; j <= 2; j++) assertNotEquals(top, speed(x + i * Math.ulp(x), y + j * Math.ulp(y)));
        }
        Unit unit = new Unit(1).setMaxSpeed(top).setVelocity(10 * x, 10 * y);
        assertEquals(top, unit.getSpeed());
        assertEquals(top, speed(unit.getVx(), unit.getVy()), 1e-14);
    }

    /** getSpeed returns a speed that is lower by more than rounding unchanged. */
    @Test
    void aSlowerUnitIsNotAtItsTopSpeed() {
        Unit unit = new Unit(1).setMaxSpeed(15).setVelocity(15 * (1 - 1e-14), 0);
        assertEquals(15 * (1 - 1e-14), unit.getSpeed());
        double at = 1 - 0x1p-48; // above this, the difference may be rounding alone
        assertEquals(1, new Unit(1).setMaxSpeed(1).setVelocity(at, 0).getSpeed());
        assertEquals(
                Math.nextDown(at),
                new Unit(1).setMaxSpeed(1).setVelocity(Math.nextDown(at), 0).getSpeed());
        assertEquals(5, new Unit(1).setVelocity(3, 4).getSpeed());
        assertEquals(0, new Unit(1).setMaxSpeed(0).getSpeed());
        assertEquals(0, new Unit(1).setMaxSpeed(Double.MIN_VALUE).getSpeed());
    }

    private static double speed(double vx, double vy) {
        return Math.sqrt(vx * vx + vy * vy);
    }
}
