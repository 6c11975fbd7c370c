package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.AnnotatedElement;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.commons.annotation.Testable;
import org.junit.platform.commons.support.AnnotationSupport;
import yarts.physics.Unit;

/**
 * Runs the documentation. Each {@code java} block is compiled with all lint warnings, and its output must match its
 * comments: {@code // prints 5.0}, or {@code // prints 5.0, then 2.5} for a line that prints more than once.
 *
 * <p>A block is compiled as the body of a method, with {@code yarts.physics.*} imported.
 */
class DocsTest {
    private static final Pattern PRINTS = Pattern.compile("// prints (.*)");
    private static final Pattern LINK = Pattern.compile("]\\(([^)#:]*)(?:#([^)]*))?\\)");
    private static final Pattern NAME = Pattern.compile("`([A-Z]\\w+(?:\\.\\w+)?)`");

    @TempDir
    static Path classes;

    @TestFactory
    Stream<DynamicTest> everyBlockOfJavaPrintsWhatItsCommentsSay() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path page : pages()) {
            List<String> lines = Files.readAllLines(page);
            for (int i = 0; i < lines.size(); i++) {
                if (!lines.get(i).startsWith("```")) continue;
                int fence = i++;
                while (!lines.get(i).equals("```")) i++;
                List<String> block = lines.subList(fence + 1, i);
                if (lines.get(fence).equals("```java")) {
                    tests.add(dynamicTest(page + ":" + (fence + 2), () -> check(page, fence + 1, block)));
                }
            }
        }
        return tests.stream();
    }

    @Test
    void everyLinkLeadsToAnExistingFileAndHeading() throws IOException {
        for (Path page : pages()) {
            for (MatchResult link :
                    LINK.matcher(Files.readString(page)).results().collect(Collectors.toList())) {
                Path target = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1));
                assertTrue(Files.exists(target), page + " links to " + link.group());
                if (link.group(2) == null) continue;
                assertTrue(
                        Files.readAllLines(target).stream()
                                .anyMatch(s -> anchor(s).equals(link.group(2))),
                        page + " links to " + link.group());
            }
        }
    }

    /** The anchor of a heading. */
    private static String anchor(String heading) {
        if (!heading.startsWith("#")) return "";
        return heading.replaceFirst("#+ ", "")
                .toLowerCase(Locale.ROOT)
                .replaceAll("[^a-z0-9 -]", "")
                .replace(' ', '-');
    }

    @Test
    void everyRowOfTheSourceMapNamesExistingCodeAndTests() throws Exception {
        List<String> rows = Files.readAllLines(Path.of("docs/maintainers/source.md")).stream()
                .filter(line -> line.startsWith("| "))
                .skip(1)
                .collect(Collectors.toList());
        assertFalse(rows.isEmpty());
        for (String row : rows) {
            String[] cells = row.split("\\|");
            assertEquals(3, cells.length, "not | claim and code | tests |: " + row);
            List<String> code = find(NAME, cells[1]), tests = find(NAME, cells[2]);
            assertFalse(code.isEmpty() || tests.isEmpty(), "names too little: " + row);
            for (String name : code) assertTrue(isCode(name), name + " is no code: " + row);
            for (String name : tests) assertTrue(isTest(name), name + " is no test: " + row);
        }
    }

    /** The names on docs/maintainers/quality.md, and the tests and profiles in the commands of all pages. */
    @Test
    void everyNamedTestAndProfileExists() throws Exception {
        for (String name : find(NAME, Files.readString(Path.of("docs/maintainers/quality.md"))))
            assertTrue(isCode(name), name);
        int commands = 0;
        for (Path page : pages()) {
            for (String command : find(Pattern.compile("(mvn[^`\n]* -Dtest=[\\w,]+)"), Files.readString(page))) {
                boolean asLong = command.contains("-Plong");
                for (String name : command.replaceFirst(".*-Dtest=", "").split(",")) {
                    assertTrue(hasTests(type(name), asLong), page + ": " + command + " would run nothing");
                }
                commands++;
            }
        }
        assertTrue(commands > 20, "only " + commands + " commands");
        List<String> had =
                find(Pattern.compile("<profile>\\s*(?:<!--.*?-->\\s*)*<id>(.*?)</id>", Pattern.DOTALL), poms());
        for (Path page : pages()) {
            for (String name : find(Pattern.compile("mvn[^`\n]* -P(\\w+)"), Files.readString(page))) {
                assertTrue(had.contains(name), page + " asks for the profile " + name + "; there are " + had);
            }
        }
    }

    private static String poms() throws IOException {
        return Files.readString(Path.of("pom.xml")) + Files.readString(Path.of("src/site/pom.xml"));
    }

    /** Between two releases, the POM builds the next version and the README names the last one. */
    @Test
    void theReadmeNamesTheVersionOfThePomOrTheLastRelease() throws IOException {
        Pattern maven = Pattern.compile("<artifactId>yarts-physics</artifactId>\\s*<version>(.*?)</version>");
        Pattern gradle = Pattern.compile("[\"']io.github.yarts:yarts-physics:(.*?)[\"']");
        String pom = Files.readString(Path.of("pom.xml")), readme = Files.readString(Path.of("README.md"));
        List<String> had = new ArrayList<>(find(maven, pom));
        had.addAll(find(Pattern.compile("<last.release>(\\d.*?)</last.release>"), pom));
        List<String> asked = new ArrayList<>(find(maven, readme));
        asked.addAll(find(gradle, readme));
        assertEquals(3, asked.size(), "by Maven, and by Gradle in Kotlin and in Groovy");
        assertTrue(had.containsAll(asked), asked + " is asked for, " + had + " can be had");
    }

    static List<Path> pages() throws IOException {
        try (Stream<Path> docs = Files.walk(Path.of("docs"))) {
            return Stream.concat(
                            Stream.of(Path.of("README.md")),
                            docs.filter(p -> p.toString().endsWith(".md")))
                    .sorted()
                    .collect(Collectors.toList());
        }
    }

    private static List<String> find(Pattern pattern, String text) {
        return pattern.matcher(text).results().map(m -> m.group(1)).collect(Collectors.toList());
    }

    /** Whether a class has tests that run with the profile for long tests, or without it. */
    private static boolean hasTests(Class<?> type, boolean asLong) {
        return Stream.of(type.getDeclaredMethods())
                .filter(method -> AnnotationSupport.isAnnotated(method, Testable.class))
                .anyMatch(method -> asLong == (isLong(type) || isLong(method)));
    }

    /** Whether it has the tag "long" of JUnit or of jqwik. */
    private static boolean isLong(AnnotatedElement tests) {
        return Stream.of(tests.getAnnotations()).anyMatch(a -> a.toString().matches(".*\\.Tag\\(.*\"long\".*"));
    }

    private static boolean isCode(String name) throws Exception {
        Class<?> named = type(name);
        if (member(name).isEmpty()) return true;
        for (Class<?> type = named; type != null; type = type.getSuperclass()) {
            if (Stream.of(type.getDeclaredMethods()).map(Method::getName).anyMatch(member(name)::equals)) return true;
            if (Stream.of(type.getDeclaredFields()).map(Field::getName).anyMatch(member(name)::equals)) return true;
        }
        return false;
    }

    private static boolean isTest(String name) throws Exception {
        return Stream.of(type(name).getDeclaredMethods())
                .anyMatch(m -> m.getName().equals(member(name)) && m.getAnnotations().length > 0);
    }

    /** The only class with a simple name, in any package. */
    private static Class<?> type(String name) throws Exception {
        Path file = Path.of(name.split("\\.")[0] + ".java");
        List<Path> sources = new ArrayList<>();
        for (Path root : List.of(Path.of("src/main/java"), Path.of("src/test/java"))) {
            try (Stream<Path> all = Files.walk(root)) {
                all.filter(path -> path.endsWith(file)).map(root::relativize).forEach(sources::add);
            }
        }
        assertEquals(1, sources.size(), () -> name + " is no class, or more than one: " + sources);
        List<String> parts = new ArrayList<>();
        for (Path part : sources.get(0)) parts.add(part.toString());
        return Class.forName(String.join(".", parts).replaceFirst("\\.java$", ""));
    }

    private static String member(String name) {
        return name.contains(".") ? name.split("\\.")[1] : "";
    }

    /** Compiles and runs a block. Its line numbers are those of the page, so that errors name page and line. */
    private static void check(Path page, int line, List<String> block) throws Exception {
        String name = page.getFileName().toString().replace(".md", "") + line;
        String imports = block.stream().filter(DocsTest::isImport).collect(Collectors.joining(" "));
        String body = block.stream().map(s -> isImport(s) ? "" : s).collect(Collectors.joining("\n"));
        String code = "\n".repeat(line - 1) + "import yarts.physics.*; " + imports + " final class " + name
                + " { private " + name + "() {} public static void run() throws Exception {\n" + body + "\n}}";
        compile(page, code);

        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream console = System.out;
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {classes.toUri().toURL()})) {
            System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
            Method run = loader.loadClass(name).getDeclaredMethod("run");
            run.setAccessible(true);
            run.invoke(null);
        } finally {
            System.setOut(console);
        }
        List<String> says = find(PRINTS, body).stream()
                .flatMap(s -> Stream.of(s.split(", then ")))
                .collect(Collectors.toList());
        assertFalse(says.isEmpty(), page + ":" + line + " prints nothing, and so shows nothing");
        assertEquals(
                says, printed.toString(StandardCharsets.UTF_8).lines().collect(Collectors.toList()), page + ":" + line);
    }

    private static boolean isImport(String line) {
        return line.startsWith("import ");
    }

    private static void compile(Path page, String code) throws Exception {
        JavaFileObject source =
                new SimpleJavaFileObject(URI.create("string:///" + page.getFileName()), JavaFileObject.Kind.SOURCE) {
                    @Override
                    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                        return code;
                    }
                };
        DiagnosticCollector<JavaFileObject> errors = new DiagnosticCollector<>();
        String path = place(Unit.class) + System.getProperty("path.separator") + place(DocsTest.class);
        List<String> options = List.of("-Xlint:all", "-Werror", "-proc:none", "-d", classes.toString(), "-cp", path);
        boolean compiled = ToolProvider.getSystemJavaCompiler()
                .getTask(null, null, errors, options, null, Collections.singleton(source))
                .call();
        assertTrue(compiled, () -> page + " does not compile: " + errors.getDiagnostics());
    }

    private static Path place(Class<?> type) throws Exception {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    }
}
