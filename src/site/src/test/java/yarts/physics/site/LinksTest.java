package yarts.physics.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jsoup.Jsoup;
import org.jsoup.nodes.Document;
import org.jsoup.nodes.Element;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Checks the links of every page of the built site. Pages of other sites are not loaded. */
class LinksTest {
    private static final Path SITE = Path.of(System.getProperty("site")).normalize();
    private static final Path REPOSITORY =
            Path.of(System.getProperty("repository")).normalize();
    /** The address of the repository's files. */
    private static final String SOURCES = "https://github\\.com/yarts/yarts-physics/(blob|tree)/main/";

    private static final Map<Path, Document> PAGES = new HashMap<>();

    @BeforeAll
    static void read() throws IOException {
        try (Stream<Path> files = Files.walk(SITE)) {
            for (Path file : (Iterable<Path>) files.filter(f -> f.toString().endsWith(".html"))::iterator) {
                PAGES.put(file, Jsoup.parse(file));
            }
        }
    }

    @Test
    void everyLinkLeadsToAPageAndAPlaceInIt() {
        List<String> dead = new ArrayList<>();
        int[] alive = {0};
        PAGES.forEach((page, document) -> {
            for (Element element : document.select("[href], [src]")) {
                String link = element.attr(element.hasAttr("href") ? "href" : "src");
                if (leads(page, link)) alive[0]++;
                else dead.add(SITE.relativize(page) + ": " + link);
            }
        });
        assertEquals("", String.join("\n", dead));
        System.out.println(alive[0] + " links on " + PAGES.size() + " pages work");
        assertTrue(alive[0] > 500, "the Javadoc alone has more");
    }

    private static boolean leads(Path page, String link) {
        URI uri = URI.create(link);
        if (link.matches(SOURCES + ".*"))
            return Files.exists(REPOSITORY.resolve(link.replaceAll(SOURCES + "|#.*", "")));
        if (uri.isAbsolute()) return true;
        Path file = uri.getPath().isEmpty()
                ? page
                : page.resolveSibling(uri.getPath()).normalize();
        if (Files.isDirectory(file)) file = file.resolve("index.html");
        if (!file.startsWith(SITE) || !Files.isRegularFile(file)) return false;
        String place = uri.getFragment();
        return place == null || place.isEmpty() || !PAGES.containsKey(file) || has(PAGES.get(file), place);
    }

    private static boolean has(Document page, String place) {
        return page.getElementById(place) != null
                || !page.getElementsByAttributeValue("name", place).isEmpty();
    }

    /** Colours and line breaks do not change the text of code. */
    @Test
    void codeIsTheTextOfTheDocuments() throws IOException {
        for (String name : List.of("README.md", "docs/guide.md", "docs/lockstep.md")) {
            String written = Files.readString(REPOSITORY.resolve(name));
            Document page = PAGES.get(SITE.resolve(Page.html(name)));
            assertEquals(
                    written.split("(?m)^```\\w").length - 1, page.select("pre").size(), name);
            for (Element block : page.select("pre")) assertTrue(written.contains(block.wholeText()), block::wholeText);
        }
    }

    @Test
    void everyDocumentIsInTheMenuOfEveryOther() throws IOException {
        List<Path> documents = new ArrayList<>(List.of(SITE.resolve("index.html")));
        try (Stream<Path> files = Files.walk(REPOSITORY.resolve("docs"))) {
            files.map(file -> REPOSITORY.relativize(file).toString())
                    .filter(name -> name.endsWith(".md"))
                    .forEach(name -> documents.add(SITE.resolve(Page.html(name))));
        }
        for (Path page : documents) {
            List<Path> links = PAGES.get(page).select("nav.menu a").eachAttr("href").stream()
                    .map(link -> page.resolveSibling(link).normalize())
                    .toList();
            assertTrue(links.containsAll(documents), () -> page + " links to " + links);
        }
    }
}
