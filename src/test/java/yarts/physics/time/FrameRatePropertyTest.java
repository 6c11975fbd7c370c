package yarts.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** A force acts for the time by which the world advances, at any frame rate. */
class FrameRatePropertyTest {
    private static final int RATE = 60;
    private static final double DT = 1.0 / RATE;

    /** A frame: whole nanoseconds, and the force applied before it. */
    record Frame(long ns, double fx, double fy) {
        double seconds() {
            return ns / 1e9;
        }
    }

    @Property(tries = 2000)
    void aConstantForceHasTheSameEffectAtEveryFrameRate(
            @ForAll("frameRates") double fps,
            @ForAll Integrator integrator,
            @ForAll("units") Unit unit,
            @ForAll("force") double fx,
            @ForAll("force") double fy) {
        assertSameAsSingleSteps(integrator, unit, fx, fy, 120, i -> 1 / fps);
    }

    /** Up to 0.75 s, so that some of the time is dropped, with the force's share of it. */
    @Property
    void aConstantForceHasTheSameEffectAtRandomFrameTimes(
            @ForAll @Size(min = 20, max = 200) List<@From("frames") Frame> frames,
            @ForAll Integrator integrator,
            @ForAll("units") Unit unit,
            @ForAll("force") double fx,
            @ForAll("force") double fy) {
        assertSameAsSingleSteps(
                integrator,
                unit,
                fx,
                fy,
                120,
                i -> 3 * frames.get(i % frames.size()).seconds() + 1e-6);
    }

    private interface FrameTimes {
        double seconds(int frame);
    }

    /** Compares frames of any length with the same number of single steps under the same force. */
    private static void assertSameAsSingleSteps(
            Integrator integrator, Unit alone, double fx, double fy, int ticks, FrameTimes frames) {
        World world = new World(integrator, Timestep.fixed(RATE));
        Unit unit = world.add(new Unit(alone.getMass()).setFriction(alone.getFriction()));
        for (int tick = 0, frame = 0; tick < ticks; frame++) {
            unit.applyForce(fx, fy);
            world.advance(frames.seconds(frame));
            for (; tick < world.getTick(); tick++) {
                alone.applyForce(fx, fy);
                alone.integrate(DT, integrator);
            }
            assertEquals(alone.getVx(), unit.getVx(), 1e-9 * Math.abs(alone.getVx()));
            assertEquals(alone.getVy(), unit.getVy(), 1e-9 * Math.abs(alone.getVy()));
            assertEquals(alone.getX(), unit.getX(), 1e-9 * Math.abs(alone.getX()));
            assertEquals(alone.getY(), unit.getY(), 1e-9 * Math.abs(alone.getY()));
        }
    }

    @Property(tries = 2000)
    void noImpulseIsLostOrAdded(
            @ForAll @Size(max = 200) List<@From("frames") Frame> frames,
            @ForAll Integrator integrator,
            @ForAll("mass") double mass) {
        World world = new World(integrator, Timestep.fixed(RATE));
        Unit unit = world.add(new Unit(mass));
        double[] applied = {0, 0}, scale = {0, 0};
        for (Frame frame : frames) {
            unit.applyForce(frame.fx, frame.fy);
            world.advance(frame.seconds());
            applied[0] += frame.fx * frame.seconds();
            applied[1] += frame.fy * frame.seconds();
            scale[0] += Math.abs(frame.fx) * (frame.seconds() + DT);
            scale[1] += Math.abs(frame.fy) * (frame.seconds() + DT);
        }
        world.advance(DT + 1e-9); // the pending impulse acts in a step without a force
        assertEquals(applied[0], mass * unit.getVx(), 1e-14 * scale[0]);
        assertEquals(applied[1], mass * unit.getVy(), 1e-14 * scale[1]);
    }

    @Property
    void framesWithoutAStepLoseNothing(
            @ForAll("force") double force,
            @ForAll("mass") double mass,
            @ForAll Integrator integrator,
            @ForAll @Size(min = 1, max = 100) List<@From("shortFrames") Long> frames) {
        World world = new World(integrator, Timestep.fixed(RATE));
        Unit unit = world.add(new Unit(mass));
        long ns = 0;
        for (long frame : frames) {
            unit.applyForce(force, -force);
            assertEquals(0, world.advance(frame / 1e9));
            assertEquals(0, unit.getVx());
            assertEquals(0, unit.getFx());
            ns += frame;
        }
        assertTrue(ns < 1_000_000_000 / RATE);
        assertEquals(1, world.advance(DT));
        double expected = force * (ns / 1e9) / mass;
        double rounding = 1e-15 * frames.size() * Math.abs(force) * DT / mass;
        assertEquals(expected, unit.getVx(), rounding);
        assertEquals(-expected, unit.getVy(), rounding);
    }

