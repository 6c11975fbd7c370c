package yarts.physics.bits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import yarts.physics.World;

/**
 * The same game has the same bits in the interpreter, with each compiler, with other machine instructions, on other
 * JDKs and with any number of threads: the golden bits below, on any machine.
 */
class SameBitsTest {
    /** Enough units for several threads; {@link SameBitsMain} fails if these have no work. */
    private static final int UNITS = 70_000;

    private static final int SHORT = 5, MEDIUM = 150, LONG = 1500;

    /**
     * The hashes of the game by number of ticks. A version that changes a bit can neither play replays of older
     * versions nor play against them; the changelog must say so. {@link SameBitsMain} prints the new lines.
     */
    private static final Map<Integer, String> GOLDEN = Map.of(
            SHORT,
                    "EULER 4059a381b616aa20 SEMI_IMPLICIT 6c6cd34c12658d11 MIDPOINT 824c188f817d88a EXACT 5a4768f7881acdd4",
            MEDIUM,
                    "EULER e24136d96f74b65 SEMI_IMPLICIT 8056648b0c7d72ad MIDPOINT fa23b321861b81f4 EXACT cae656afc614c22d",
            LONG,
                    "EULER 803ff75d1eb0208a SEMI_IMPLICIT b3f6bb28a1dbf72d MIDPOINT 8e8f1ec076207cd7 EXACT 48bb2a78b31862af");

    private static final Path HOME = Path.of(System.getProperty("java.home"));
    /** A JVM with its defaults. */
    private static final String DEFAULT = "-XX:+TieredCompilation";

    private static final String FIRST_COMPILER = "-XX:TieredStopAtLevel=1";
    /** The second compiler with the oldest instructions. A JVM ignores the switches of other processors. */
    private static final String OLDEST = "-XX:UseAVX=0 -XX:UseSVE=0";

    private static final String INTERPRETER = "-Xint";
    /** Without the JVM's own code for Math.exp and similar functions: their use would change the bits. */
    private static final String NO_INTRINSICS = "-XX:-UseLibmIntrinsic";

    private static final List<String> SWITCHES = List.of(
            FIRST_COMPILER,
            OLDEST,
            "-XX:UseAVX=2",
            "-XX:-UseSuperWord",
            "-XX:-UseFMA",
            NO_INTRINSICS + " -XX:-TieredCompilation");

    @Test
    void thisJvmGivesTheGoldenBits() {
        assertEquals(GOLDEN.get(MEDIUM), SameBitsMain.play(UNITS, MEDIUM, 3));
    }

    @Test
    void everyCompilerGivesTheGoldenBits() throws Exception {
        assertGolden(List.of(
                new Child(HOME, FIRST_COMPILER, MEDIUM, 1),
                new Child(HOME, OLDEST, MEDIUM, 2),
                new Child(HOME, INTERPRETER + ' ' + NO_INTRINSICS, SHORT, 1)));
    }

    @Test
    void otherJdksGiveTheGoldenBits() throws Exception {
        List<Child> children = new ArrayList<>();
        for (Path home : otherJdks()) children.add(new Child(home, DEFAULT, MEDIUM, 7));
        if (children.isEmpty()) System.out.println("No second JDK beside this one: its bits are not compared");
        assumeFalse(children.isEmpty(), "no second JDK");
        assertGolden(children);
    }

    /** On every JDK: the whole game with seven threads, and a tenth with each switch, with one, two and four threads. */
    @Test
    @Tag("long")
    void everyJdkGivesTheGoldenBitsWithEverySwitch() throws Exception {
        Set<Path> homes = otherJdks();
        homes.add(HOME);
        List<Child> children = new ArrayList<>();
        for (Path home : homes) {
            children.add(new Child(home, DEFAULT, LONG, 7));
            for (int i = 0; i < SWITCHES.size(); i++) {
                children.add(new Child(home, SWITCHES.get(i), MEDIUM, 1 << i % 3));
            }
        }
        assertGolden(children);
    }

    @Test
    void theHashIncludesEveryStepAndUnit() {
        assertEquals(SameBitsMain.play(50, 100, 1), SameBitsMain.play(50, 100, 1));
        assertNotEquals(SameBitsMain.play(50, 100, 1), SameBitsMain.play(50, 110, 1));
        assertNotEquals(SameBitsMain.play(50, 100, 1), SameBitsMain.play(51, 100, 1));
        assertTrue(SameBitsMain.play(50, 100, 1).matches("(\\w+ [0-9a-f]+ ){3}EXACT [0-9a-f]+"));
    }

    /** Runs JVMs, one at a time for each processor. */
    private static void assertGolden(List<Child> children) throws Exception {
        ExecutorService processors =
                Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            StringBuilder wrong = new StringBuilder();
            for (Future<String> child : processors.invokeAll(children)) wrong.append(child.get());
            assertEquals("", wrong.toString());
        } finally {
            processors.shutdownNow();
        }
    }

    /** A JVM that plays the game. */
    private static final class Child implements Callable<String> {
        private final Path home;
        private final String flags;
        private final int ticks, threads;

        Child(Path home, String flags, int ticks, int threads) {
            this.home = home;
            this.flags = flags;
            this.ticks = ticks;
            this.threads = threads;
        }

        /** {@return the faults in its output; empty if there are none} */
        @Override
        public String call() throws Exception {
            List<String> command = new ArrayList<>(List.of(
                    java(home).toString(), "-XX:+UnlockDiagnosticVMOptions", "-XX:+IgnoreUnrecognizedVMOptions"));
            command.addAll(List.of(flags.split(" ")));
            command.addAll(List.of("-cp", classes(World.class) + File.pathSeparator + classes(SameBitsMain.class)));
            command.add(SameBitsMain.class.getName());
            for (int arg : new int[] {UNITS, ticks, threads}) command.add(String.valueOf(arg));
            Process process = new ProcessBuilder(command)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            try {
                String line = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
                return process.waitFor() == 0 && line.equals(GOLDEN.get(ticks))
                        ? ""
                        : String.format("%d ticks: %s: %s on %d threads of %s%n", ticks, line, flags, threads, home);
            } finally {
                process.destroy();
            }
        }
    }

    /** {@return the folder or jar that a class comes from} */
    static Path classes(Class<?> type) throws URISyntaxException {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    }

    private static Path java(Path home) {
        Path java = home.resolve("bin").resolve("java");
        return Files.isExecutable(java) ? java : home.resolve("bin").resolve("java.exe");
    }

    /** JDKs of release 17 or later beside the one that runs this, or named by variables such as JAVA_HOME_21_X64. */
    private static Set<Path> otherJdks() throws IOException {
        List<Path> homes = new ArrayList<>();
        try (Stream<Path> siblings = Files.list(HOME.toRealPath().getParent())) {
            siblings.sorted().forEach(homes::add);
        }
        System.getenv().forEach((name, value) -> {
            if (name.startsWith("JAVA_HOME")) homes.add(Path.of(value));
        });
        Set<Path> others = new LinkedHashSet<>();
        for (Path home : homes) {
            if (Files.isExecutable(java(home)) && release(home) >= 17) others.add(home.toRealPath());
        }
        others.remove(HOME.toRealPath());
        return others;
    }

    /** The number in a JDK's release file, JAVA_VERSION="17.0.15"; 0 if there is none. */
    private static int release(Path home) throws IOException {
        Path file = home.resolve("release");
        if (!Files.isReadable(file)) return 0;
        Matcher version = Pattern.compile("JAVA_VERSION=\"(\\d+)").matcher(Files.readString(file));
        return version.find() ? Integer.parseInt(version.group(1)) : 0;
    }
}
