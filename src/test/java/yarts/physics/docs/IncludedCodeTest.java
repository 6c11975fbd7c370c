package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Checks that the docs show the code of the games in src/it, which the build compiles and runs. On a page,
 * {@code <!-- include: file tag -->} is before the block; in the file, the lines are between {@code // tag::…[]} and
 * {@code // end::…[]}, as in AsciiDoc. Without a tag, the block is the whole file, with the version of the README
 * instead of {@code @project.version@}.
 *
 * <pre>{@code mvn test -Dtest=IncludedCodeTest -Ddocs.write   # updates the blocks}</pre>
 */
class IncludedCodeTest {
    private static final Pattern INCLUDE =
            Pattern.compile("<!-- include: (\\S+)(?: (\\S+))? -->\n(```[^\n]*\n)(.*?)```\n", Pattern.DOTALL);
    private static final Pattern TAG = Pattern.compile("// tag::(\\w+)\\[]");
    private static final Pattern VERSION =
            Pattern.compile("<artifactId>yarts-physics</artifactId>\\s*<version>(.*?)</version>");

    /** If an adapter needs more lines, the API of the library is unsuitable. */
    private static final int LONGEST_ADAPTER = 10;

    @Test
    void everyIncludedBlockEqualsTheCodeOfItsGame() throws IOException {
        int blocks = 0;
        for (Path page : DocsTest.pages()) {
            String text = Files.readString(page);
            StringBuilder anew = new StringBuilder();
            Matcher include = INCLUDE.matcher(text);
            for (; include.find(); blocks++) {
                Path file = Path.of(include.group(1));
                String tag = include.group(2);
                String code = tag == null ? wholeFile(file) : region(file, tag);
                String block = "<!-- include: " + include.group(1) + (tag == null ? "" : ' ' + tag) + " -->\n"
                        + include.group(3) + code + "```\n";
                include.appendReplacement(anew, Matcher.quoteReplacement(block));
            }
            include.appendTail(anew);
            if (System.getProperty("docs.write") != null) Files.writeString(page, anew);
            else
                assertEquals(anew.toString(), text, page + " is not what the code is: run this test with -Ddocs.write");
        }
        assertTrue(blocks > 10, "no page includes anything");
    }

    @Test
    void everyTaggedPartOfAGameIsInTheDocs() throws IOException {
        StringBuilder pages = new StringBuilder();
        for (Path page : DocsTest.pages()) pages.append(Files.readString(page));
        for (Path game : games()) {
            for (MatchResult tag : TAG.matcher(Files.readString(game)).results().collect(Collectors.toList())) {
                String include = "<!-- include: " + game.toString().replace('\\', '/') + ' ' + tag.group(1) + " -->";
                assertTrue(pages.toString().contains(include), "no page has " + include);
            }
        }
    }

    @Test
    void anAdapterHasAtMostTenLines() throws IOException {
        List<String> seen = new ArrayList<>();
        for (Path game : games()) {
            if (!Files.readString(game).contains("// tag::adapter[]")) continue;
            List<String> lines = region(game, "adapter")
                    .lines()
                    .map(String::strip)
                    .filter(line -> !line.isEmpty() && !line.matches("(//|/\\*|\\*|import ).*"))
                    .collect(Collectors.toList());
            assertFalse(lines.isEmpty(), game.toString());
            assertTrue(lines.size() <= LONGEST_ADAPTER, game + " needs " + lines.size() + " lines: " + lines);
            seen.add(game.toString());
        }
        assertTrue(seen.size() > 5, "of few games only: " + seen);
    }

    private static List<Path> games() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/it"))) {
            return files.filter(file -> file.toString().matches(".*\\.(java|kt)"))
                    .sorted()
                    .collect(Collectors.toList());
        }
    }

    private static String wholeFile(Path file) throws IOException {
        return Files.readString(file).replace("@project.version@", versionInReadme());
    }

    /** The version in the README, which users should use. */
    static String versionInReadme() throws IOException {
        Matcher version = VERSION.matcher(Files.readString(Path.of("README.md")));
        assertTrue(version.find(), "README.md names no version");
        return version.group(1);
    }

    /** The lines between two tags, without their common indentation. */
    private static String region(Path file, String tag) throws IOException {
        List<String> lines = Files.readAllLines(file), region = new ArrayList<>();
        int begin = index(lines, "// tag::" + tag + "[]", file), end = index(lines, "// end::" + tag + "[]", file);
        for (String line : lines.subList(begin + 1, end)) if (!line.matches(" *// (tag|end)::.*")) region.add(line);
        int indent = region.stream()
                .filter(line -> !line.isBlank())
                .mapToInt(line -> line.length() - line.stripLeading().length())
                .min()
                .orElseThrow(() -> new AssertionError(file + " has nothing at " + tag));
        return region.stream()
                .map(line -> (line.isBlank() ? "" : line.substring(indent)) + "\n")
                .collect(Collectors.joining());
    }

    private static int index(List<String> lines, String mark, Path file) {
        for (int i = 0; i < lines.size(); i++) if (lines.get(i).strip().equals(mark)) return i;
        throw new AssertionError(file + " has no " + mark);
    }
}
