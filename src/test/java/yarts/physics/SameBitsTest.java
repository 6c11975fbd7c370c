package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The same game has the same bits in the interpreter, from each compiler, with other machine instructions, on other JDKs. */
class SameBitsTest {
    private static final Path HOME = Path.of(System.getProperty("java.home"));
    /** A JVM as it comes. */
    private static final String DEFAULT = "-XX:+TieredCompilation";
    /** Only the first compiler, and the second with the oldest instructions. A JVM without such a switch ignores it. */
    private static final List<String> COMPILERS = List.of(DEFAULT, "-XX:TieredStopAtLevel=1", "-XX:UseAVX=0");

    /** Without the JVM's own code for Math.exp and the like, which would show up one of them that is not StrictMath's. */
    private static final String NO_INTRINSICS = "-XX:-UseLibmIntrinsic";

    private static final List<String> SLOW =
            List.of("-Xint", "-XX:-TieredCompilation", "-XX:-UseSuperWord", NO_INTRINSICS);

    @Test
    void everyCompilerGivesTheSameBits() throws Exception {
        assertSame(run(HOME, COMPILERS, 10_000, 1000), COMPILERS.size());
    }

    @Test
    void theInterpreterGivesTheSameBits() throws Exception {
        Map<String, String> lines = run(HOME, List.of("-Xint", NO_INTRINSICS, DEFAULT), 1000, 300);
        lines.put("this JVM", SameBitsMain.play(1000, 300));
        assertSame(lines, 4);
    }

    @Test
    void otherJdksGiveTheSameBits() throws Exception {
        Set<Path> others = otherJdks();
        if (others.isEmpty()) System.out.println("No second JDK beside this one: its bits are not compared");
        assumeFalse(others.isEmpty(), "no second JDK");
        Map<String, String> lines = run(HOME, List.of(DEFAULT), 10_000, 1000);
        for (Path home : others) lines.putAll(run(home, List.of(DEFAULT), 10_000, 1000));
        assertSame(lines, others.size() + 1);
    }

    @Test
    @Tag("long")
    void everyJdkGivesTheSameBitsHoweverItRuns() throws Exception {
        List<String> flags = new ArrayList<>(COMPILERS);
        flags.addAll(SLOW);
        Map<String, String> lines = run(HOME, flags, 10_000, 1000);
        for (Path home : otherJdks()) lines.putAll(run(home, flags, 10_000, 1000));
        assertSame(lines, flags.size() * (1 + otherJdks().size()));
    }

    @Test
    void theHashSeesEveryStepAndUnit() {
        assertEquals(SameBitsMain.play(50, 100), SameBitsMain.play(50, 100));
        assertNotEquals(SameBitsMain.play(50, 100), SameBitsMain.play(50, 110));
        assertNotEquals(SameBitsMain.play(50, 100), SameBitsMain.play(51, 100));
        assertTrue(SameBitsMain.play(50, 100).matches("EULER [0-9a-f]+ MIDPOINT [0-9a-f]+ EXACT [0-9a-f]+"));
    }

    private static void assertSame(Map<String, String> lines, int count) {
        assertEquals(count, lines.size());
        Set<String> distinct = new LinkedHashSet<>(lines.values());
        String table = lines.entrySet().stream()
                .map(e -> e.getValue() + "  " + e.getKey())
                .collect(Collectors.joining("\n", "\n", "\n"));
        assertEquals(1, distinct.size(), table);
        assertFalse(distinct.contains(""), table);
    }

    /** Runs a JVM for each flag, all at the same time; returns what each printed. */
    private static Map<String, String> run(Path home, List<String> flags, int units, int steps) throws Exception {
        Map<String, Process> running = new LinkedHashMap<>();
        try {
            for (String flag : flags) running.put(flag + " on " + home, start(home, flag, units, steps));
            Map<String, String> lines = new LinkedHashMap<>();
            for (Map.Entry<String, Process> child : running.entrySet()) {
                String line = new String(child.getValue().getInputStream().readAllBytes()).trim();
                assertEquals(0, child.getValue().waitFor(), () -> child.getKey() + ": " + line);
                lines.put(child.getKey(), line);
            }
            return lines;
        } finally {
            running.values().forEach(Process::destroy);
        }
    }

    private static Process start(Path home, String flag, int units, int steps) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(
                java(home).toString(),
                "-XX:+UnlockDiagnosticVMOptions",
                "-XX:+IgnoreUnrecognizedVMOptions",
                flag,
                "-cp",
                classes(World.class) + File.pathSeparator + classes(SameBitsMain.class),
                SameBitsMain.class.getName(),
                String.valueOf(units),
                String.valueOf(steps));
        return builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }

    private static Path classes(Class<?> type) throws URISyntaxException {
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
