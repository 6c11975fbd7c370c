package game;

import java.io.IOException;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleReader;
import java.lang.module.ModuleReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A game on the module path: looks at the module it got, then drives a column of tanks and retires half of it. */
public final class Game {
    private static final double PUSH = 120_000; // N

    private Game() {}

    public static void main(String[] args) throws IOException, ReflectiveOperationException {
        Module physics = Unit.class.getModule();
        require(System.getProperty("java.class.path").isEmpty(), "nothing is on the class path");
        require(physics.isNamed(), "the library is a named module");
        lookInto(physics.getDescriptor());
        int classes = lookInto(physics, Path.of(args[0]));
        Object steps = World.class.getMethod("advance", double.class).invoke(new World(), 0.1);
        require(steps.equals(6), "reflection reaches World's methods");
        int tanks = play();
        System.out.println("module-path: " + physics + " requires java.base alone, its jar holds " + classes
                + " classes and no test; " + tanks + " tanks drove as the closed form says");
    }

    private static void lookInto(ModuleDescriptor physics) {
        require(physics.name().equals("yarts.physics"), "it is called yarts.physics");
        require(!physics.isAutomatic() && !physics.isOpen(), "it has a descriptor of its own, and is closed");
        Set<String> requires =
                physics.requires().stream().map(ModuleDescriptor.Requires::name).collect(Collectors.toSet());
        require(requires.equals(Set.of("java.base")), "it requires java.base alone, not " + requires);
        Set<String> exports = physics.exports().stream()
                .map(ModuleDescriptor.Exports::toString) // with the modules exported to, if not to all
                .collect(Collectors.toSet());
        require(exports.equals(Set.of("yarts.physics")), "it exports yarts.physics alone, not " + exports);
    }

    /** Every class in the jar has its source among the library's; the rest is META-INF. Returns how many there are. */
    private static int lookInto(Module physics, Path sources) throws IOException {
        ModuleReference jar = physics.getLayer()
                .configuration()
                .findModule(physics.getName())
                .orElseThrow()
                .reference();
        require(jar.location().orElseThrow().getPath().endsWith(".jar"), "it comes in a jar: " + jar);
        int classes = 0;
        try (ModuleReader reader = jar.open();
                Stream<String> names = reader.list()) {
            for (String name : (Iterable<String>) names::iterator) {
                if (name.endsWith("/") || name.startsWith("META-INF/")) continue;
                String source = name.replaceFirst("(\\$.*)?\\.class$", ".java");
                require(Files.isRegularFile(sources.resolve(source)), "the jar holds the library alone, not " + name);
                classes++;
            }
        }
        require(classes > 0, "the jar holds classes");
        return classes;
    }

    /** Frames of uneven length, a constant push in each; returns the number of tanks. */
    private static int play() {
        double[] frames = {1 / 144.0, 1 / 60.0, 0, 1 / 24.0, 0.001};
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 0; i < 60; i++) world.add(tank(i));
        List<Unit> all = List.copyOf(world.units());
        int frame = 0;
        while (world.getTime() < 10) {
            for (Unit tank : world) tank.applyForce(PUSH, -PUSH / 2);
            world.advance(frames[frame++ % frames.length]);
        }
        double left = world.getTime();
        int i = 0;
        for (Iterator<Unit> tanks = world.iterator(); tanks.hasNext(); i++) {
            tanks.next();
            if (i % 2 == 0) tanks.remove();
        }
        require(world.size() == 30, "half of the tanks left");
        while (world.getTime() < 20) {
            for (Unit tank : world) tank.applyForce(PUSH, -PUSH / 2);
            world.advance(frames[frame++ % frames.length]);
        }
        for (Unit tank : all) compare(tank, tank.getWorld() == null ? left : world.getTime());
        return all.size();
    }

    private static Unit tank(int i) {
        return new Unit(20_000 + 1_000 * i).setFriction(4_000 + 300 * i);
    }

    /** m dv/dt = F − f v from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f. */
    private static void compare(Unit tank, double t) {
        double m = tank.getMass(), f = tank.getFriction();
        double v = PUSH / f * -Math.expm1(-f * t / m);
        double x = (PUSH * t - m * v) / f;
        near(v, tank.getVx());
        near(-v / 2, tank.getVy());
        near(x, tank.getX());
        near(-x / 2, tank.getY());
        require(Math.abs(tank.getX() - tank.getInterpolatedX()) <= v / 60, "it is drawn within a step of where it is");
    }

    private static void near(double expected, double actual) {
        require(Math.abs(actual - expected) <= 1e-9 * Math.abs(expected), "expected " + expected + ", was " + actual);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
