package yarts.physics.comparison;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.Serializable;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.dyn4j.Version;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.World;

/** What the engines are, accept and save. Measures tables of docs/comparison.md. */
class StateComparisonTest {
    private static final int SCENES = 12;

    @TempDir
    Path folder;

    @BeforeEach
    void nativeBox2dIsThere() {
        GdxBox2d.assumeIsThere();
    }

    @Test
    void whatIsCompared() throws IOException {
        Map<String, List<String>> rows = new LinkedHashMap<>();
        rows.put("[dyn4j](https://dyn4j.org)", List.of(Version.getVersion(), "Java", stateOf(new Dyn4j())));
        rows.put(
                "[JBox2D](https://github.com/jbox2d/jbox2d)",
                List.of(versionInPom("jbox2d.version"), "Java, a port of Box2D 2.2", stateOf(new JBox2d())));
        rows.put(
                "[gdx-box2d](https://libgdx.com/wiki/extensions/physics/box2d)",
                List.of(com.badlogic.gdx.Version.VERSION, "Box2D 2.3 in C++, by JNI", stateOf(new GdxBox2d())));
        rows.put("yarts-physics", List.of("this version", "Java", stateOf(new Ours(Integrator.EXACT))));
        Page.check("engines", List.of("", "version", "written in", "state in"), rows);
    }

    private static String stateOf(Engine engine) {
        return "`" + (engine.add(1, 0, 0, 0.1).v() == 0.1 ? "double" : "float") + "`";
    }

    private static String versionInPom(String property) throws IOException {
        return Files.readString(Path.of("pom.xml")).split("</?" + property + ">")[1];
    }

    @Test
    void badNumbers() throws Exception {
        assumeTrue(System.getProperty("os.name").equals("Linux"), "native assertions may be built otherwise elsewhere");
        Map<String, List<String>> rows = new LinkedHashMap<>();
        for (Poison poison : Poison.values()) {
            rows.put(
                    poison.label,
                    List.of(
                            poison.in(Dyn4j::new),
                            poison.in(JBox2d::new),
                            poison.inGdxBox2d(folder),
                            poison.in(() -> new Ours(Integrator.EXACT))));
        }
        Page.check("bad-numbers", List.of("", "dyn4j", "JBox2D", "gdx-box2d", "yarts-physics"), rows);
    }

    @Test
    void savedFromWhatTheGettersTell() {
        Map<String, List<String>> rows = new LinkedHashMap<>();
        Map<String, Supplier<Engine>> peers = new LinkedHashMap<>();
        peers.put("dyn4j", Dyn4j::new);
        peers.put("JBox2D", JBox2d::new);
        peers.put("gdx-box2d", GdxBox2d::new);
        peers.forEach((name, peer) -> rows.put(name, List.of(rebuilt(peer, 4), rebuilt(peer, 0.9))));
        rows.put("yarts-physics, by `Snapshot`", List.of(restored(), "has no contacts"));
        Page.check("saving", List.of("", "bodies apart", "bodies in contact"), rows);
    }

    /** Scenes of three bodies that are pushed together, from so far apart on; a new world is built half way. */
    private static String rebuilt(Supplier<Engine> maker, double apart) {
        int same = 0;
        for (int scene = 0; scene < SCENES; scene++) {
            Engine engine = maker.get(), copy = maker.get();
            List<Engine.Body> bodies = scene(engine, apart + 0.05 * scene), copies = new ArrayList<>();
            run(engine, bodies);
            for (Engine.Body body : bodies) copies.add(copy.add(1 + copies.size(), 0.3, body.x(), body.v()));
            run(engine, bodies);
            run(copy, copies);
            if (positions(bodies).equals(positions(copies))) same++;
        }
        return same == SCENES ? "same bits" : "not always the same bits";
    }

    private static String restored() {
        int same = 0;
        for (int scene = 0; scene < SCENES; scene++) {
            Ours engine = new Ours(Integrator.EXACT), copy = new Ours(Integrator.EXACT);
            List<Engine.Body> bodies = scene(engine, 4 + 0.05 * scene), copies = scene(copy, 0);
            run(engine, bodies);
            copy.world.restore(Snapshot.fromBytes(engine.world.save().toBytes()));
            run(engine, bodies);
            run(copy, copies);
            if (engine.world.stateHash() == copy.world.stateHash()) same++;
        }
        return same == SCENES ? "same bits" : "not always the same bits";
    }

    private static List<Engine.Body> scene(Engine engine, double apart) {
        List<Engine.Body> bodies = new ArrayList<>();
        for (int i = 0; i < 3; i++) bodies.add(engine.add(1 + i, 0.3, i * apart, 0));
        return bodies;
    }

    private static void run(Engine engine, List<Engine.Body> bodies) {
        for (int i = 0; i < 100; i++) {
            bodies.get(0).push(0.7);
            bodies.get(2).push(-0.5);
            engine.step(Loop.TICK);
        }
    }

    private static List<Double> positions(List<Engine.Body> bodies) {
        return bodies.stream().map(Engine.Body::x).toList();
    }

    @Test
    void noPeersWorldHasACallThatSavesIt() {
        for (Class<?> world : List.of(
                org.dyn4j.world.World.class,
                org.jbox2d.dynamics.World.class,
                com.badlogic.gdx.physics.box2d.World.class)) {
            assertFalse(Serializable.class.isAssignableFrom(world), world.getName());
            for (Method method : world.getMethods()) {
                assertFalse(
                        method.getName().matches("(?i).*(save|restore|snapshot|serial|copy|write).*"),
                        method::toString);
            }
        }
    }

    @Test
    void nativeBox2dLeavesJavasArithmeticAsItIs() {
        new GdxBox2d().step(Loop.TICK);
        assertDoesNotThrow(World::checkArithmetic);
    }
}
