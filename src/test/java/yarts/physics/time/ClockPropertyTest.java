package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.From;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.World;
import yarts.physics.snapshot.Saves;
import yarts.physics.support.Doubles;

/** No tick is lost or added: the elapsed time is exactly the time that was run, dropped, or still waits. */
class ClockPropertyTest {
    private static final long SECOND = 1_000_000_000;
    private static final long DAY = 86_400 * SECOND;

    @Property(tries = 8)
    void noTickIsLostInADay(@ForAll long seed, @ForAll("rates") int rate) {
        play(DAY, rate, new SplittableRandom(seed));
    }

    @Property(tries = 1)
    @Tag("long")
    void noTickIsLostInAYear(@ForAll long seed) {
        play(365 * DAY, 144, new SplittableRandom(seed));
    }

    /**
     * Plays frames of random length: most at 4 to 1000 frames a second, one in 64 a hitch of up to 4 s. All sums are
     * whole nanoseconds times the rate; a year of them at 144 ticks/s is 4.5e18, just within a long.
     */
    private static void play(long total, int rate, SplittableRandom random) {
        World world = new World(Integrator.EULER, Timestep.fixed(rate));
        int limit = (rate + 3) / 4;
        long in = 0, run = 0, dropped = 0;
        while (in < total) {
            long r = random.nextLong();
            long ns = (r & 63) == 0 ? (r >>> 30) % (4 * SECOND) : SECOND / 1000 + (r >>> 34) % (SECOND / 4);
            long before = in * rate / SECOND;
            in += ns;
            long due = in * rate / SECOND - before;
            long steps = Math.min(due, limit);
            if (world.advance(ns / 1e9) != steps) assertEquals(steps, -1, "steps of a frame of " + ns + " ns");
            run += steps;
            dropped += due - steps;
            long remainder = in * rate % SECOND;
            double alpha = world.getAlpha();
            if (alpha != Math.min(remainder / 1e9, Math.nextDown(1f)) || !((float) alpha < 1)) {
                assertEquals(remainder / 1e9, alpha, 0, "alpha");
            }
            if (world.getTick() != run) assertEquals(run, world.getTick());
        }
        assertEquals(in / SECOND * rate + in % SECOND * rate / SECOND, run + dropped); // run + dropped + part of a tick
        assertTrue(dropped > 0);
        assertEquals((double) run / rate, world.getTime());
        assertEquals((double) dropped / rate, world.getDroppedTime());
    }

    @Property(tries = 3000)
    void runDroppedAndWaitingTimeAreTheElapsedTime(
            @ForAll @Size(max = 50) List<@From("elapsed") Double> frames,
            @ForAll @IntRange(min = 1, max = 1_000_000) int rate,
            @ForAll @IntRange(min = 1, max = 100) int limit) {
        World world = new World(Integrator.EULER, Timestep.fixed(rate).withMaxSteps(limit));
        BigDecimal in = BigDecimal.ZERO;
        double rounding = 1e-9 / rate; // once, for its error is carried on; but a double's own counts each time
        for (double elapsed : frames) {
            int steps = world.advance(elapsed);
            assertTrue(steps >= 0 && steps <= limit);
            in = in.add(new BigDecimal(elapsed));
            rounding += Math.ulp(elapsed);
            double alpha = world.getAlpha();
            assertTrue(alpha >= 0 && alpha < 1 && (float) alpha < 1, () -> "alpha " + alpha);
        }
        BigDecimal out = new BigDecimal(world.getTime())
                .add(new BigDecimal(world.getDroppedTime()))
                .add(new BigDecimal(world.getAlpha() / rate));
        double tolerance = rounding + Math.ulp(world.getTime()) + Math.ulp(world.getDroppedTime()) + 0x1p-24 / rate;
        assertEquals(0, in.subtract(out).doubleValue(), tolerance);
        assertEquals((double) world.getTick() / rate, world.getTime());
    }

