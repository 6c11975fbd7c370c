package yarts.physics.faults;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A call that runs out of memory changes nothing. {@link OutOfMemoryMain} runs in a JVM with a small heap. */
class OutOfMemoryTest {
    private static final int CALLS = 16;

    private static List<String> failures(String... units) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx24m",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                OutOfMemoryMain.class.getName()));
        command.addAll(List.of(units));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), text);
        return text.lines().toList();
    }

    /** Checks that calls failed before there was enough memory. A step and find need none. */
    private static void assertFailed(List<String> lines) {
        assertEquals(CALLS, lines.size(), lines.toString());
        for (String line : lines) {
            boolean step = line.matches("(step|advance|find):.*");
            int most = 0;
            for (String times : line.replaceFirst(".*: ", "").split(" "))
                most = Math.max(most, Integer.parseInt(times));
            assertTrue(step ? most == 0 : most > 2, line);
        }
    }

    @Test
    void aCallWithoutMemoryChangesNothing() throws Exception {
        assertFailed(failures("32"));
    }

    /** Sizes at the borders of tiles and arrays. The test above has another size. */
    @Test
    @Tag("long")
    void aCallWithoutMemoryChangesNothingInWorldsOfAnySize() throws Exception {
        assertFailed(failures("1", "31", "512", "600", "1024"));
    }
}
