package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Unit;

/** A unit at its top speed says so, for ever. Any direction and top speed: {@link SpeedCapPropertyTest}. */
class TopSpeedTest {
    @ParameterizedTest
    @EnumSource
    void aUnitThatIsPushedOnAtItsTopSpeedHasIt(Integrator integrator) {
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

    /** What is at its top speed stays as it is, to the bit, whichever way it is looked at or set again. */
    @Test
    void nothingIsCutTwice() {
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
     * Why getSpeed says it, and not the components alone: here no pair of doubles within two ulp of where the direction
     * meets the top speed has just that speed, as it is rounded. It is so for one direction in forty.
     */
    @Test
    void noVelocityInThatDirectionHasThatSpeed() {
        double top = 1.1932979995092468, x = 1.1772908351197984, y = 0.19479837056735777;
        for (int i = -2; i <= 2; i++) {
            for (int j = -2; j <= 2; j++) assertNotEquals(top, speed(x + i * Math.ulp(x), y + j * Math.ulp(y)));
        }
        Unit unit = new Unit(1).setMaxSpeed(top).setVelocity(10 * x, 10 * y);
        assertEquals(top, unit.getSpeed());
        assertEquals(top, speed(unit.getVx(), unit.getVy()), 1e-14);
    }

    /** What is slower by more than rounding is told as it is. */
    @Test
    void aSlowerUnitIsNotAtItsTopSpeed() {
        Unit unit = new Unit(1).setMaxSpeed(15).setVelocity(15 * (1 - 1e-14), 0);
        assertEquals(15 * (1 - 1e-14), unit.getSpeed());
        double at = 1 - 0x1p-48; // from here on rounding may be all that is between
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
