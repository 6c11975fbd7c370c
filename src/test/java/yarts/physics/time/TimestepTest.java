package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import yarts.physics.Timestep;
import yarts.physics.World;

/** The values of a timestep can be read and compared. */
class TimestepTest {
    private static void assertIs(Timestep timestep, int stepsPerSecond, double maxStep, int maxSteps) {
        assertEquals(stepsPerSecond > 0, timestep.isFixed());
        assertEquals(stepsPerSecond, timestep.getStepsPerSecond());
        assertEquals(maxStep, timestep.getMaxStep());
        assertEquals(maxSteps, timestep.getMaxSteps());
    }

    @Test
    void theGettersReturnTheArgumentsOfTheFactory() {
        assertIs(Timestep.fixed(60), 60, 1 / 60.0, 15);
        assertIs(Timestep.fixed(1), 1, 1, 1);
        assertIs(Timestep.fixed(1_000_000), 1_000_000, 1e-6, 250_000);
        assertIs(Timestep.fixed(20).withMaxSteps(7), 20, 0.05, 7);
        assertIs(Timestep.variable(0.05), 0, 0.05, 5);
        assertIs(Timestep.variable(2), 0, 2, 1);
        assertIs(Timestep.variable(0.05).withMaxSteps(1), 0, 0.05, 1);
        assertIs(new World().getTimestep(), 60, 1 / 60.0, 15);
    }

    @Test
    void theDefaultLimitIsTheStepsOfAQuarterOfASecondRoundedUp() {
        int[] rates = {1, 2, 3, 4, 5, 7, 10, 20, 30, 50, 60, 144, 999_999},
                steps = {1, 1, 1, 1, 2, 2, 3, 5, 8, 13, 15, 36, 250_000};
        for (int i = 0; i < rates.length; i++) {
            assertEquals(steps[i], Timestep.fixed(rates[i]).getMaxSteps(), "rate " + rates[i]);
        }
        double[] maxSteps = {1e9, 2, 0.25, 0.2, 0.125, 0.1, 1 / 30.0, 1 / 60.0, 1e-6};
        int[] variable = {1, 1, 1, 2, 2, 3, 8, 15, 250_000};
        for (int i = 0; i < maxSteps.length; i++) {
            assertEquals(variable[i], Timestep.variable(maxSteps[i]).getMaxSteps(), "maxStep " + maxSteps[i]);
        }
    }

    @Test
    void equalValuesAreEqualTimesteps() {
        List<Timestep> all = List.of(
                Timestep.fixed(60),
                Timestep.fixed(61),
                Timestep.fixed(60).withMaxSteps(4),
                Timestep.fixed(1),
                Timestep.variable(1),
                Timestep.variable(1 / 60.0),
                Timestep.variable(1 / 60.0).withMaxSteps(4));
        List<Timestep> again = List.of(
                Timestep.fixed(60).withMaxSteps(4).withMaxSteps(15),
                Timestep.fixed(61),
                Timestep.fixed(60).withMaxSteps(4),
                Timestep.fixed(1),
                Timestep.variable(1),
                Timestep.variable(1 / 60.0),
                Timestep.variable(1 / 60.0).withMaxSteps(4));
        for (int i = 0; i < all.size(); i++) {
            assertEquals(all.get(i), again.get(i));
            assertEquals(all.get(i).hashCode(), again.get(i).hashCode());
            assertEquals(all.get(i).toString(), again.get(i).toString());
            for (int j = 0; j < all.size(); j++) {
                if (j == i) continue;
                assertNotEquals(all.get(i), again.get(j));
                assertNotEquals(all.get(i).hashCode(), again.get(j).hashCode());
            }
        }
        Set<Timestep> set = new HashSet<>(all);
        set.addAll(again);
        assertEquals(all.size(), set.size());
        assertFalse(all.get(0).equals(null));
        assertFalse(all.get(0).equals((Object) all.get(0).toString()));
        assertTrue(all.get(0).equals(all.get(0)));
    }

    @Test
    void aWorldReturnsTheTimestepThatItWasGiven() {
        World world = new World();
        for (Timestep next : List.of(Timestep.fixed(25), Timestep.variable(0.5).withMaxSteps(3))) {
            world.setTimestep(next);
            assertEquals(next, world.getTimestep());
            World another = new World();
            another.restore(world.save());
            assertEquals(next, another.getTimestep());
        }
    }
}
