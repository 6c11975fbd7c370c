package yarts.physics.world;

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
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Unit;
import yarts.physics.support.Doubles;

/** Units move in a world as they move alone, to the bit, after any calls. The model is {@link Twins}. */
class WorldPropertyTest {
    @Property(tries = 1500)
    void unitsMoveInAWorldAsAlone(@ForAll("histories") ActionChain<Twins> history) {
        history.withInvariant("every getter, to the bit", Twins::compare).run();
    }

    @Property(tries = 10_000)
    @Tag("long")
    void unitsMoveInAWorldAsAloneAfterLongHistories(@ForAll("longHistories") ActionChain<Twins> history) {
        unitsMoveInAWorldAsAlone(history);
    }

    @Provide
    ActionChainArbitrary<Twins> histories() {
        return histories(crowd(300)).withMaxTransformations(32);
    }

    /** With as few crowds in a chain as in the shorter ones. */
    @Provide
    ActionChainArbitrary<Twins> longHistories() {
        return histories(crowd(3000)).withMaxTransformations(200);
    }

    private static ActionChainArbitrary<Twins> histories(Arbitrary<Integer> crowds) {
        Arbitrary<Integer> pick = pick();
        Arbitrary<Integrator> integrators = Arbitraries.of(Integrator.class);
        return ActionChain.startWith(Twins::new)
                .withAction(3, (Action.Independent<Twins>) () -> Combinators.combine(integrators, paces())
                        .as((integrator, pace) ->
                                mutate("world: " + integrator + " " + pace, t -> t.move(integrator, pace))))
                .withAction(2, with("set integrator", integrators, Twins::setIntegrator))
                .withAction(2, with("set timestep", paces(), Twins::setPace))
                .withAction(6, (Action.Independent<Twins>) () -> Combinators.combine(crowds, masses(), frictions())
                        .as((n, mass, friction) ->
                                mutate("add " + n + " of mass " + mass + ", friction " + friction, t -> {
                                    for (int i = 0; i < n; i++) t.addNew(mass, friction / (1 + i));
                                })))
                .withAction(2, with("add again", pick, Twins::add))
                .withAction(3, with("remove", pick, Twins::remove))
                .withAction(1, with("remove all heavier than", masses(), Twins::removeHeavierThan))
                .withAction(1, with("remove if heavier than", masses(), Twins::removeIfHeavierThan))
                .withAction(3, with("save, after", pick, (t, i) -> t.save()))
                .withAction(3, with("restore", pick, Twins::restore))
                .withAction(2, with("load", pick, Twins::load))
                .withAction(2, with("find", pick, Twins::find))
                .withAction(1, with("invalid calls", pick, Twins::makeInvalidCalls))
                .withAction(1, with("pool", Arbitraries.of(true, false), Twins::setPool))
                .withAction(2, with("freeze", pick, (t, i) -> t.setFrozen(i, true)))
                .withAction(2, with("let go", pick, (t, i) -> t.setFrozen(i, false)))
                .withAction(1, with("clear forces of", pick, Twins::clearForces))
                .withAction(1, with("clear, after", pick.map(i -> i / 100), (t, i) -> t.clear()))
                .withAction(2, unit("set mass", masses(), (u, v) -> u.setMass(v)))
                .withAction(2, unit("set friction", frictions(), (u, v) -> u.setFriction(v)))
                .withAction(2, unit("set top speed", topSpeeds(), (u, v) -> u.setMaxSpeed(v)))
                .withAction(3, unit("set velocity", vectors(velocities()), (u, v) -> u.setVelocity(v.get1(), v.get2())))
                .withAction(2, unit("motor", motors(), (u, v) -> u.setMotor(v.get1(), v.get2(), v.get3())))
                .withAction(3, unit("impulse", vectors(forces()), (u, v) -> u.applyImpulse(v.get1(), v.get2())))
                .withAction(6, unit("force", vectors(forces()), (u, v) -> u.applyForce(v.get1(), v.get2())))
                .withAction(2, (Action.Independent<Twins>) () -> Combinators.combine(pick, velocities(), velocities())
                        .as((i, x, y) -> mutate("put " + i + " at " + x + ", " + y, t -> t.teleport(i, x, y))))
                .withAction(2, (Action.Independent<Twins>) () -> Combinators.combine(pick, velocities(), velocities())
                        .as((i, x, y) -> mutate("move " + i + " to " + x + ", " + y, t -> t.moveTo(i, x, y))))
                .withAction(2, with("change listeners", pick, Twins::changeListeners))
                .withAction(2, (Action.Independent<Twins>) () -> Combinators.combine(pick, times(), integrators)
                        .as((i, dt, h) -> mutate("integrate " + i + " " + dt + " " + h, t -> t.integrateOne(i, dt, h))))
                .withAction(3, with("forces", vectors(forces()), (t, v) -> t.applyForces(v.get1(), v.get2())))
                .withAction(4, with("step", times(), Twins::step))
                .withAction(2, with("step of the timestep, after", pick, (t, i) -> t.step()))
                .withAction(8, with("advance, ns", nanoseconds(), Twins::advance))
                .withAction(6, (Action.Independent<Twins>) () -> Combinators.combine(
                                nanoseconds(), Arbitraries.longs().between(0, 1 << 20))
                        .as((ns, seed) -> mutate(
                                "advance, ns " + ns + ", with orders " + seed, t -> t.advanceWithOrders(ns, seed))));
    }

