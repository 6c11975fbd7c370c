package yarts.physics.comparison;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.demo.Rule;

/**
 * Friction and caps: the library beside the engines that Java games use, and beside rules that games write by hand.
 * Measures tables of docs/comparison.md.
 */
class FrictionComparisonTest {
    private static final double[] Z = {0.1, 0.5, 1, 1.5, 2, 2.5, 10};
    private static final int[] TICK_RATES = {5, 10, 20, 30, 60, 120, 240};

    /** 1 kg, 10 N·s/m and 50 N: the terminal speed is 5 m/s, and the response time 0.1 s. */
    private static final double FRICTION = 10, FORCE = 50, TERMINAL = FORCE / FRICTION;

    /** An engine under its name. */
    private record Entry(String name, Supplier<Engine> engine) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static List<Entry> rules() {
        return List.of(
                new Entry("naive", Handwritten::naive),
                new Entry("explicit midpoint", Handwritten::explicitMidpoint),
                new Entry("push, then damp", () -> Handwritten.of(Rule.PUSH_THEN_DAMP)),
                new Entry("damp, then push", () -> Handwritten.of(Rule.DAMP_THEN_PUSH)));
    }

    /** dyn4j without its cap of 2 m a step, which JBox2D and gdx-box2d have as a constant. */
    static List<Entry> peersThatDampLast() {
        return List.of(
                new Entry("dyn4j", () -> new Dyn4j().withMaximumTranslation(1e9)), new Entry("JBox2D", JBox2d::new));
    }

    private static final Entry GDX_BOX2D = new Entry("gdx-box2d", GdxBox2d::new);

    private static List<Entry> ours() {
        List<Entry> entries = new ArrayList<>();
        for (Integrator how : Integrator.values()) entries.add(new Entry("`" + how + "`", () -> new Ours(how)));
        return entries;
    }

    private static List<Entry> all() {
        List<Entry> all = new ArrayList<>(rules());
        all.addAll(peersThatDampLast());
        all.add(GDX_BOX2D);
        all.addAll(ours());
        return all;
    }

    @BeforeEach
    void nativeBox2dIsThere() {
        GdxBox2d.assumeIsThere();
    }

    // Friction

    @Test
    void coastingAtEveryZ() {
        table("coasting", "no force, z =", Z, all(), entry -> z -> coasting(entry, z));
    }

    /** In words: what ten steps do to a body that coasts at 1 m/s, and its velocity after the first. */
    private static String coasting(Entry entry, double z) {
        double dt = Loop.TICK;
        Engine engine = entry.engine.get();
        Engine.Body body = engine.add(1, z / dt, 0, 1);
        double first = 0, last = 1;
        boolean flips = false;
        for (int i = 0; i < 10; i++) {
            double before = last;
            engine.step(dt);
            last = body.v();
            if (i == 0) first = last;
            flips |= before * last < 0;
        }
        double size = Math.abs(last);
        String fate = size > 1.001 ? "grows" : size > 0.999 ? "never slows" : first == 0 ? "stops" : "slows";
        String words = !flips ? fate : fate.equals("slows") ? "flips" : "flips, " + fate;
        return words + ": " + Page.number(first);
    }

    @Test
    void pushedAtEveryZ() {
        table("pushed", "force F, z =", Z, all(), entry -> z -> pushed(entry, z));
    }

    /** In words: where a steady push of F leads a body from rest, if F/f is 1 m/s. */
    private static String pushed(Entry entry, double z) {
        double dt = Loop.TICK, friction = z / dt;
        Engine engine = entry.engine.get();
        Engine.Body body = engine.add(1, friction, 0, 0);
        double before = 0, last = 0, top = 0;
        for (int i = 0; i < 1500; i++) {
            before = last;
            body.push(friction);
            engine.step(dt);
            last = body.v();
            top = Math.max(top, last);
        }
        if (!(Math.abs(last) < 1e6)) return "grows";
        if (Math.abs(last - before) > 1e-3) {
            return "oscillates, " + Page.number(Math.min(before, last)) + " to " + Page.number(Math.max(before, last));
        }
        if (Math.abs(last) < 1e-6) return "freezes: 0";
        if (Math.abs(last - 1) > 1e-4) return (last > 1 ? "overshoots: " : "falls short: ") + Page.number(last);
        return top > 1.0001 ? "oscillates up to " + Page.number(top) + ", then 1" : "1";
    }

    @Test
    void terminalSpeedAgainstTickRate() {
        perTickRate("terminal-speed", this::terminalSpeed);
    }

    private String terminalSpeed(Entry entry, int rate) {
        double dt = 1.0 / rate, before = 0, last = 0;
        Engine engine = entry.engine.get();
        Engine.Body body = engine.add(1, FRICTION, 0, 0);
        for (int i = 0; i < 1500; i++) {
            before = last;
            body.push(FORCE);
            engine.step(dt);
            last = body.v();
        }
        return Math.abs(last - before) > 1e-3 ? "oscillates" : Page.error(last, TERMINAL);
    }

    @Test
    void coastingDistanceAgainstTickRate() {
        perTickRate("distance", (entry, rate) -> {
            double dt = 1.0 / rate, expected = TERMINAL / FRICTION;
            Engine engine = entry.engine.get();
            Engine.Body body = engine.add(1, FRICTION, 0, TERMINAL);
            for (int i = 0; i < 1500; i++) engine.step(dt);
            return Math.abs(body.v()) > 1e-3 ? "never stops" : Page.error(body.x(), expected);
        });
    }