    @Property(tries = 3000)
    void wholeNanosecondsAreExact(
            @ForAll @Size(min = 1, max = 50) List<@From("nanoseconds") Long> frames,
            @ForAll @IntRange(min = 1, max = 1_000_000) int rate) {
        World world = new World(Integrator.EULER, Timestep.fixed(rate).withMaxSteps(1));
        BigInteger in = BigInteger.ZERO;
        for (long ns : frames) {
            world.advance(ns / 1e9);
            in = in.add(BigInteger.valueOf(ns).multiply(BigInteger.valueOf(rate))); // in 1e-9 of a step
            long remainder = in.mod(BigInteger.valueOf(SECOND)).longValueExact();
            assertEquals(Math.min(remainder / 1e9, Math.nextDown(1f)), world.getAlpha());
        }
    }

    /**
     * Usually 1/n s is not a whole number of nanoseconds, nor is the double exactly 1/n. At up to 100,000 steps/s, the
     * rounding errors of these doubles stay below a tenth of 1e-9 of a step in three seconds. At a million, they can
     * reach the half at which the clock rounds up or down.
     */
    @Property(tries = 200)
    void nFramesOfOneNthOfASecondAreOneSecond(@ForAll("framesASecond") int n, @ForAll("anyRate") int rate) {
        World world = new World(Integrator.EULER, Timestep.fixed(rate).withMaxSteps(rate));
        for (int second = 1; second <= 3; second++) {
            long start = world.getTick();
            for (int i = 0; i < n - 1; i++) world.advance(1.0 / n);
            assertTrue(world.getTick() - start < rate);
            world.advance(1.0 / n);
            assertEquals((long) second * rate, world.getTick());
            assertEquals(0, world.getAlpha());
            assertEquals(second, world.getTime());
        }
    }

    /** Even if nearly a whole step was waiting before the frame. */
    @Property(tries = 1000)
    void equalFramesOfUpToAQuarterOfASecondDropNothing(
            @ForAll @IntRange(min = 1, max = 1000) int rate, @ForAll @From("quarters") double elapsed) {
        for (int nanos : new int[] {0, (int) (SECOND / rate) - 1}) {
            World world = new World(Integrator.EULER, Timestep.fixed(rate));
            world.advance(nanos / 1e9 % 0.25);
            for (int frame = 0; frame < 1000; frame++) world.advance(elapsed);
            assertEquals(0, world.getDroppedTime());
        }
    }

    @Property(tries = 1000)
    void variableFramesOfUpToAQuarterOfASecondDropNothing(
            @ForAll("maxSteps") double maxStep, @ForAll @From("quarters") double elapsed) {
        World world = new World(Integrator.EULER, Timestep.variable(maxStep));
        for (int frame = 0; frame < 10; frame++) world.advance(elapsed);
        assertEquals(0, world.getDroppedTime());
    }

    /** Times up to 1/4 s, with the bounds of whole steps. */
    @Provide
    Arbitrary<Double> quarters() {
        return Arbitraries.oneOf(
                Arbitraries.of(0.25, 0.2, 1 / 6.0, Math.nextDown(0.25)),
                Arbitraries.integers().between(4, 1000).map(n -> 1.0 / n),
                Doubles.logUniform(1e-3, 0.25));
    }

    /** For any number of frames, also mixed with whole nanoseconds. */
    @Property(tries = 300)
    void roundingErrorsAreCompensatedAndDoNotAddUp(
            @ForAll @From("shortTimes") double elapsed, @ForAll("rates") int rate) {
        World world = new World(Integrator.EULER, Timestep.fixed(rate));
        BigDecimal frame = new BigDecimal(elapsed), steps = new BigDecimal(rate);
        for (int i = 1; i <= 2000; i++) {
            world.advance(elapsed);
            world.advance(1e-9);
            BigDecimal in = frame.add(new BigDecimal("1e-9"))
                    .multiply(new BigDecimal(i))
                    .multiply(steps);
            double alpha = world.getAlpha(), out = world.getTick() + alpha;
            double most = alpha == Math.nextDown(1f) ? 0x1p-24 : 0.51e-9; // alpha is never above this float
            assertEquals(0, in.subtract(new BigDecimal(out)).doubleValue(), most + Math.ulp(out), i + " frames");
        }
    }

    @Provide
    Arbitrary<Double> shortTimes() {
        return Doubles.logUniform(1e-7, 1e-3);
    }

