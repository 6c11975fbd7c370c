package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.From;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.Size;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.snapshot.Saves;
import yarts.physics.support.Doubles;

/** No sequence of changes of the timestep adds or loses time or impulse. */
class TimestepChangePropertyTest {
    private static final MathContext DIGITS = new MathContext(60, RoundingMode.HALF_EVEN);

    /** Steps of up to 1 s and catch-up limits that no frame of this test reaches. */
    private static final int NO_LIMIT = 100_000_000;

    /** A frame, and the timestep that is set before it, or null. */
    record Frame(Timestep change, double seconds, double force) {}

    /**
     * The rule in decimal arithmetic: the waiting seconds, and the pending impulse, distributed evenly over them. Steps
     * use the oldest time first. The number of steps is that of the world, because it rounds to 1e-9 of a step.
     */
    private static final class Model {
        BigDecimal waiting = BigDecimal.ZERO, pending = BigDecimal.ZERO, arrived = BigDecimal.ZERO;

        void advance(BigDecimal elapsed, BigDecimal force, Timestep timestep, int steps) {
            BigDecimal before = waiting, total = before.add(elapsed);
            if (timestep.isFixed()) {
                BigDecimal rate = new BigDecimal(timestep.getStepsPerSecond());
                double due = total.multiply(rate).doubleValue();
                assertTrue(
                        steps <= due + 2e-9 * (1 + due) && steps > due - 1 - 2e-9 * (1 + due),
                        () -> steps + " steps of " + due);
                waiting = total.subtract(new BigDecimal(steps).divide(rate, DIGITS))
                        .max(BigDecimal.ZERO);
            } else {
                assertTrue(steps > 0 || total.doubleValue() < 1.1e-9); // less than 1 ns continues to wait
                waiting = steps > 0 ? BigDecimal.ZERO : total;
            }
            BigDecimal old = steps == 0 ? before : waiting.subtract(elapsed).max(BigDecimal.ZERO);
            BigDecimal part = before.signum() == 0 ? BigDecimal.ZERO : old.divide(before, DIGITS);
            BigDecimal left = pending.multiply(part).add(force.multiply(waiting.subtract(old)));
            arrived = arrived.add(pending).add(force.multiply(elapsed)).subtract(left);
            pending = left;
        }
    }

    /** In whole nanoseconds, which are counted exactly, so only doubles are rounded. */
    @Property(tries = 1000)
    void impulseArrivesOrIsPending(
            @ForAll @Size(max = 80) List<@From("frames") Frame> frames,
            @ForAll Integrator integrator,
            @ForAll("mass") double mass) {
        World world = new World(integrator, Timestep.fixed(60).withMaxSteps(NO_LIMIT));
        Unit unit = world.add(new Unit(mass));
        Model model = new Model();
        double applied = 0, scale = 0, split = 0;
        for (Frame frame : frames) {
            if (frame.change != null) {
                double pending = unit.getPendingImpulseX(), v = unit.getVx();
                world.setTimestep(frame.change);
                assertEquals(pending + 0.0, unit.getPendingImpulseX() + 0.0, "a change preserves it");
                assertEquals(v, unit.getVx());
            }
            unit.applyForce(frame.force, 0);
            int steps = world.advance(frame.seconds);
            model.advance(
                    BigDecimal.valueOf(frame.seconds), BigDecimal.valueOf(frame.force), world.getTimestep(), steps);
            applied += frame.force * frame.seconds;
            scale += Math.abs(frame.force) * (frame.seconds + 1);
            split = Math.max(split, Math.abs(frame.force));
            double arrived = mass * unit.getVx(), pending = unit.getPendingImpulseX();
            assertEquals(applied, arrived + pending, 1e-11 * scale, "no impulse is lost or added");
            double rounding = 1e-11 * scale + 1e-8 * split;
            assertEquals(model.arrived.doubleValue(), arrived, rounding * frames.size(), "arrived");
            assertEquals(model.pending.doubleValue(), pending, rounding * frames.size(), "pending");
        }
    }

    /** For any time, not only whole nanoseconds. */
    @Property(tries = 1000)
    void elapsedTimeIsRunOrDroppedOrWaits(@ForAll @Size(max = 80) List<@From("limitedFrames") Frame> frames) {
        World world = new World();
        world.addBeforeStep((w, dt) -> assertTrue(dt >= 0.9e-9, "dt " + dt));
        BigDecimal in = BigDecimal.ZERO;
        double rounding = 2e-9;
        for (Frame frame : frames) {
            if (frame.change != null) {
                double time = world.getTime(), dropped = world.getDroppedTime();
                double waited = TimestepChangeTest.waiting(world);
                world.setTimestep(frame.change);
                assertEquals(time, world.getTime(), 2 * Math.ulp(time));
                assertEquals(dropped, world.getDroppedTime(), 2 * Math.ulp(dropped));
                assertEquals(waited, TimestepChangeTest.waiting(world), 2e-9);
                assertAlpha(world, waited);
            }
            world.advance(frame.seconds);
            in = in.add(new BigDecimal(frame.seconds));
            double out = world.getTime() + world.getDroppedTime(), waits = TimestepChangeTest.waiting(world);
            rounding += 8 * Math.ulp(out) + Math.ulp(frame.seconds);
            assertEquals(in.subtract(new BigDecimal(out)).doubleValue(), waits, rounding, "no time is lost or added");
            assertAlpha(world, waits);
        }
    }

