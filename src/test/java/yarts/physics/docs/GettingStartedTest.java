package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import yarts.physics.Unit;

/** docs/getting-started.md; the build runs the project of this page in src/it/getting-started. */
class GettingStartedTest {
    private static final Path PROJECT = Path.of("src/it/getting-started");

    @TempDir
    Path classes;

    @Test
    void theClassPrintsTheOutputOfThePage() throws Exception {
        Path library = Path.of(
                Unit.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        String source = PROJECT.resolve("src/main/java/FirstTank.java").toString();
        int result = ToolProvider.getSystemJavaCompiler()
                .run(null, null, null, "-Xlint:all", "-d", classes.toString(), "-cp", library.toString(), source);
        assertEquals(0, result, "the class does not compile");
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream console = System.out;
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {classes.toUri().toURL()})) {
            System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
            loader.loadClass("FirstTank").getMethod("main", String[].class).invoke(null, (Object) new String[0]);
        } finally {
            System.setOut(console);
        }
        List<String> expected = Files.readAllLines(PROJECT.resolve("output.txt"));
        assertEquals(expected, printed.toString(StandardCharsets.UTF_8).lines().collect(Collectors.toList()));
    }

    @Test
    void thePageHasTheSameVersionAsTheReadmeForMavenAndGradle() throws IOException {
        String page = Files.readString(Path.of("docs/getting-started.md"));
        List<String> versions = Pattern.compile(
                        "yarts-physics(?:</artifactId>\\s*<version>|:)([^<\"]*)", Pattern.MULTILINE)
                .matcher(page)
                .results()
                .map(version -> version.group(1))
                .collect(Collectors.toList());
        String readme = IncludedCodeTest.versionInReadme();
        assertEquals(List.of(readme, readme), versions);
    }

    /** The offline build then needs no other versions of the plugins. */
    @Test
    void theProjectUsesThePluginVersionsOfTheLibrary() throws IOException {
        String library = Files.readString(Path.of("pom.xml"));
        Pattern plugin = Pattern.compile("<artifactId>(\\S+-plugin)</artifactId>\\s*<version>(.*?)</version>");
        List<MatchResult> plugins = plugin.matcher(Files.readString(PROJECT.resolve("pom.xml")))
                .results()
                .collect(Collectors.toList());
        assertFalse(plugins.isEmpty());
        for (MatchResult used : plugins) {
            boolean same =
                    plugin.matcher(library).results().anyMatch(p -> p.group().equals(used.group()));
            assertTrue(same, "pom.xml has another version of " + used.group());
        }
    }
}
