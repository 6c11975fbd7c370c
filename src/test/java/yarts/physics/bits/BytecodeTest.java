package yarts.physics.bits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.AnnotatedElement;
import java.lang.reflect.Member;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import yarts.physics.World;

/**
 * The results of the library have the same bits on every JVM, at any time and in any order: its bytecode is searched
 * for operations that could differ. {@link Offender} proves that each rule detects them.
 */
class BytecodeTest {
    enum Rule {
        /** Only the exactly rounded functions of Math for doubles, and those for integers. */
        MATH,
        /** No StrictMath, whose results can differ if Java is translated to another language. */
        STRICT_MATH,
        /** Floats are converted and copied for a renderer, but never stored in the state or computed with. */
        FLOAT,
        /** Unordered maps and sets are used only for lookups. */
        HASH_ORDER,
        /** No clock, no system property, no thread except those of a pool. */
        SYSTEM,
        RANDOM,
        /** No hash that differs from one run to the next. */
        IDENTITY,
        /** No sum in an unspecified order. */
        REDUCTION
    }

    private static final Set<Integer> DOUBLE_ARITHMETIC =
            Set.of(Opcodes.DADD, Opcodes.DSUB, Opcodes.DMUL, Opcodes.DDIV, Opcodes.DREM);

    private static final Set<Integer> FLOAT_ARITHMETIC = Set.of(
            Opcodes.FADD,
            Opcodes.FSUB,
            Opcodes.FMUL,
            Opcodes.FDIV,
            Opcodes.FREM,
            Opcodes.FNEG,
            Opcodes.FCMPL,
            Opcodes.FCMPG,
            Opcodes.F2D,
            Opcodes.F2I,
            Opcodes.F2L,
            Opcodes.I2F,
            Opcodes.L2F);

    @Test
    void theLibraryObeysEveryRule() throws Exception {
        try (Stream<Path> files = Files.walk(SameBitsTest.classes(World.class))) {
            List<Path> classes =
                    files.filter(p -> p.toString().endsWith(".class")).toList();
            String names = classes.toString();
            for (String name : new String[] {"Kernel", "Exponential", "World", "Members", "Clock$Sum", "Team$Job"}) {
                assertTrue(names.contains(name + ".class"), names);
            }
            List<String> offences = new ArrayList<>();
            for (Path file : classes) offences.addAll(offences(file));
            // The caller that waits for the last pieces must be woken, and a timestep has a hash code; no bit depends
            // on them.
            String harmless =
                    "Team\\$Job\\.\\S+ breaks SYSTEM: .*(Thread\\.(currentThread|interrupt)|LockSupport\\.(un)?park).*"
                            + "|Timestep\\.hashCode breaks IDENTITY: .*";
            offences.removeIf(offence -> offence.matches(harmless));
            assertEquals(List.of(), offences);
        }
    }

    /**
     * Before Java 17, a JVM could compute in other ranges where strictfp was missing. The class files are of Java 8, and so
     * a JVM of any version obeys the modifier.
     */
    @Test
    void everyMethodThatComputesWithDoublesIsStrict() throws Exception {
        List<String> missing = new ArrayList<>();
        int[] strict = {0};
        try (Stream<Path> files = Files.walk(SameBitsTest.classes(World.class).resolve("yarts/physics"), 1)) {
            for (Path file : files.filter(p -> p.toString().endsWith(".class")).toList()) {
                ClassReader reader = new ClassReader(Files.readAllBytes(file));
                assertEquals(Opcodes.V1_8, reader.readShort(6), file + " is of another version");
                reader.accept(strictness(file.getFileName().toString(), missing, strict), ClassReader.SKIP_DEBUG);
            }
        }
        assertEquals(List.of(), missing);
        assertTrue(strict[0] > 50, "only " + strict[0] + " methods");
    }

    private static ClassVisitor strictness(String type, List<String> missing, int[] strict) {
        return new ClassVisitor(Opcodes.ASM9) {
            @Override
            public MethodVisitor visitMethod(int access, String name, String desc, String generic, String[] thrown) {
                return new MethodVisitor(Opcodes.ASM9) {
                    private boolean computes;

                    @Override
                    public void visitInsn(int opcode) {
                        computes |= DOUBLE_ARITHMETIC.contains(opcode);
                    }

                    @Override
                    public void visitEnd() {
                        if (computes && (access & Opcodes.ACC_STRICT) == 0) missing.add(type + '.' + name);
                        else if (computes) strict[0]++;
                    }
                };
            }
        };
    }