    /** The fraction of a step that waits; just below 1 if more than a step waits. */
    private static void assertAlpha(World world, double waits) {
        double alpha = world.getAlpha();
        assertTrue(alpha >= 0 && alpha < 1 && (float) alpha < 1, () -> "alpha " + alpha);
        if (!world.getTimestep().isFixed()) return;
        int rate = world.getTimestep().getStepsPerSecond();
        assertEquals(Math.min(waits * rate, Math.nextDown(1f)), alpha, 3e-9 * rate);
    }

    /** Also while more than a step waits, and while time waits for a variable step. */
    @Property(tries = 300)
    void aRestoredWorldContinuesAsTheSavedOne(
            @ForAll @Size(min = 1, max = 30) List<@From("limitedFrames") Frame> frames, @ForAll Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(60));
        world.add(new Unit(2).setFriction(0.5));
        World other = Saves.restored(world.save());
        for (Frame frame : frames) {
            for (World w : List.of(world, other)) {
                if (frame.change != null) w.setTimestep(frame.change);
            }
            assertEquals(world.stateHash(), other.stateHash());
            Snapshot loaded = Snapshot.fromBytes(Saves.of(other));
            assertEquals("", world.save().difference(loaded));
            other.restore(loaded);
            for (World w : List.of(world, other)) {
                w.get(0).applyForce(frame.force, -frame.force);
                w.advance(frame.seconds);
            }
            assertEquals(world.stateHash(), other.stateHash());
            assertEquals(world.getAlpha(), other.getAlpha());
        }
    }

    /** A change to any other rates and back, without an advance between them. */
    @Property(tries = 1000)
    void aRateThatIsSetAgainHasTheAlphaThatItHad(
            @ForAll("rates") int rate,
            @ForAll @From("seconds") double seconds,
            @ForAll @Size(max = 6) List<@From("timesteps") Timestep> others) {
        Timestep timestep = Timestep.fixed(rate).withMaxSteps(1);
        World world = new World(Integrator.EXACT, timestep);
        Unit unit = world.add(new Unit(1));
        unit.applyForce(100, 0);
        world.advance(seconds);
        double alpha = world.getAlpha(), pending = unit.getPendingImpulseX();
        for (Timestep other : others) world.setTimestep(other);
        world.setTimestep(timestep);
        assertEquals(alpha, world.getAlpha(), 1.5e-9 + 1e-9 * others.size());
        assertEquals(pending + 0.0, unit.getPendingImpulseX() + 0.0);
    }

    @Provide
    Arbitrary<Frame> frames() {
        Arbitrary<Timestep> timesteps = timesteps().map(timestep -> timestep.withMaxSteps(NO_LIMIT));
        Arbitrary<Double> nanoseconds = seconds().map(s -> Math.max(1, Math.round(s * 1e9)) / 1e9);
        return frames(timesteps, nanoseconds);
    }

    @Provide
    Arbitrary<Frame> limitedFrames() {
        return frames(timesteps(), Arbitraries.frequencyOf(Tuple.of(9, seconds()), Tuple.of(1, Arbitraries.just(0.0))));
    }

    private static Arbitrary<Frame> frames(Arbitrary<Timestep> timesteps, Arbitrary<Double> seconds) {
        return Combinators.combine(timesteps.injectNull(0.5), seconds, force())
                .as(Frame::new)
                .withoutEdgeCases();
    }

    @Provide
    Arbitrary<Timestep> timesteps() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, rates().map(Timestep::fixed)),
                Tuple.of(1, Doubles.logUniform(1e-3, 1).map(Timestep::variable)));
    }

    @Provide
    Arbitrary<Integer> rates() {
        return Arbitraries.frequencyOf(
                Tuple.of(4, Arbitraries.of(1, 2, 10, 20, 25, 30, 50, 60, 64, 144, 240)),
                Tuple.of(2, Arbitraries.integers().between(1, 1000)),
                Tuple.of(1, Doubles.logUniform(1, 1e5).map(rate -> (int) (double) rate)));
    }

    @Provide
    Arbitrary<Double> seconds() {
        return Doubles.logUniform(1e-5, 1);
    }

    private static Arbitrary<Double> force() {
        return Doubles.signedLogUniform(1e-3, 1e6);
    }

    @Provide
    Arbitrary<Double> mass() {
        return Doubles.logUniform(1e-3, 1e6);
    }
}
