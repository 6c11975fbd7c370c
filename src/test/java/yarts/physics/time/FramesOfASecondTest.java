package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.World;

/** n frames of 1.0/n seconds are one second, for every n: no tick is lost or late. */
class FramesOfASecondTest {
    private static World world(int rate) {
        return new World(Integrator.EULER, Timestep.fixed(rate).withMaxSteps(1_000_000));
    }

    @Test
    void aFrameOfOneStepRunsOneStep() {
        for (int rate = 1; rate <= 1000; rate++) assertEquals(1, world(rate).advance(1.0 / rate), "rate " + rate);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 24, 25, 30, 50, 60, 64, 75, 90, 120, 128, 144, 240, 1000})
    void nFramesOfOneNthOfASecondAreOneSecond(int rate) {
        for (int n = 1; n <= 1000; n++) {
            World world = world(rate);
            for (int second = 1; second <= 20; second++) {
                for (int frame = 0; frame < n; frame++) world.advance(1.0 / n);
                if (world.getTick() != (long) rate * second || world.getAlpha() != 0) {
                    assertEquals((long) rate * second, world.getTick(), n + " frames a second, second " + second);
                    assertEquals(0, world.getAlpha(), n + " frames a second, second " + second);
                }
            }
        }
    }

    /** After k frames of 1/n s, the tick is k·rate/n, rounded down. */
    @Test
    void everyTickRunsInTheFrameInWhichItsTimeEnds() {
        for (int rate : new int[] {24, 30, 50, 60, 64, 128}) {
            for (int n : new int[] {7, 30, 59, 60, 75, 90, 120, 144, 165, 240, 999}) {
                World world = world(rate);
                for (long k = 1; k <= 10L * n; k++) {
                    world.advance(1.0 / n);
                    assertEquals(k * rate / n, world.getTick(), rate + " ticks, frame " + k + " of " + n + " a second");
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 0.7e-9, 1e-10, 3e-11, 1e-12, 1e-15})
    void theShortestTimesAreNotLost(double elapsed) {
        World world = world(60);
        int frames = 1_000_000;
        for (int i = 0; i < frames; i++) world.advance(elapsed);
        double part = frames * elapsed * 60; // of a step
        assertEquals(part - Math.floor(part), world.getAlpha(), 1e-9);
        assertEquals((long) part, world.getTick());
    }

    /** A day of frames of 1/144 s. The double differs slightly, so the end is off by some billionths of a step. */
    @Test
    void aDayOfFramesLosesNoTick() {
        World world = world(60);
        long frames = 144L * 86_400;
        for (long i = 0; i < frames; i++) world.advance(1 / 144.0);
        double steps = world.getTick() + world.getAlpha();
        assertEquals(60 * 86_400, steps, 1e-6);
    }

    @Test
    void framesOfWholeSecondsAreExact() {
        World world = world(1_000_000);
        for (double seconds : new double[] {1, 2.5, 1e6, 999_999_999.5}) world.advance(seconds);
        assertEquals(0, world.getAlpha());
        assertEquals(1_000_000L * 4, world.getTick(), "in each frame as many as the limit allows");
        assertEquals(1 + 2.5 + 1e6 + 999_999_999.5, world.getTime() + world.getDroppedTime(), 1e-3);
    }
}
