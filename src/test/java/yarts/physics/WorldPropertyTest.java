package yarts.physics;

import java.util.function.BiConsumer;
import java.util.function.Consumer;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.Tuple;
import net.jqwik.api.state.Action;
import net.jqwik.api.state.ActionChain;
import net.jqwik.api.state.ActionChainArbitrary;
import net.jqwik.api.state.Transformer;

/** A world does to its units what each would do alone, to the bit, after any history. The model is in {@link Twins}. */
class WorldPropertyTest {
    @Property(tries = 1500)
    void aWorldEqualsItsUnitsSteppedAlone(@ForAll("histories") ActionChain<Twins> history) {
        history.withInvariant("every getter, to the bit", Twins::compare).run();
    }

    @Property(tries = 20_000)
    @Tag("long")
    void aWorldEqualsItsUnitsSteppedAloneAtLength(@ForAll("histories") ActionChain<Twins> history) {
        aWorldEqualsItsUnitsSteppedAlone(history);
    }

    @Provide
    ActionChainArbitrary<Twins> histories() {
        Arbitrary<Integer> pick = Arbitraries.integers().between(0, 400);
        Arbitrary<Integer> crowd =
                Arbitraries.frequencyOf(Tuple.of(9, Arbitraries.integers().between(1, 20)), Tuple.of(1, pick));
        Arbitrary<Integrator> integrators = Arbitraries.of(Integrator.class);
        return ActionChain.startWith(Twins::new)
                .withAction(3, (Action.Independent<Twins>) () -> Combinators.combine(integrators, timesteps())
                        .as((how, timestep) -> mutate(how + " " + timestep, t -> t.move(how, timestep))))
                .withAction(6, (Action.Independent<Twins>) () -> Combinators.combine(crowd, masses(), frictions())
                        .as((n, mass, friction) ->
                                mutate("add " + n + " of mass " + mass + ", friction " + friction, t -> {
                                    for (int i = 0; i < n; i++) t.addNew(mass, friction / (1 + i));
                                })))
                .withAction(2, with("add again", pick, Twins::add))
                .withAction(3, with("remove", pick, Twins::remove))
                .withAction(1, with("remove all heavier than", masses(), Twins::removeHeavierThan))
                .withAction(1, with("clear forces of", pick, Twins::clearForces))
                .withAction(1, with("clear, after", pick.map(i -> i / 100), (t, i) -> t.clear()))
                .withAction(2, unit("set mass", masses(), (u, v) -> u.setMass(v)))
                .withAction(2, unit("set friction", frictions(), (u, v) -> u.setFriction(v)))
                .withAction(2, unit("set top speed", topSpeeds(), (u, v) -> u.setMaxSpeed(v)))
                .withAction(3, unit("set velocity", vectors(velocities()), (u, v) -> u.setVelocity(v.get1(), v.get2())))
                .withAction(3, unit("impulse", vectors(forces()), (u, v) -> u.applyImpulse(v.get1(), v.get2())))
                .withAction(6, unit("force", vectors(forces()), (u, v) -> u.applyForce(v.get1(), v.get2())))
                .withAction(2, (Action.Independent<Twins>) () -> Combinators.combine(pick, velocities(), velocities())
                        .as((i, x, y) -> mutate("put " + i + " at " + x + ", " + y, t -> t.teleport(i, x, y))))
                .withAction(2, (Action.Independent<Twins>) () -> Combinators.combine(pick, times(), integrators)
                        .as((i, dt, h) -> mutate("integrate " + i + " " + dt + " " + h, t -> t.integrateOne(i, dt, h))))
                .withAction(4, with("step", times(), Twins::step))
                .withAction(8, with("advance, ns", nanoseconds(), Twins::advance));
    }

    private static Arbitrary<Timestep> timesteps() {
        Arbitrary<Timestep> fixed =
                Arbitraries.of(60, 1, 30, 64, 144, 1_000_000).map(Timestep::fixed);
        Arbitrary<Timestep> variable = Doubles.logUniform(1e-3, 10).map(Timestep::variable);
        return Combinators.combine(
                        mostly(fixed, variable), Arbitraries.integers().between(1, 8))
                .as(Timestep::withMaxSteps);
    }

    private static <A> Action<Twins> with(String what, Arbitrary<A> argument, BiConsumer<Twins, A> action) {
        return (Action.Independent<Twins>) () ->
                argument.map(a -> mutate(what + " " + a, twins -> action.accept(twins, a)));
    }

    private static <A> Action<Twins> unit(String what, Arbitrary<A> argument, BiConsumer<Unit, A> change) {
        return (Action.Independent<Twins>) () -> Combinators.combine(
                        Arbitraries.integers().between(0, 400), argument)
                .as((i, a) -> mutate(what + " of " + i + ": " + a, twins -> twins.change(i, u -> change.accept(u, a))));
    }

    private static Transformer<Twins> mutate(String what, Consumer<Twins> action) {
        return Transformer.mutate(what, action);
    }

    private static Arbitrary<Tuple.Tuple2<Double, Double>> vectors(Arbitrary<Double> components) {
        return Combinators.combine(components, components).as(Tuple::of);
    }

    private static Arbitrary<Double> masses() {
        return mostly(Doubles.logUniform(1e-3, 1e6), Doubles.logUniform(1e-50, 1e50));
    }

    private static Arbitrary<Double> frictions() {
        return mostly(mostly(Doubles.logUniform(1e-3, 1e6), Arbitraries.just(0.0)), Doubles.logUniform(0, 1e50));
    }

    private static Arbitrary<Double> topSpeeds() {
        Arbitrary<Double> any = Doubles.logUniform(0, Double.POSITIVE_INFINITY);
        return mostly(Doubles.logUniform(1e-3, 1e3), mostly(any, Arbitraries.of(0.0, Double.POSITIVE_INFINITY)));
    }

    private static Arbitrary<Double> velocities() {
        return mostly(Doubles.signedLogUniform(1e-3, 1e3), Doubles.finite());
    }

    /** Below 1e50, so that a frame's force, which may hold what several frames carried, stays an accepted one. */
    private static Arbitrary<Double> forces() {
        return mostly(Doubles.signedLogUniform(1e-3, 1e6), Doubles.signedLogUniform(1e-38, 1e38));
    }

    private static Arbitrary<Double> times() {
        return mostly(mostly(Doubles.logUniform(1e-4, 1), Arbitraries.of(0.0, 1 / 60.0)), Doubles.logUniform(0, 1e9));
    }

    private static Arbitrary<Long> nanoseconds() {
        return mostly(Doubles.logUniform(1e5, 2e9).map(Math::round), Arbitraries.of(0L, 1L, 16_666_666L, 16_666_667L));
    }

    private static <T> Arbitrary<T> mostly(Arbitrary<T> usual, Arbitrary<T> unusual) {
        return Arbitraries.frequencyOf(Tuple.of(3, usual), Tuple.of(1, unusual));
    }
}