    @Test
    void everyRuleDetectsItsOffenders() throws Exception {
        List<String> expected = Stream.of(Offender.class.getDeclaredFields(), Offender.class.getDeclaredMethods())
                .flatMap(Stream::of)
                .filter(m -> ((AnnotatedElement) m).isAnnotationPresent(Offender.Breaks.class))
                .map(m -> "Offender." + ((Member) m).getName() + " breaks "
                        + ((AnnotatedElement) m)
                                .getAnnotation(Offender.Breaks.class)
                                .value())
                .sorted()
                .toList();
        Path file = SameBitsTest.classes(Offender.class)
                .resolve(Offender.class.getName().replace('.', '/') + ".class");
        assertEquals(
                String.join("\n", expected),
                offences(file).stream()
                        .map(s -> s.substring(0, s.indexOf(": ")))
                        .distinct()
                        .sorted()
                        .collect(Collectors.joining("\n")));
        for (Rule rule : Rule.values()) {
            assertTrue(expected.toString().contains(" " + rule), rule + " has no offender");
        }
    }

    /** {@return lines such as {@code Kernel.step breaks MATH: java/lang/Math.sin(D)D}} */
    private static List<String> offences(Path file) throws IOException {
        List<String> offences = new ArrayList<>();
        ClassReader reader = new ClassReader(Files.readAllBytes(file));
        String type = reader.getClassName().replaceFirst(".*/", "") + '.';
        ClassVisitor search = new ClassVisitor(Opcodes.ASM9) {
            @Override
            public FieldVisitor visitField(int access, String name, String desc, String generic, Object value) {
                if (desc.endsWith("F")) offences.add(type + name + " breaks " + Rule.FLOAT + ": " + desc);
                return null;
            }

            @Override
            public MethodVisitor visitMethod(int access, String name, String desc, String generic, String[] thrown) {
                return new Method(type + name, offences);
            }
        };
        reader.accept(search, ClassReader.SKIP_DEBUG);
        return offences;
    }

    /** Searches the code of a method. */
    private static final class Method extends MethodVisitor {
        private final String name;
        private final List<String> offences;

        Method(String name, List<String> offences) {
            super(Opcodes.ASM9);
            this.name = name;
            this.offences = offences;
        }

        private void report(Rule rule, String what) {
            if (rule != null) offences.add(name + " breaks " + rule + ": " + what);
        }

        @Override
        public void visitInsn(int opcode) {
            if (FLOAT_ARITHMETIC.contains(opcode)) report(Rule.FLOAT, "opcode " + opcode);
        }

        @Override
        public void visitMethodInsn(int opcode, String owner, String called, String desc, boolean isInterface) {
            report(broken(owner, called, desc), owner + '.' + called + desc);
        }

        @Override
        public void visitInvokeDynamicInsn(String called, String desc, Handle bootstrap, Object... args) {
            for (Object arg : args) {
                if (!(arg instanceof Handle to)) continue; // a method reference, such as Math::sin
                report(broken(to.getOwner(), to.getName(), to.getDesc()), to.toString());
            }
        }
    }

    /** {@return the rule that a call breaks, or null} */
    private static Rule broken(String owner, String name, String desc) {
        String type = owner.replaceFirst("^java/(lang|util)/", "");
        if (type.equals("Math")) {
            boolean integers = !desc.matches(".*[DF].*");
            return integers || (name.matches("sqrt|abs|min|max") && !desc.contains("F")) ? null : Rule.MATH;
        }
        if (type.equals("StrictMath")) return Rule.STRICT_MATH;
        if (name.matches("hashCode|identityHashCode") || (type.equals("Objects") && name.equals("hash"))) {
            return Rule.IDENTITY;
        }
        if (type.equals("System") && name.equals("arraycopy")) return null;
        if (owner.startsWith("java/time/") || type.matches("System|Runtime|Thread|Date|Calendar|Timer")) {
            return Rule.SYSTEM;
        }
        if (type.matches("concurrent/TimeUnit|concurrent/locks/LockSupport")) return Rule.SYSTEM;
        if ((owner.startsWith("java/") && owner.contains("andom")) || type.equals("UUID")) return Rule.RANDOM;
        if (name.startsWith("parallel") || (owner + desc).matches(".*java/util/(stream/|concurrent/atomic/)Double.*")) {
            return Rule.REDUCTION;
        }
        return isUnordered(owner) && !isLookUp(name, desc) ? Rule.HASH_ORDER : null;
    }

    private static boolean isLookUp(String name, String desc) {
        return name.matches("get|put|remove|add|contains|containsKey|size|isEmpty|clear")
                || (name.equals("<init>") && !desc.contains(";")); // not a copy of another map
    }

    private static boolean isUnordered(String owner) {
        if (owner.startsWith("[")) return false;
        try {
            Class<?> type = Class.forName(owner.replace('/', '.'), false, BytecodeTest.class.getClassLoader());
            boolean mapOrSet = Map.class.isAssignableFrom(type) || Set.class.isAssignableFrom(type);
            return mapOrSet && !SortedMap.class.isAssignableFrom(type) && !SortedSet.class.isAssignableFrom(type);
        } catch (ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }
}
