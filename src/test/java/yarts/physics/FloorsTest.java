package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** The library is a house of floors: each file knows only those below it. The JDK's jdeps reads it from the classes. */
class FloorsTest {
    private static final Path CLASSES = Path.of("target/classes");
    private static final Path SOURCES = Path.of("src/main/java/yarts/physics");

    /** From the ground up: what each file may know. */
    private static final String[] HOUSE = {
        "Check:",
        "Integrator:",
        "Columns:",
        "Exponential:",
        "Crew:",
        "Timestep: Check",
        "Clock: Check Timestep",
        "Table: Columns",
        "Kernel: Columns",
        "Passes: Columns Kernel",
        "Coefficients: Columns Exponential Integrator Kernel",
        "Impulses: Columns Table",
        "Bulk: Check Columns Table",
        "Team: Crew",
        "Stepper: Coefficients Columns Crew Integrator Kernel Passes Table",
        "State: Clock Columns Integrator Table Timestep",
        "SnapshotFormat: Check Clock Columns Integrator Kernel State Table Timestep",
        "Difference: Clock Columns Integrator State Table Timestep",
        "Row: Columns",
        "Unit: Bulk Check Coefficients Columns Integrator Kernel Row",
        "Members: Check Columns Row Table Unit",
        "Snapshot: Check Clock Difference Integrator SnapshotFormat State Table Timestep Unit",
        "Simulation: Bulk Check Clock Impulses Integrator State Stepper Table Team Crew Timestep",
        "StepListener:",
        "World: Check Integrator Members Simulation Snapshot State StepListener Table Timestep Unit",
    };

    /** A unit tells its world, and a listener is told it: the API asks for these two arrows upward. */
    private static final Map<String, String> UPWARD = Map.of("Unit", "World", "StepListener", "World");

    private static final Map<String, Set<String>> ALLOWED = allowed();

    private static Map<String, Set<String>> allowed() {
        Map<String, Set<String>> allowed = new TreeMap<>();
        for (String floor : HOUSE) {
            String[] parts = floor.split(":", 2);
            Set<String> below = new TreeSet<>(List.of(parts[1].trim().split(" +")));
            below.remove("");
            assertTrue(allowed.keySet().containsAll(below), () -> floor + " is not above all of these");
            allowed.put(parts[0], below);
        }
        return allowed;
    }

    /** From a class of the library's to another class, if that is the library's, too. A file's inner classes are its own. */
    private static final Pattern ARROW =
            Pattern.compile("^ *yarts\\.physics\\.(\\w+)(?:\\$\\w+)* +-> (?:yarts\\.physics\\.(\\w+))?");

    /** By file, the files whose classes its classes name anywhere. */
    private static Map<String, Set<String>> known() {
        StringWriter out = new StringWriter();
        PrintWriter writer = new PrintWriter(out);
        int exit = ToolProvider.findFirst("jdeps")
                .orElseThrow()
                .run(writer, writer, "-verbose:class", "-filter:none", "--ignore-missing-deps", CLASSES.toString());
        assertEquals(0, exit, out::toString);
        Map<String, Set<String>> known = new TreeMap<>();
        for (String line : out.toString().lines().toList()) {
            Matcher arrow = ARROW.matcher(line);
            if (!arrow.find()) continue;
            Set<String> others = known.computeIfAbsent(arrow.group(1), file -> new TreeSet<>());
            String other = arrow.group(2);
            if (other != null && !other.equals(arrow.group(1))) others.add(other);
        }
        return known;
    }

    @Test
    void everyFileKnowsOnlyThoseBelowIt() {
        Map<String, Set<String>> known = known();
        assertEquals(ALLOWED.keySet(), known.keySet());
        List<String> wrong = new ArrayList<>();
        known.forEach((file, others) -> {
            for (String other : others) {
                boolean upward = other.equals(UPWARD.get(file));
                if (!upward && !ALLOWED.get(file).contains(other)) wrong.add(file + " -> " + other);
            }
        });
        assertEquals(List.of(), wrong);
    }

    /** And so the only circles are a unit's and a listener's with their world. */
    @Test
    void theTwoArrowsUpwardAreThere() {
        Map<String, Set<String>> known = known();
        UPWARD.forEach((file, other) -> assertTrue(known.get(file).contains(other), file));
        known.get("Unit").remove("World");
        known.get("StepListener").remove("World");
        while (!known.isEmpty()) {
            Set<String> ground = known.entrySet().stream()
                    .filter(e -> e.getValue().isEmpty())
                    .map(Map.Entry::getKey)
                    .collect(Collectors.toSet());
            assertFalse(ground.isEmpty(), () -> "a circle among " + known);
            known.keySet().removeAll(ground);
            known.values().forEach(others -> others.removeAll(ground));
        }
    }

    @Test
    void noFileIsOver12Kilobytes() throws IOException {
        try (Stream<Path> files = Files.list(SOURCES)) {
            List<String> large = files.filter(file -> file.toFile().length() > 12_000)
                    .map(file -> file.getFileName() + " " + file.toFile().length())
                    .toList();
            assertEquals(List.of(), large);
        }
    }

    /** So a game without a pool can be compiled for a platform that has no threads. */
    @Test
    void threadsAreReachedOnlyFromSetPool() throws IOException {
        Set<String> users = new TreeSet<>();
        try (Stream<Path> classes = Files.walk(CLASSES)) {
            for (Path file : (Iterable<Path>) classes.filter(f -> f.toString().endsWith(".class"))::iterator) {
                ClassReader reader = new ClassReader(Files.readAllBytes(file));
                String name = reader.getClassName().replaceAll(".*/|\\$.*", "");
                reader.accept(new ThreadUsers(name, users), 0);
            }
        }
        assertEquals(
                Set.of("Simulation.setPool", "World.setPool"), users); // javac has World inherit it through a bridge
    }

    /** Notes which methods use Team or anything of java.util.concurrent; Team's own are what it is for. */
    private static final class ThreadUsers extends ClassVisitor {
        private final String file;
        private final Set<String> users;

        ThreadUsers(String file, Set<String> users) {
            super(Opcodes.ASM9);
            this.file = file;
            this.users = users;
        }

        @Override
        public MethodVisitor visitMethod(int access, String method, String desc, String signature, String[] throwing) {
            if (file.equals("Team")) return null;
            look(method, desc);
            return new MethodVisitor(Opcodes.ASM9) {
                @Override
                public void visitMethodInsn(int opcode, String owner, String name, String desc, boolean isInterface) {
                    look(method, owner + desc);
                }

                @Override
                public void visitTypeInsn(int opcode, String type) {
                    look(method, type);
                }

                @Override
                public void visitFieldInsn(int opcode, String owner, String name, String desc) {
                    look(method, owner + desc);
                }
            };
        }

        private void look(String method, String names) {
            if (names.contains("java/util/concurrent/") || names.contains("yarts/physics/Team"))
                users.add(file + "." + method);
        }
    }
}
