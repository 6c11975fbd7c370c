package yarts.physics.comparison;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.demo.Rule;

/**
 * Engines and brakes: reaching a velocity by a limited force, and stopping by dry friction. The motor of the library beside
 * the joints of the engines that Java games use, and beside rules that games write by hand. Measures tables of
 * docs/comparison.md.
 */
class MotorComparisonTest {
    private static final int[] TICK_RATES = {10, 20, 30, 60, 120, 240};

    /** Dry friction with a coefficient of 0.6 on 1 kg: from 10 m/s to rest in 1.70 s, within 8.49 m. */
    private static final double SPEED = 10, FRICTION = 0.6 * 9.81;

    private static final double TIME = SPEED / FRICTION, DISTANCE = SPEED * SPEED / (2 * FRICTION);

    /** The engine's force: from rest to 10 m/s in 1.43 s, within 7.14 m. */
    private static final double ENGINE = 7;

    /** The default of motor joints. */
    private static final double DEFAULT_CORRECTION = 0.3;

    private interface Attach {
        Engine.Drive to(Engine.Body body, double maxForce);
    }

    /** A way to drive a body of 1 kg, under its name. */
    private record Way(String name, Supplier<Engine> engine, Attach drive) {
        Run run(double friction, double v, double maxForce, double order, int ticksPerSecond) {
            Engine world = engine.get();
            Engine.Body body = world.add(1, friction, 0, v);
            Engine.Drive driven = drive.to(body, maxForce);
            driven.order(order);
            return new Run(world, body, driven, 1.0 / ticksPerSecond);
        }
    }

    private record Run(Engine world, Engine.Body body, Engine.Drive drive, double dt) {
        void step() {
            drive.beforeStep(dt);
            world.step(dt);
        }

        void steps(long n) {
            for (long i = 0; i < n; i++) step();
        }

        void seconds(double time) {
            steps(Math.round(time / dt));
        }

        double topIn(double time) {
            double top = 0;
            for (long i = Math.round(time / dt); i > 0; i--) {
                step();
                top = Math.max(top, body.v());
            }
            return top;
        }
    }

    private static final Supplier<Engine> BY_HAND = () -> Handwritten.of(Rule.PUSH_THEN_DAMP);

    /** R, towards the ordered velocity. */
    private static final Way NAIVE =
            new Way("by hand: R towards u", BY_HAND, (body, maxForce) -> new ByHand(body, maxForce, Double.MAX_VALUE));

    /** The force that reaches the ordered velocity in this step, but at most R. */
    private static final Way LIMITED =
            new Way("by hand: m·(u − v)/dt, at most R", BY_HAND, (body, maxForce) -> new ByHand(body, maxForce, 1));

    /** In each step a force of stiffness·m·(u − v)/dt, limited. The mass is 1 kg. */
    private static final class ByHand implements Engine.Drive {
        private final Engine.Body body;
        private final double maxForce, stiffness;
        private double velocity;

        ByHand(Engine.Body body, double maxForce, double stiffness) {
            this.body = body;
            this.maxForce = maxForce;
            this.stiffness = stiffness;
        }

        @Override
        public void order(double velocity) {
            this.velocity = velocity;
        }

        @Override
        public void beforeStep(double dt) {
            double force = (velocity - body.v()) / dt * stiffness;
            body.push(Math.max(-maxForce, Math.min(maxForce, force)));
        }
    }

    private static List<Way> joints() {
        Attach friction = Engine.Body::drive, motor = (body, maxForce) -> body.drive(maxForce, 0);
        return List.of(
                new Way("dyn4j: friction joint", MotorComparisonTest::dyn4j, friction),
                new Way("dyn4j: motor joint without correction", MotorComparisonTest::dyn4j, motor),
                new Way("JBox2D: friction joint", JBox2d::new, friction),
                new Way("gdx-box2d: friction joint", GdxBox2d::new, friction),
                new Way("gdx-box2d: motor joint without correction", GdxBox2d::new, motor));
    }

    /** Motor joints whose target the game moves. */
    private static List<Way> movingTargets(double correction) {
        Attach motor = (body, maxForce) -> body.drive(maxForce, correction);
        return List.of(
                new Way("dyn4j: motor joint with a moving target", MotorComparisonTest::dyn4j, motor),
                new Way("gdx-box2d: motor joint with a moving target", GdxBox2d::new, motor));
    }

    private static Engine dyn4j() {
        return new Dyn4j().withMaximumTranslation(1e9);
    }

    private static List<Way> ours() {
        List<Way> ways = new ArrayList<>();
        for (Integrator how : Integrator.values()) {
            ways.add(new Way("`setMotor`, `" + how + "`", () -> new Ours(how), Engine.Body::drive));
        }
        return ways;
    }

    @SafeVarargs
    private static List<Way> all(List<Way>... lists) {
        List<Way> all = new ArrayList<>();
        for (List<Way> list : lists) all.addAll(list);
        return all;
    }

    @BeforeEach
    void nativeBox2dIsThere() {
        GdxBox2d.assumeIsThere();
    }

    // An engine

    @Test
    void reachingAVelocityAgainstTickRate() {
        List<Way> ways = all(List.of(NAIVE, LIMITED), movingTargets(DEFAULT_CORRECTION), joints(), ours());
        perTickRate("engine", ways, way -> rate -> reached(way, rate));
    }

