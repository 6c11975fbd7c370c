package yarts.physics.soak;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * A long game in two JVMs with a small heap at the same time. The hashes must be equal, and the memory in use must not
 * grow. By default the game is short; {@code -Dsoak.frames=510000} makes it last 15 minutes, and prints the time of a step.
 */
class SoakTest {
    private static final long FRAMES = Long.getLong("soak.frames", 1_000);

    private static Process play() throws Exception {
        return run("-Xmx64m", SoakMain.class, FRAMES);
    }

    private static Process run(String heap, Class<?> main, long argument) throws Exception {
        return new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        heap,
                        "-XX:+UseSerialGC",
                        "-cp",
                        System.getProperty("java.class.path"),
                        main.getName(),
                        String.valueOf(argument))
                .redirectErrorStream(true)
                .start();
    }

    private static List<String> lines(Process process) {
        List<String> lines = process.inputReader(StandardCharsets.UTF_8).lines().toList();
        assertEquals(0, process.onExit().join().exitValue(), lines.toString());
        return lines;
    }

    private static List<String> only(List<String> lines, String kind) {
        return lines.stream().filter(line -> line.startsWith(kind)).toList();
    }

    @Test
    void aLongGameHasOneHashAndNeedsNoMoreMemoryAtItsEnd() throws Exception {
        List<Process> processes = List.of(play(), play());
        List<List<String>> runs =
                processes.parallelStream().map(SoakTest::lines).toList();
        List<String> hashes = only(runs.get(0), "hash"), otherHashes = only(runs.get(1), "hash");
        assertFalse(hashes.isEmpty(), "no hashes");
        assertEquals(hashes, otherHashes);
        assertEquals(
                hashes.size(),
                hashes.stream().map(h -> h.split(" ", 3)[2]).distinct().count());

        for (List<String> run : runs) {
            List<String> parts = only(run, "part");
            if (FRAMES > 20_000) {
                System.out.println("part, ticks, ns of a step of 10,000 units: median, 99 %, longest; bytes in use");
                parts.forEach(System.out::println);
            }
            // The memory of the world grows and shrinks; a leak only grows.
            long most = bytes(parts, 6, 10).max().orElseThrow(),
                    least = bytes(parts, 16, 20).min().orElseThrow();
            assertTrue(least < most + (1 << 20), least + " bytes are in use at the end, and " + most + " were before");
        }
        if (FRAMES > 20_000) System.out.println(hashes.size() + " hashes, the last " + hashes.get(hashes.size() - 1));
    }

    /** With {@code -Dsoak.steps=240000}, five million steps. */
    @Test
    @Tag("long")
    void worldsOnPoolsOfAnySizeNeverHangAndHaveTheSameBits() throws Exception {
        List<String> lines = lines(run("-Xmx1g", ThreadsMain.class, Long.getLong("soak.steps", 4_000)));
        assertTrue(lines.get(lines.size() - 1).endsWith("the same bits"), lines.toString());
    }

    /** The memory in use in some parts of the run. */
    private static LongStream bytes(List<String> parts, int from, int to) {
        return parts.subList(from - 1, to).stream().mapToLong(part -> Long.parseLong(part.split(" ", -1)[6]));
    }
}
