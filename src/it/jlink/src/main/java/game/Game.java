package game;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A game with its own Java runtime: an image of three modules, in which the whole library works. */
public final class Game {
    private static final Set<String> MODULES = Set.of("game", "yarts.physics", "java.base");
    private static final double PUSH = 80_000; // N

    private Game() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        Path image = Path.of(System.getProperty("java.home"));
        Set<String> loaded =
                ModuleLayer.boot().modules().stream().map(Module::getName).collect(Collectors.toSet());
        require(loaded.equals(MODULES), "these modules are loaded: " + loaded);
        Set<String> listed = list(image);
        require(listed.equals(MODULES), "the image holds these modules: " + listed);

        World world = world();
        world.setPool(ForkJoinPool.commonPool());
        drive(world, 300);
        Snapshot saved = Snapshot.fromBytes(world.save().toBytes());
        drive(world, 300);
        for (Unit unit : world) compare(unit, 10);

        World other = world();
        other.restore(saved);
        drive(other, 300);
        require(world.stateHash() == other.stateHash(), "one thread gives the bits of many, from a saved game on");
        System.out.println("jlink: an image of " + size(image) / 1_000_000 + " MB with " + MODULES.size() + " modules; "
                + world.size()
                + " tanks drove as the closed form says, were saved, restored, and drove again to the bit");
    }

    /** The output of {@code java --list-modules} in the image: a name, an @ and a version per line. */
    private static Set<String> list(Path image) throws IOException, InterruptedException {
        Path java = image.resolve("bin").resolve("java");
        Process process = new ProcessBuilder(java.toString(), "--list-modules").start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        require(process.waitFor() == 0, "the image's java runs");
        return out.lines().map(line -> line.split("@")[0]).collect(Collectors.toSet());
    }

    private static long size(Path image) throws IOException {
        try (Stream<Path> files = Files.walk(image)) {
            return files.mapToLong(file -> file.toFile().length()).sum();
        }
    }

    private static World world() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 0; i < 40_000; i++) world.add(new Unit(20_000 + i).setFriction(8_000)); // enough to be shared out
        return world;
    }

    private static void drive(World world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            for (Unit unit : world) unit.applyForce(PUSH, 0);
            world.step();
        }
    }

    /** m dv/dt = F − f v from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f. */
    private static void compare(Unit unit, double t) {
        double m = unit.getMass(), f = unit.getFriction();
        double v = PUSH / f * -Math.expm1(-f * t / m);
        near(v, unit.getVx());
        near((PUSH * t - m * v) / f, unit.getX());
    }

    private static void near(double expected, double actual) {
        require(Math.abs(actual - expected) <= 1e-9 * Math.abs(expected), "expected " + expected + ", was " + actual);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