    /** The error of the distance covered in 3 s from rest; in words, if the velocity is not the ordered one from then on. */
    private static String reached(Way way, int rate) {
        Run run = way.run(0, 0, ENGINE, SPEED, rate);
        double top = run.topIn(3), x = run.body.x(), least = top;
        if (top > 1.1 * SPEED) return "oscillates around u";
        for (int i = 0; i < rate; i++) {
            run.step();
            least = Math.min(least, run.body.v());
            top = Math.max(top, run.body.v());
        }
        if (top - least > 1e-3) return "oscillates by " + Page.number(top - least, 2) + " m/s";
        return Page.error(x, SPEED * 3 - SPEED * SPEED / (2 * ENGINE));
    }

    @Test
    void aMotorJointWithAMovingTargetPassesTheOrderedVelocityByUpToAsMuchAgain() {
        for (Way way : all(movingTargets(DEFAULT_CORRECTION), movingTargets(1))) {
            for (int rate : TICK_RATES) {
                double top = way.run(0, 0, ENGINE, SPEED, rate).topIn(10);
                assertTrue(top > 1.5 * SPEED && top <= 2 * SPEED, way.name + " at " + rate + ": " + top);
            }
        }
    }

    /** With linear friction, the engine can reach 5 m/s; 10 m/s are ordered. */
    @Test
    void anEngineTooWeakForTheOrderAgainstTickRate() {
        perTickRate("engine-with-friction", all(List.of(LIMITED), joints(), ours()), way -> rate -> {
            Run run = way.run(10, 0, 50, SPEED, rate);
            run.seconds(20);
            return Page.error(run.body.v(), 5);
        });
    }

    @Test
    void jointsAndTheMotorKeepTheOrderedVelocityExactlyAgainstFriction() {
        for (Way way : all(joints(), ours())) {
            for (int rate : TICK_RATES) {
                Run run = way.run(10, 0, 50, 4, rate);
                run.seconds(20);
                assertEquals(4, run.body.v(), way.name + " at " + rate);
            }
        }
    }

    // Brakes

    /** Whether it is at rest, give or take the rounding errors of an engine with floats. */
    private static boolean isAtRest(Engine.Body body) {
        return Math.abs(body.v()) < 1e-4;
    }

    private static Run braking(Way way, int rate) {
        return way.run(0, SPEED, FRICTION, 0, rate);
    }

    @Test
    void stoppingDistanceAgainstTickRate() {
        perTickRate("stopping-distance", all(List.of(NAIVE, LIMITED), joints(), ours()), way -> rate -> {
            Run run = braking(way, rate);
            run.seconds(10);
            return isAtRest(run.body) ? Page.error(run.body.x(), DISTANCE) : "never stops";
        });
    }

    @Test
    void stoppingTakesTheTimeAndTheDistanceOfTheClosedFormToWithinAStep() {
        for (Way way : all(List.of(LIMITED), joints(), ours())) {
            for (int rate : TICK_RATES) {
                String name = way.name + " at " + rate;
                Run run = braking(way, rate);
                run.steps((long) (TIME * rate));
                assertTrue(run.body.v() > 0, name);
                run.step();
                assertTrue(isAtRest(run.body), name);
                assertEquals(DISTANCE, run.body.x(), SPEED * run.dt, name);
            }
        }
    }

    @Test
    void atRest() {
        Map<String, List<String>> rows = new LinkedHashMap<>();
        for (Way way : all(List.of(NAIVE, LIMITED), joints(), ours())) {
            Run run = braking(way, 60);
            int reversals = 0;
            for (int i = 0; i < 600; i++) {
                double before = run.body.v();
                run.step();
                if (before * run.body.v() < -1e-6) reversals++;
            }
            double rest = run.body.v();
            rows.put(
                    way.name,
                    List.of(
                            reversals == 0 ? "no" : reversals + " times",
                            rest == 0 ? "exactly 0" : Page.number(Math.abs(rest)),
                            Page.number(pushed(run, 0.9).x, 2) + " m",
                            Page.error(pushed(braking(way, 60), 1.1).v, 0.1 * FRICTION * 10)));
        }
        List<String> head = List.of("", "reverses", "speed after 10 s", "0.9 R moves it by", "1.1 R: error of v");
        Page.check("at-rest", head, rows);
    }

    private record Pushed(double x, double v) {}

    /** Lets a body brake for 10 s, and then pushes it by a part of the brake's force for 10 s. */
    private static Pushed pushed(Run run, double part) {
        run.seconds(10);
        double x = run.body.x();
        for (int i = 0; i < 600; i++) {
            run.body.push(part * FRICTION);
            run.step();
        }
        return new Pushed(run.body.x() - x, run.body.v());
    }

    private static void perTickRate(String name, List<Way> ways, Function<Way, IntFunction<String>> cell) {
        List<String> head = new ArrayList<>(List.of("ticks per second:"));
        IntStream.of(TICK_RATES).mapToObj(String::valueOf).forEach(head::add);
        Map<String, List<String>> rows = new LinkedHashMap<>();
        for (Way way : ways) {
            rows.put(
                    way.name, IntStream.of(TICK_RATES).mapToObj(cell.apply(way)).toList());
        }
        Page.check(name, head, rows);
    }
}