    @Property
    void framesOfZeroSecondsNeitherAddNorLoseImpulse(
            @ForAll @Size(max = 100) List<@From("frames") Frame> frames,
            @ForAll Integrator integrator,
            @ForAll("units") Unit unit,
            @ForAll("force") double wild) {
        World plain = new World(integrator, Timestep.fixed(RATE));
        World paused = new World(integrator, Timestep.fixed(RATE));
        Unit a = plain.add(new Unit(unit.getMass()).setFriction(unit.getFriction()));
        Unit b = paused.add(unit);
        for (Frame frame : frames) {
            b.applyForce(wild, -wild);
            assertEquals(0, paused.advance(0));
            a.applyForce(frame.fx, frame.fy);
            b.applyForce(frame.fx, frame.fy);
            plain.advance(frame.seconds());
            paused.advance(frame.seconds());
            sameBits(a, b);
        }
    }

    /** It loses its forces and its pending impulse; the unit that takes its row keeps its own. */
    @Property
    void onlyAUnitThatLeavesAndReturnsLosesItsPendingImpulse(
            @ForAll @Size(max = 100) List<@From("frames") Frame> frames,
            @ForAll Integrator integrator,
            @ForAll("units") Unit unit) {
        World stays = new World(integrator, Timestep.fixed(RATE));
        World leaves = new World(integrator, Timestep.fixed(RATE));
        Unit a = stays.add(new Unit(unit.getMass()).setFriction(unit.getFriction()));
        leaves.add(new Unit(1)); // so that the unit also changes its row
        Unit b = leaves.add(unit);
        for (Frame frame : frames) {
            a.applyForce(frame.fx, frame.fy);
            b.applyForce(frame.fx, frame.fy);
            leaves.remove(frame.ns % 2 == 0 ? b : leaves.get(0));
            if (b.getWorld() == null) {
                leaves.add(b);
                a.clearForces();
            }
            stays.advance(frame.seconds());
            leaves.advance(frame.seconds());
            sameBits(a, b);
            if (leaves.size() < 2) leaves.add(new Unit(1));
        }
    }

    @Property
    void aForceFromAListenerActsOnlyForItsStep(
            @ForAll @Size(max = 100) List<@From("frames") Frame> frames,
            @ForAll Integrator integrator,
            @ForAll("units") Unit alone,
            @ForAll("force") double force) {
        World world = new World(integrator, Timestep.fixed(RATE));
        Unit unit = world.add(new Unit(alone.getMass()).setFriction(alone.getFriction()));
        world.addBeforeStep((w, dt) -> unit.applyForce(force, -force));
        for (Frame frame : frames) {
            int steps = world.advance(frame.seconds());
            for (int i = 0; i < steps; i++) {
                alone.applyForce(force, -force);
                alone.integrate(DT, integrator);
            }
            sameBits(alone, unit);
        }
    }

    private static void sameBits(Unit a, Unit b) {
        assertEquals(bits(a.getVx()), bits(b.getVx()));
        assertEquals(bits(a.getVy()), bits(b.getVy()));
        assertEquals(bits(a.getX()), bits(b.getX()));
        assertEquals(bits(a.getY()), bits(b.getY()));
    }

    private static long bits(double v) {
        return Double.doubleToRawLongBits(v);
    }

    @Provide
    Arbitrary<Double> frameRates() {
        return Arbitraries.of(15.0, 24.0, 30.0, 50.0, 59.94, 60.0, 75.0, 144.0, 240.0, 1000.0);
    }

    /** Up to a quarter of a second, which is the catch-up limit; a frame may be empty. */
    @Provide
    Arbitrary<Frame> frames() {
        Arbitrary<Long> ns = Arbitraries.frequencyOf(
                Tuple.of(9, Doubles.logUniform(1e4, 2.5e8).map(Math::round)),
                Tuple.of(1, Arbitraries.of(0L, 1L, 16_666_666L, 16_666_667L)));
        return Combinators.combine(ns, force(), force()).as(Frame::new).withoutEdgeCases();
    }

    /** A hundred of them are shorter than a step. */
    @Provide
    Arbitrary<Long> shortFrames() {
        return Arbitraries.longs().between(0, 166_000);
    }

    /** With and without friction, f dt/m from 1e-6 to 100. */
    @Provide
    Arbitrary<Unit> units() {
        Arbitrary<Double> z =
                Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.just(0.0)), Tuple.of(3, Doubles.logUniform(1e-6, 100)));
        return Combinators.combine(mass(), z)
                .as((m, ratio) -> new Unit(m).setFriction(ratio * m / DT))
                .withoutEdgeCases();
    }

    @Provide
    Arbitrary<Double> mass() {
        return Doubles.logUniform(1e-3, 1e6);
    }

    @Provide
    Arbitrary<Double> force() {
        return Doubles.signedLogUniform(1e-3, 1e9);
    }
}
