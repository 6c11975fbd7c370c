package yarts.physics.comparison;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.function.Supplier;

/** What a bad number does to an engine. */
enum Poison {
    FORCE_NAN("`applyForce(NaN, 0)`") {
        @Override
        String give(Engine engine) {
            return bodyAndOthers(engine, body(engine, 0), Double.NaN);
        }
    },
    FORCE_INFINITE("`applyForce(∞, 0)`") {
        @Override
        String give(Engine engine) {
            return bodyAndOthers(engine, body(engine, 0), Double.POSITIVE_INFINITY);
        }
    },
    VELOCITY_NAN("a new body with v = NaN") {
        @Override
        String give(Engine engine) {
            return bodyAndOthers(engine, body(engine, Double.NaN), 0);
        }
    },
    MASS_ZERO("a mass of 0") {
        @Override
        String give(Engine engine) {
            Engine.Body body = engine.add(0, 0, 0, 0);
            body.push(1);
            engine.step(1);
            return body.v() == 0 ? "no force moves it" : "counts as " + Page.number(1 / body.v()) + " kg";
        }
    },
    STEP_NAN("a step of NaN s") {
        @Override
        String give(Engine engine) {
            Engine.Body body = body(engine, 1);
            engine.step(Double.NaN);
            return body.x() == 0 ? "nothing moves" : Double.isNaN(body.x()) ? "every position is NaN" : "moves";
        }
    };

    private static final String STARTED = "started ";

    final String label;

    Poison(String label) {
        this.label = label;
    }

    abstract String give(Engine engine);

    private static Engine.Body body(Engine engine, double v) {
        return engine.add(1, 0, 0, v);
    }

    /** Pushes a body, and watches it, one far away, and two that should meet and part, in the same world. */
    private static String bodyAndOthers(Engine engine, Engine.Body body, double force) {
        Engine.Body far = engine.add(1, 0, 100, 1), left = engine.add(1, 0, 200, 1), right = engine.add(1, 0, 202, -1);
        body.push(force);
        for (int i = 0; i < 120; i++) engine.step(Loop.TICK);
        body.stop();
        for (int i = 0; i < 60; i++) engine.step(Loop.TICK);
        if (!Double.isNaN(body.x())) return "the body is at " + Page.number(body.x());
        if (Double.isNaN(far.x()) || Double.isNaN(left.x())) return "every position remains NaN";
        return "its position remains NaN" + (left.v() > right.v() ? "; the others no longer collide" : "");
    }

    /** {@return what it does, in words} */
    String in(Supplier<? extends Engine> engine) {
        try {
            return give(engine.get());
        } catch (IllegalArgumentException e) {
            return "throws an exception";
        }
    }

    /** {@return the same for libGDX's Box2D} It runs in a JVM of its own, since native code can end it. */
    String inGdxBox2d(Path folder) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                        Poison.class.getName(),
                        name())
                .directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        String words = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        int status = process.waitFor();
        if (!words.startsWith(STARTED)) throw new IOException("the JVM did not start: " + status + " " + words);
        return status == 0 ? words.substring(STARTED.length()) : "ends the JVM";
    }

    /** Prints what one of these does to libGDX's Box2D. */
    public static void main(String[] args) {
        if (!GdxBox2d.isAvailable()) throw new IllegalStateException("no native library");
        print(STARTED);
        print(valueOf(args[0]).in(GdxBox2d::new));
    }

    private static void print(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        System.out.write(bytes, 0, bytes.length);
        System.out.flush();
    }
}