    @Provide
    Arbitrary<Integer> framesASecond() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, Arbitraries.integers().between(1, 1000)),
                Tuple.of(1, Arbitraries.integers().between(1000, 20_000)));
    }

    @Provide
    Arbitrary<Integer> anyRate() {
        return Arbitraries.frequencyOf(
                Tuple.of(4, Arbitraries.integers().between(1, 1000)),
                Tuple.of(1, Arbitraries.integers().between(1000, 100_000)));
    }

    @Provide
    Arbitrary<Long> nanoseconds() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, Doubles.logUniform(1, 1e9).map(Math::round)),
                Tuple.of(1, Arbitraries.longs().between(0, 8_000_000 * SECOND)), // below 2^53
                Tuple.of(1, Arbitraries.of(0L, 1L, SECOND, SECOND - 1, 16_666_667L)));
    }

    @Property(tries = 2000)
    void variableStepsAreEqualAndNoneIsTooLong(
            @ForAll @Size(max = 50) List<@From("elapsed") Double> frames,
            @ForAll("maxSteps") double maxStep,
            @ForAll @IntRange(min = 1, max = 100) int limit) {
        World world = new World(Integrator.EULER, Timestep.variable(maxStep).withMaxSteps(limit));
        double[] last = {0, 0};
        world.addBeforeStep((w, dt) -> {
            assertTrue(dt > 0 && dt <= maxStep, () -> dt + " > " + maxStep);
            if (last[1]++ > 0) assertEquals(last[0], dt);
            last[0] = dt;
        });
        BigDecimal in = BigDecimal.ZERO;
        int ticks = 0;
        for (double elapsed : frames) {
            last[1] = 0;
            int steps = world.advance(elapsed);
            ticks += steps;
            assertEquals(last[1], steps);
            int fewest = elapsed == 0 ? 0 : (int) Math.min(limit, Math.max(1, Math.floor(elapsed / maxStep)));
            assertTrue(
                    steps == fewest || (steps == fewest + 1 && steps <= limit), () -> steps + " steps, not " + fewest);
            in = in.add(new BigDecimal(elapsed));
        }
        double out = world.getTime() + world.getDroppedTime();
        assertEquals(in.doubleValue(), out, 1e-15 * (ticks + 4) * in.doubleValue());
        assertEquals(ticks, world.getTick());
        assertEquals(0, world.getAlpha());
    }

    @Provide
    Arbitrary<Integer> rates() {
        return Arbitraries.of(30, 60, 64, 144);
    }

    /** Usual frames, and any other accepted time. */
    @Provide
    Arbitrary<Double> elapsed() {
        return Arbitraries.frequencyOf(
                Tuple.of(6, Doubles.logUniform(1e-6, 1)),
                Tuple.of(2, Doubles.logUniform(0, 1e9)),
                Tuple.of(1, Arbitraries.of(0.0, -0.0, 0.4999999999e-9, 0.5e-9, 1 / 60.0, 1.0, 1e9)));
    }

    @Provide
    Arbitrary<Double> maxSteps() {
        return Doubles.logUniform(1e-6, 1e9);
    }

    /** The lengths of steps are summed with compensation: the snapshot contains the rounding error. */
    @Property
    void irregularTimeIsSummedToTheLastBit(@ForAll @Size(min = 2, max = 100) List<@From("lengths") Double> steps) {
        World world = new World(Integrator.EULER, Timestep.variable(1));
        BigDecimal exact = BigDecimal.ZERO;
        for (double dt : steps) {
            world.step(dt);
            exact = exact.add(new BigDecimal(dt));
        }
        byte[] save = Saves.of(world);
        double sum = (Double) Saves.places(0).get("time").get(save),
                error = (Double) Saves.places(0).get("timeError").get(save);
        double left = exact.subtract(new BigDecimal(sum))
                .subtract(new BigDecimal(error))
                .abs()
                .doubleValue();
        assertTrue(left <= steps.size() * steps.size() * Math.ulp(Math.ulp(sum)), () -> left + " s are lost of " + sum);
        assertEquals(exact.doubleValue(), world.getTime(), Math.ulp(sum));
    }

    @Provide
    Arbitrary<Double> lengths() {
        return Doubles.logUniform(1e-9, 1e9);
    }
}
