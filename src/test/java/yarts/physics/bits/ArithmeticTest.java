package yarts.physics.bits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.World;

/**
 * The check of a thread's arithmetic passes if it is Java's, and throws if native code has changed it. For the second
 * case, a library is built with the C compiler of the machine, if there is one, and loaded into other JVMs.
 */
class ArithmeticTest {
    private static final boolean ARM = System.getProperty("os.arch").equals("aarch64");

    /** Sets bits of the floating-point control register, when called, and with AT_ONCE also when loaded. */
    private static final String LIBRARY = """
            #ifdef __aarch64__
            static void set(int bits) {
                unsigned long long mode;
                __asm__ volatile("mrs %0, fpcr" : "=r"(mode));
                mode |= bits;
                __asm__ volatile("msr fpcr, %0" : : "r"(mode));
            }
            #else
            #include <xmmintrin.h>
            static void set(int bits) { _mm_setcsr(_mm_getcsr() | bits); }
            #endif
            #ifdef AT_ONCE
            __attribute__((constructor)) static void loaded(void) { set(AT_ONCE); }
            #endif
            #ifdef _WIN32
            __declspec(dllexport)
            #endif
            void Java_yarts_physics_bits_ArithmeticMain_set(void *env, void *type, int bits) { set(bits); }
            """;

    @TempDir
    static Path folder;

    private static boolean compiles;

    @BeforeAll
    static void findCompiler() throws Exception {
        compiles = compile("plain");
        if (!compiles) System.out.println("No C compiler: no library to change the floating-point mode with");
    }

    private static Path library(String name) {
        return folder.resolve(System.mapLibraryName(name));
    }

    private static boolean compile(String name, String... options) throws Exception {
        Path source = Files.writeString(folder.resolve("mode.c"), LIBRARY);
        for (String compiler : new String[] {"cc", "gcc"}) {
            List<String> command = Stream.of(
                            Stream.of(compiler, "-shared", "-fPIC", "-O1"),
                            Stream.of(options),
                            Stream.of("-o", library(name).toString(), source.toString()))
                    .flatMap(s -> s)
                    .toList();
            try {
                Process process = new ProcessBuilder(command)
                        .redirectErrorStream(true)
                        .redirectOutput(folder.resolve("log").toFile())
                        .start();
                if (process.waitFor() == 0) return true;
            } catch (IOException e) {
                // There is no such program; try the next one.
            }
        }
        return false;
    }

    /** {@return the two lines of a JVM in which the library sets these bits} */
    private static List<String> printed(String library, int bits) throws Exception {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:+IgnoreUnrecognizedVMOptions",
                        "--enable-native-access=ALL-UNNAMED",
                        "-cp",
                        System.getProperty("java.class.path"),
                        ArithmeticMain.class.getName(),
                        library(library).toString(),
                        String.valueOf(bits))
                .redirectErrorStream(true)
                .start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
        assertEquals(0, process.waitFor(), text);
        List<String> lines = text.lines().toList();
        assertEquals(2, lines.size(), text);
        return lines;
    }

    @Test
    void javasOwnArithmeticPassesOnEveryThread() throws Exception {
        World.checkArithmetic();
        int[] passed = {0};
        Runnable check = () -> {
            World.checkArithmetic();
            passed[0]++;
        };
        Thread thread = new Thread(check);
        thread.start();
        thread.join();
        ForkJoinPool pool = new ForkJoinPool(1);
        pool.submit(check).get();
        pool.shutdown();
        ForkJoinPool.commonPool().submit(check).get();
        assertEquals(3, passed[0]);
    }

    /** The bits of FTZ and DAZ in MXCSR of x86, and of FZ, which is both, in FPCR of ARM; and the flushed numbers. */
    static Stream<Arguments> modes() {
        if (ARM) return Stream.of(arguments(1 << 24, "results and operands"));
        return Stream.of(
                arguments(1 << 15, "results"),
                arguments(1 << 6, "operands"),
                arguments(1 << 15 | 1 << 6, "results and operands"));
    }

    @ParameterizedTest
    @MethodSource("modes")
    void aThreadThatFlushesTinyNumbersIsDetected(int bits, String flushed) throws Exception {
        assumeTrue(compiles, "no C compiler");
        List<String> lines = printed("plain", bits);
        assertEquals(ArithmeticMain.verdict(), lines.get(0), "before");
        assertTrue(
                lines.get(1).startsWith("this thread flushes subnormal numbers to 0, as " + flushed + ": "),
                lines::toString);
        assertNotEquals(hash(ArithmeticMain.verdict()), hash(lines.get(1)), "the results of its worlds differ");
    }

    /** As a library does that was linked with fast mathematics. Newer JVMs undo the change; then the check passes. */
    @Test
    void aLibraryThatChangesTheModeWhenLoadedIsDetectedUnlessTheJvmUndoesIt() throws Exception {
        int bits = (int) modes().reduce((a, b) -> b).orElseThrow().get()[0];
        assumeTrue(compiles && compile("eager", "-DAT_ONCE=" + bits), "no C compiler");
        String line = printed("eager", 0).get(0);
        System.out.println("After a library changed the floating-point mode: " + line);
        assertEquals(line.startsWith("passes "), hash(line).equals(hash(ArithmeticMain.verdict())), line);
    }

    private static String hash(String line) {
        return line.substring(line.lastIndexOf(' ') + 1);
    }
}
