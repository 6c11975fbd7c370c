package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.From;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** With forces from listeners, steps have the same bits in calls of step() and in frames of any length. */
class ListenerForcesPropertyTest {
    private static final class Halt extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    /**
     * A world whose listeners are drawn from a seed: springs, drives and changes of the units, before and after every
     * step, and sometimes an exception. Their actions depend only on the seed, the step and the world.
     */
    private static final class Game {
        final World world;
        final long seed;
        final boolean halts;
        /** The length of each step that has begun. */
        final List<Double> lengths = new ArrayList<>();
        /** The state that the listeners saw in each step. */
        final List<Long> seen = new ArrayList<>();

        int phases;

        Game(long seed, int units, boolean halts, Integrator integrator, Timestep timestep) {
            this.seed = seed;
            this.halts = halts;
            world = new World(integrator, timestep);
            for (int i = 0; i < units; i++) world.add(newUnit(i));
            world.addBeforeStep((w, dt) -> {
                lengths.add(dt);
                act();
            });
            world.addBeforeStep((w, dt) -> look());
            world.addAfterStep((w, dt) -> act());
            world.addAfterStep((w, dt) -> look());
        }

        Unit newUnit(int i) {
            return new Unit(1 + i % 3).setFriction(i % 4 * 0.5).setPosition(i * 0.37, -i * 0.11);
        }

        void act() {
            SplittableRandom random = new SplittableRandom(seed + 31L * phases++);
            if (world.size() == 0) world.add(newUnit(phases));
            for (int n = random.nextInt(4); n > 0; n--) {
                Unit unit = world.get(random.nextInt(world.size()));
                double k = random.nextDouble() * 30;
                switch (random.nextInt(16)) {
                    case 0 -> unit.clearForces();
                    case 1 -> unit.setFrozen(random.nextInt(3) == 0);
                    case 2 -> unit.setVelocity(k - 15, 15 - k);
                    case 3 -> unit.applyImpulse(k - 15, 3);
                    case 4 -> world.add(newUnit(phases)).applyForce(k, -k);
                    case 5 -> {
                        if (world.size() > 1) world.remove(unit);
                    }
                    case 6 -> {
                        double[] xy = new double[2 * world.size()];
                        for (int i = 0; i < xy.length; i++) xy[i] = k - i % 7;
                        world.applyForces(xy, 0);
                    }
                    case 7 -> unit.integrate(0.01, world.getIntegrator());
                    case 8, 9, 10 -> unit.applyForce(k, 1 - k);
                    default -> unit.applyForce(k * (1 - unit.getX()) - unit.getVx(), -k * unit.getY() - unit.getVy());
                }
            }
            if (halts && random.nextInt(12) == 0) throw new Halt();
        }

        void look() {
            seen.add((long) world.size());
            for (int i = 0; i < world.size(); i++) {
                Unit unit = world.get(i);
                seen.add(unit.getId());
                for (double v :
                        new double[] {unit.getX(), unit.getY(), unit.getVx(), unit.getVy(), unit.getFx(), unit.getFy()
                        }) {
                    seen.add(Double.doubleToRawLongBits(v + 0.0));
                }
            }
        }

        void run(Runnable call) {
            try {
                call.run();
            } catch (Halt e) {
                // thrown by a listener: the rest of the frame is dropped
            }
        }
    }

