package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
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

/** The library consists of layers: each file depends only on lower ones. The JDK's jdeps reads it from the classes. */
class ArchitectureTest {
    private static final Path CLASSES = Path.of("target/classes");

    /** The layers from the bottom up. */
    private static final List<Set<String>> LAYERS = List.of(
            Set.of("Check", "Integrator", "Exponential", "Crew"),
            Set.of("Table", "Timestep", "Team"),
            Set.of("Clock", "Kernel", "Coefficients", "Impulses", "Bulk"),
            Set.of("Passes", "State"),
            Set.of("Stepper", "SnapshotFormat", "Difference"),
            Set.of("Unit", "StepListener"),
            Set.of("Members", "Snapshot"),
            Set.of("World"));

    /** A unit returns its world, and a listener receives it: the API requires these two dependencies upward. */
    private static final Map<String, String> UPWARD = Map.of("Unit", "World", "StepListener", "World");

    private static int layer(String file) {
        for (int k = 0; k < LAYERS.size(); k++) if (LAYERS.get(k).contains(file)) return k;
        throw new AssertionError(file + " is in no layer");
    }

    /** A dependency of a class on another class of the library. Inner classes count as their file. */
    private static final Pattern ARROW =
            Pattern.compile("^ *yarts\\.physics\\.(\\w+)(?:\\$\\w+)* +-> (?:yarts\\.physics\\.(\\w+))?");

    /** The files on which each file depends. */
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
    void everyFileDependsOnlyOnLowerLayers() {
        Map<String, Set<String>> known = known();
        Set<String> files = LAYERS.stream().flatMap(Set::stream).collect(Collectors.toSet());
        assertEquals(files, known.keySet());
        List<String> wrong = new ArrayList<>();
        known.forEach((file, others) -> {
            for (String other : others) {
                boolean upward = other.equals(UPWARD.get(file));
                if (!upward && layer(other) >= layer(file)) wrong.add(file + " -> " + other);
            }
        });
        assertEquals(List.of(), wrong);
        UPWARD.forEach((file, other) -> assertTrue(known.get(file).contains(other), file));
    }

    @Test
    void publicTypesAreFewAndExtendObject() throws Exception {
        Set<String> types = new TreeSet<>();
        for (String file : known().keySet()) {
            Class<?> type = Class.forName("yarts.physics." + file);
            if (!Modifier.isPublic(type.getModifiers())) continue;
            types.add(file);
            boolean plain = type.isInterface() || type.isEnum() || type.getSuperclass() == Object.class;
            assertTrue(plain, file + " extends " + type.getSuperclass());
        }
        assertEquals(Set.of("Integrator", "Snapshot", "StepListener", "Timestep", "Unit", "World"), types);
    }

    /** State outside of a world would be shared by worlds on different threads. */
    @Test
    void noClassHasStaticState() throws Exception {
        List<String> variable = new ArrayList<>();
        for (String file : known().keySet()) {
            for (Field field : Class.forName("yarts.physics." + file).getDeclaredFields()) {
                if (field.isSynthetic()) continue; // of JaCoCo
                int modifiers = field.getModifiers();
                boolean probe = file.equals("Check") && Modifier.isVolatile(modifiers); // of the arithmetic
                if (Modifier.isStatic(modifiers) && !Modifier.isFinal(modifiers) && !probe)
                    variable.add(file + "." + field.getName());
            }
        }
        assertEquals(List.of(), variable);
    }

    /** So that a game without a pool can be compiled for a platform without threads. */
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
        assertEquals(Set.of("World.setPool"), users);
    }

    /** Collects the methods that use Team or java.util.concurrent, other than those of Team. */
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
