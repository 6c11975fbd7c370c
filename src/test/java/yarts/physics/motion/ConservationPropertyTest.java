package yarts.physics.motion;

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
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** The momentum is the sum of all impulses, and friction only removes energy. */
class ConservationPropertyTest {
    /** An impulse, a force, and the number of 64ths of a second for which the force acts. */
    record Push(int kick, int force, int time) {
        double seconds() {
            return time / 64.0;
        }

        double impulse() {
            return kick + force * seconds();
        }
    }

    @Provide
    Arbitrary<Push> pushes() {
        Arbitrary<Integer> newtons = Arbitraries.integers().between(-1000, 1000);
        return Combinators.combine(newtons, newtons, Arbitraries.integers().between(0, 100))
                .as(Push::new);
    }

    /** Only integers and powers of two: nothing is rounded, so the result must be exact. */
    @Property
    void withoutFrictionMomentumChangesByExactlyTheImpulse(
            @ForAll @Size(min = 1, max = 60) List<@From("pushes") Push> pushes,
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = -6, max = 6) int mass) {
        World world = new World(integrator, Timestep.variable(1));
        Unit unit = world.add(new Unit(Math.scalb(1.0, mass)).setVelocity(3, -5));
        double px = 3 * unit.getMass(), py = -5 * unit.getMass();
        for (Push push : pushes) {
            unit.applyImpulse(push.kick, -push.kick);
            unit.applyForce(push.force, -push.force);
            world.step(push.seconds());
            px += push.impulse();
            py -= push.impulse();
            assertEquals(px, unit.getMass() * unit.getVx());
            assertEquals(py, unit.getMass() * unit.getVy());
        }
    }

    /** At any frame rate, an impulse has either acted or is pending, within rounding. */
    @Property
    void momentumAndPendingImpulseAreTheAppliedImpulse(
            @ForAll @Size(min = 1, max = 60) List<@From("pushes") Push> pushes,
            @ForAll Integrator integrator,
            @ForAll("masses") double mass,
            @ForAll @IntRange(min = 1, max = 1000) int rate,
            @ForAll boolean fixed) {
        Timestep timestep = fixed ? Timestep.fixed(rate) : Timestep.variable(1.0 / rate);
        World world = new World(integrator, timestep.withMaxSteps(10_000));
        Unit unit = world.add(new Unit(mass));
        double momentum = 0, most = 0;
        for (Push push : pushes) {
            unit.applyImpulse(push.kick, 0);
            unit.applyForce(push.force, 0);
            world.advance(push.seconds());
            momentum += push.impulse();
            most = Math.max(most, Math.abs(push.kick) + Math.abs(push.force) * 2.0) + Math.abs(push.impulse());
            double error = mass * unit.getVx() + unit.getPendingImpulseX() - momentum;
            assertEquals(0, error, (world.getTick() + 10) * Math.ulp(most));
        }
    }

    /** Neither in total nor in a component, to the bit, at any stiffness and any dt. */
    @Property
    void frictionAloneNeverAddsEnergy(
            @ForAll Integrator integrator,
            @ForAll boolean alone,
            @ForAll("masses") double mass,
            @ForAll("stiffness") double stiffness,
            @ForAll("velocities") double vx,
            @ForAll("velocities") double vy,
            @ForAll("times") double dt) {
        Unit unit = new Unit(mass)
                .setFriction(Math.min(1e50, stiffness * mass / dt))
                .setVelocity(vx, vy);
        World world = new World(integrator, Timestep.variable(1));
        if (!alone) world.add(unit);
        for (int i = 0; i < 20; i++) {
            double wasX = unit.getVx(), wasY = unit.getVy(), speed = unit.getSpeed();
            if (alone) unit.integrate(dt, integrator);
            else world.step(dt);
            assertTrue(Math.abs(unit.getVx()) <= Math.abs(wasX) && Math.abs(unit.getVy()) <= Math.abs(wasY));
            assertTrue(unit.getSpeed() <= speed, () -> unit.getSpeed() + " m/s after " + speed);
        }
    }

    /**
     * The energy that a unit gains under a force is at most the work of that force, F Δx: friction's own work is never
     * positive. This does not hold for EULER and SEMI_IMPLICIT, which move by one of the two velocities, nor for
     * MIDPOINT above z = 2, where a step reaches the terminal speed.
     */
    @Property
    void withFrictionAUnitGainsNoMoreThanTheWorkOfTheForce(
            @ForAll boolean exact,
            @ForAll("masses") double mass,
            @ForAll("stiffness") double stiffness,
            @ForAll("velocities") double v,
            @ForAll("velocities") double terminal,
            @ForAll("times") double dt) {
        double z = exact ? stiffness : Math.min(stiffness, 2);
        Unit unit = new Unit(mass).setFriction(z * mass / dt).setVelocity(v, 0);
        double force = terminal * unit.getFriction();
        unit.applyForce(force, 0);
        unit.integrate(dt, exact ? Integrator.EXACT : Integrator.MIDPOINT);
        double before = mass / 2 * v * v, after = mass / 2 * unit.getVx() * unit.getVx(), work = force * unit.getX();
        double rounding = 1e-14 * (before + after + Math.abs(force * dt) * Math.max(Math.abs(v), Math.abs(terminal)));
        assertTrue(after - before <= work + rounding, () -> "gained " + (after - before) + " J by work of " + work);
    }

    @Provide
    Arbitrary<Double> masses() {
        return Doubles.logUniform(1e-3, 1e6);
    }

    @Provide
    Arbitrary<Double> stiffness() {
        return Arbitraries.oneOf(
                Doubles.logUniform(1e-18, 1e-12), Doubles.logUniform(1e-6, 1e4), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> velocities() {
        return Doubles.signedLogUniform(1e-6, 1e6);
    }

    @Provide
    Arbitrary<Double> times() {
        return Doubles.logUniform(1e-4, 10);
    }
}