    @Test
    void wayFromRestAgainstTickRate() {
        perTickRate("way", (entry, rate) -> {
            double response = 1 / FRICTION, time = 2 * response;
            Engine engine = entry.engine.get();
            Engine.Body body = engine.add(1, FRICTION, 0, 0);
            for (int i = 0; i < Math.round(time * rate); i++) {
                body.push(FORCE);
                engine.step(1.0 / rate);
            }
            return Page.error(body.x(), TERMINAL * (time - response * (1 - Math.exp(-time / response))));
        });
    }

    private interface PerRate {
        String measure(Entry entry, int rate);
    }

    private static void perTickRate(String name, PerRate cell) {
        double[] rates = IntStream.of(TICK_RATES).asDoubleStream().toArray();
        table(name, "ticks per second:", rates, all(), entry -> rate -> cell.measure(entry, (int) rate));
    }

    // The cap

    @Test
    void capAgainstTickRate() {
        List<Entry> capped = List.of(
                new Entry("dyn4j, by default", Dyn4j::new),
                new Entry("JBox2D", JBox2d::new),
                GDX_BOX2D,
                new Entry("dyn4j, `setMaximumTranslation(0.25)`", () -> new Dyn4j().withMaximumTranslation(0.25)),
                new Entry("`setMaxSpeed(15)`", () -> new Ours(Integrator.EXACT, 15)));
        double[] rates = {15, 30, 60, 120, 240};
        table("cap", "ticks per second:", rates, capped, entry -> rate -> {
            Engine engine = entry.engine.get();
            Engine.Body body = engine.add(1, 0, 0, 0);
            for (int i = 0; i < 2 * rate; i++) {
                body.push(1e5);
                engine.step(1 / rate);
            }
            return Page.number(body.v());
        });
    }

    // What the page and docs/jitters.md say of the engines' rules, as formulas

    @ParameterizedTest
    @MethodSource("peersThatDampLast")
    void aPeersTerminalSpeedDependsOnTheTickRate(Entry peer) {
        for (double dt : new double[] {1 / 240.0, 1 / 120.0, 1 / 60.0, 1 / 20.0}) {
            double z = FRICTION * dt;
            assertEquals((1 - z) * TERMINAL, push(peer, dt, 5000), 1e-4, "z = " + z);
        }
    }

    @ParameterizedTest
    @MethodSource("peersThatDampLast")
    void aPeerFreezesAThrustingUnitFromZOneOn(Entry peer) {
        for (double dt : new double[] {0.1, 0.2, 0.5}) assertEquals(0, push(peer, dt, 100), 1e-5, "dt = " + dt);
    }

    @Test
    void nativeBox2dDividesByOnePlusZAndReachesTheTerminalSpeed() {
        for (double dt : new double[] {1 / 240.0, 1 / 60.0, 1 / 20.0, 0.1, 0.2}) {
            double z = FRICTION * dt;
            assertEquals(FORCE * dt / (1 + z), push(GDX_BOX2D, dt, 1), 1e-5, "z = " + z);
            assertEquals(TERMINAL, push(GDX_BOX2D, dt, 5000), 1e-4, "z = " + z);
        }
    }

    @ParameterizedTest
    @EnumSource
    void oursIsForceOverFrictionAtEveryTickRate(Integrator integrator) {
        Entry ours = new Entry("", () -> new Ours(integrator));
        for (double dt : new double[] {1 / 240.0, 1 / 120.0, 1 / 60.0, 1 / 20.0, 0.1, 0.2, 0.5, 10}) {
            assertEquals(TERMINAL, push(ours, dt, 5000), 1e-11, "dt = " + dt);
        }
    }

    /** A spring of 10 rad/s, computed before each step, from 1 m: the new velocity moves a body in all engines. */
    @Test
    void aSpringGainsNoEnergyInThePeersAndUnderSemiImplicit() {
        List<Entry> entries = new ArrayList<>(peersThatDampLast());
        entries.add(GDX_BOX2D);
        int peers = entries.size();
        entries.addAll(ours());
        for (int k = 0; k < entries.size(); k++) {
            Entry entry = entries.get(k);
            Engine engine = entry.engine.get();
            Engine.Body body = engine.add(1, 0, 1, 0);
            double swing = 0;
            for (int i = 0; i < 6000; i++) {
                body.push(-100 * body.x());
                engine.step(Loop.TICK);
                if (Math.abs(body.x()) > 10) break;
                swing = Math.max(swing, Math.abs(body.x()));
            }
            boolean keeps = k < peers || entry.name.equals("`SEMI_IMPLICIT`");
            if (keeps) assertEquals(1 / Math.sqrt(1 - 1 / 144.0), swing, 1e-3, entry.name);
            else assertTrue(swing > 9, entry.name + ": " + swing);
        }
    }

    @Test
    void atHighTickRatesAllAgree() {
        double dt = 1e-4;
        int steps = 1000; // 0.1 s, in which v gets to 63 % of F/f
        double exact = TERMINAL * (1 - Math.exp(-1));
        for (Entry entry : all()) assertEquals(exact, push(entry, dt, steps), TERMINAL * FRICTION * dt, entry.name);
    }

    private static double push(Entry entry, double dt, int steps) {
        Engine engine = entry.engine.get();
        Engine.Body body = engine.add(1, FRICTION, 0, 0);
        for (int i = 0; i < steps; i++) {
            body.push(FORCE);
            engine.step(dt);
        }
        return body.v();
    }

    private static void table(
            String name,
            String corner,
            double[] columns,
            List<Entry> entries,
            Function<Entry, DoubleFunction<String>> cell) {
        List<String> head = new ArrayList<>(List.of(corner));
        DoubleStream.of(columns).mapToObj(Page::number).forEach(head::add);
        Map<String, List<String>> rows = new LinkedHashMap<>();
        for (Entry entry : entries) {
            rows.put(
                    entry.name,
                    DoubleStream.of(columns).mapToObj(cell.apply(entry)).toList());
        }
        Page.check(name, head, rows);
    }
}