    @Property(tries = 1000)
    void framesOfAnyLengthGiveTheBitsOfSingleSteps(
            @ForAll long seed,
            @ForAll @IntRange(min = 1, max = 6) int units,
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 1, max = 240) int rate,
            @ForAll @Size(min = 1, max = 60) List<@From("frames") Double> frames) {
        Timestep timestep = Timestep.fixed(rate).withMaxSteps(20);
        Game game = new Game(seed, units, false, integrator, timestep);
        Game steps = new Game(seed, units, false, integrator, timestep);
        for (double frame : frames) {
            int n = game.world.advance(frame / rate);
            for (int i = 0; i < n; i++) steps.world.step();
            game.look();
            steps.look();
            assertEquals(steps.seen, game.seen);
            game.seen.clear();
            steps.seen.clear();
            for (Unit unit : game.world) assertEquals(0, unit.getPendingImpulseX());
        }
    }

    @Property(tries = 300)
    void everyFrameRateGivesTheBitsOfSingleSteps(
            @ForAll long seed,
            @ForAll @IntRange(min = 1, max = 6) int units,
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 1, max = 120) int rate,
            @ForAll @IntRange(min = 1, max = 500) int framesPerSecond) {
        Timestep timestep = Timestep.fixed(rate).withMaxSteps(rate);
        Game game = new Game(seed, units, false, integrator, timestep);
        Game steps = new Game(seed, units, false, integrator, timestep);
        for (int i = 0; i < 2 * framesPerSecond; i++) game.world.advance(1.0 / framesPerSecond);
        for (int i = 0; i < 2 * rate; i++) steps.world.step();
        game.look();
        steps.look();
        assertEquals(steps.seen, game.seen);
    }

    /**
     * All kinds of calls, with changes of the timestep, saves and restores between them, and listeners that throw. The
     * reference calls step(dt) with the same lengths.
     */
    @Property(tries = 1000)
    void anySequenceOfCallsGivesTheBitsOfSingleSteps(
            @ForAll long seed,
            @ForAll @IntRange(min = 1, max = 6) int units,
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 1, max = 60) int calls) {
        same(seed, units, integrator, calls);
    }

    /** In more than two tiles of units. */
    @Property(tries = 20)
    void anySequenceOfCallsOfALargeWorldGivesTheBitsOfSingleSteps(@ForAll long seed, @ForAll Integrator integrator) {
        same(seed, 1030, integrator, 30);
    }

    private static void same(long seed, int units, Integrator integrator, int calls) {
        SplittableRandom random = new SplittableRandom(seed);
        Game game = new Game(seed, units, true, integrator, Timestep.fixed(60));
        for (int i = 0; i < calls; i++) game.run(() -> call(game.world, random));
        Game steps = new Game(seed, units, true, integrator, Timestep.fixed(60));
        for (double dt : game.lengths) steps.run(() -> steps.world.step(dt));
        game.look();
        steps.look();
        assertEquals(steps.seen, game.seen);
        assertEquals(steps.world.getTick(), game.world.getTick());
        assertEquals(steps.lengths, game.lengths);
    }

    private static void call(World world, SplittableRandom random) {
        double seconds = random.nextDouble() * 0.1;
        switch (random.nextInt(10)) {
            case 0 -> world.step();
            case 1 -> world.step(random.nextInt(4) == 0 ? 0 : seconds);
            case 2 -> world.advance(0);
            case 3 -> world.advance(seconds * 0.05);
            case 4 -> world.setTimestep(Timestep.fixed(1 + random.nextInt(120)));
            case 5 -> world.setTimestep(Timestep.variable(0.005 + seconds));
            case 6 -> world.restore(world.save());
            case 7 -> {
                Snapshot loaded = Snapshot.fromBytes(world.save().toBytes());
                world.clear();
                world.restore(loaded);
            }
            default -> world.advance(seconds);
        }
    }

    /** A frame: its length, the force applied before it, and the forces applied before and after each of its steps. */
    record Push(double seconds, double frame, double before, double after) {}

    /**
     * The momentum and the pending impulse are the sum of each frame's force times the time of the frame, and of each
     * listener's force times the length of its step.
     */
    @Property(tries = 1000)
    void forcesOfFramesAndListenersActForTheirOwnTimes(
            @ForAll @Size(max = 100) List<@From("pushes") Push> pushes,
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 1, max = 240) int rate,
            @ForAll("mass") double mass) {
        World world = new World(integrator, Timestep.fixed(rate).withMaxSteps(1000));
        Unit unit = world.add(new Unit(mass));
        double[] sum = {0, 0}, now = {0, 0, 0};
        world.addBeforeStep((w, dt) -> {
            unit.applyForce(now[0], 0);
            sum[0] += (now[0] + now[2]) * dt;
            sum[1] += (Math.abs(now[0]) + Math.abs(now[2])) * dt;
        });
        world.addAfterStep((w, dt) -> {
            unit.applyForce(now[1], 0);
            now[2] = now[1];
        });
        for (Push push : pushes) {
            now[0] = push.before;
            now[1] = push.after;
            unit.applyForce(push.frame, 0);
            world.advance(push.seconds);
            sum[0] += push.frame * push.seconds;
            sum[1] += Math.abs(push.frame) * (push.seconds + 1.0 / rate);
            assertEquals(now[2] + 0.0, unit.getFx() + 0.0, "only the force for the next step");
            assertEquals(sum[0], mass * unit.getVx() + unit.getPendingImpulseX(), 1e-12 * sum[1]);
        }
    }

    /** Lengths in steps: less than one, one, or several. */
    @Provide
    Arbitrary<Double> frames() {
        return Arbitraries.frequencyOf(
                Tuple.of(6, Doubles.logUniform(1e-3, 15)), Tuple.of(1, Arbitraries.of(0.0, 0.5, 1.0, 2.0, 30.0)));
    }

    /** Whole nanoseconds: they are counted without rounding. */
    @Provide
    Arbitrary<Push> pushes() {
        Arbitrary<Double> seconds =
                Doubles.logUniform(1e5, 1e9).map(Math::round).map(ns -> ns / 1e9);
        return Combinators.combine(seconds, force(), force(), force())
                .as(Push::new)
                .withoutEdgeCases();
    }

    @Provide
    Arbitrary<Double> force() {
        return Doubles.signedLogUniform(1e-3, 1e6);
    }

    @Provide
    Arbitrary<Double> mass() {
        return Doubles.logUniform(1e-3, 1e6);
    }
}