    /** Indices in a few tiles, often in the first rows. */
    private static Arbitrary<Integer> pick() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, Arbitraries.integers().between(0, 40)),
                Tuple.of(1, Arbitraries.integers().between(0, 3 * Tiles.TILE)));
    }

    /** A few units, and sometimes as many as one or several tiles have, or one more or fewer. */
    private static Arbitrary<Integer> crowd(int handfuls) {
        return Arbitraries.frequencyOf(
                Tuple.of(handfuls, Arbitraries.integers().between(1, 20)),
                Tuple.of(30, Arbitraries.integers().between(Tiles.TILE - 2, Tiles.TILE + 2)),
                Tuple.of(1, Arbitraries.integers().between(3 * Tiles.TILE - 2, 3 * Tiles.TILE + 2)));
    }

    private static Arbitrary<Pace> paces() {
        Arbitrary<Integer> maxSteps = Arbitraries.integers().between(1, 8);
        Arbitrary<Pace> fixed = Combinators.combine(Arbitraries.of(60, 1, 30, 64, 144, 1_000_000), maxSteps)
                .as(Pace::fixed);
        Arbitrary<Pace> variable =
                Combinators.combine(Doubles.logUniform(1e-3, 10), maxSteps).as(Pace::variable);
        return mostly(fixed, variable);
    }

    private static <A> Action<Twins> with(String what, Arbitrary<A> argument, BiConsumer<Twins, A> action) {
        return (Action.Independent<Twins>) () ->
                argument.map(a -> mutate(what + " " + a, twins -> action.accept(twins, a)));
    }

    private static <A> Action<Twins> unit(String what, Arbitrary<A> argument, BiConsumer<Unit, A> change) {
        return (Action.Independent<Twins>) () -> Combinators.combine(pick(), argument)
                .as((i, a) -> mutate(what + " of " + i + ": " + a, twins -> twins.change(i, u -> change.accept(u, a))));
    }

    private static Transformer<Twins> mutate(String what, Consumer<Twins> action) {
        return Transformer.mutate(what, action);
    }

    private static Arbitrary<Tuple.Tuple2<Double, Double>> vectors(Arbitrary<Double> components) {
        return Combinators.combine(components, components).as(Tuple::of);
    }

    /** Motors that drive, brake, or are off. */
    private static Arbitrary<Tuple.Tuple3<Double, Double, Double>> motors() {
        Arbitrary<Double> zero = Arbitraries.just(0.0), velocity = mostly(velocities(), zero);
        Arbitrary<Double> force = mostly(Doubles.logUniform(1e-3, 1e6), mostly(Doubles.logUniform(0, 1e50), zero));
        return Combinators.combine(velocity, velocity, force).as(Tuple::of);
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

    /**
     * Below 1e50, so that the force of a frame, which may include impulses of several frames, stays within the limit.
     */
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
