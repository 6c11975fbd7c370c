package yarts.physics.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.commonmark.node.Document;
import org.commonmark.node.Heading;
import org.commonmark.node.Text;
import org.jsoup.Jsoup;
import org.jsoup.nodes.Element;
import org.jsoup.select.Elements;
import org.junit.jupiter.api.Test;

/** The table of contents, the menu, the code and the style sheets of the built site. */
class PagesTest {
    private static final Path SITE = Path.of(System.getProperty("site")).normalize();

    private static List<Path> files(Path folder, String end) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.toString().endsWith(end)).toList();
        }
    }

    @Test
    void aLongPageHasATableOfContentsWithEachHeading() throws IOException {
        int tables = 0;
        for (Path file : files(SITE.resolve("docs"), ".html")) {
            Element main = Jsoup.parse(file).selectFirst("main");
            Elements headings = main.select("h2, h3"), links = main.select("nav.contents a");
            boolean expected = headings.size() >= Contents.LONG && !Contents.hasOwn(withoutContents(main));
            assertEquals(expected ? headings.eachText() : List.of(), links.eachText(), file.toString());
            if (!expected) continue;
            assertEquals(headings.stream().map(heading -> "#" + heading.id()).toList(), links.eachAttr("href"));
            tables++;
        }
        assertTrue(tables >= 5, tables + " tables of contents");
    }

    private static String withoutContents(Element main) {
        Element copy = main.clone();
        copy.select("nav").remove();
        return copy.html();
    }

    @Test
    void aTableOfContentsFollowsTheFirstParagraph() {
        String title = "<h1 id=\"t\">T</h1>\n<p>First.</p>\n",
                rest = "<p>Second.</p>\n" + "<h2 id=\"a\">A</h2>\n".repeat(4);
        assertEquals(title + rest, Contents.addTo(title + rest));
        String page = Contents.addTo(title + rest + "<h3 id=\"b\">B &lt; <code>C</code></h3>\n");
        assertTrue(page.startsWith(title + "<nav class=\"contents\""), page);
        assertTrue(page.contains("<li class=\"level3\"><a href=\"#b\">B &lt; <code>C</code></a></li>"), page);
    }

    @Test
    void theMenuHasGroupsAndThePagesForMaintainersAreTheLast() throws IOException {
        for (Path file : files(SITE.resolve("docs"), ".html")) {
            Element menu = Jsoup.parse(file).selectFirst("nav.menu");
            assertEquals(
                    List.of("Start", "In your game", "Background", "Reference", "For maintainers"),
                    menu.select("p").eachText());
            assertEquals("yarts-physics", menu.selectFirst("a").text());
            Elements groups = menu.select("ul");
            for (Element group : groups) {
                for (Element link : group.select("a")) {
                    Path page = file.resolveSibling(link.attr("href")).normalize();
                    assertEquals(group == groups.last(), page.startsWith(SITE.resolve("docs/maintainers")), link::text);
                }
            }
            assertEquals(1, menu.select("[aria-current]").size(), file.toString());
        }
    }

    @Test
    void aPageWithoutAPlaceInTheOrderIsInTheMenu() {
        Menu menu = new Menu(List.of(page("README.md"), page("docs/maintainers/new.md"), page("docs/other.md")));
        List<String> links = Jsoup.parse(menu.html(page("docs/maintainers/new.md")))
                .select("a")
                .eachAttr("href");
        assertEquals(
                List.of(
                        "../../index.html",
                        "../../skirmish/index.html",
                        "../../api/index.html",
                        "../../docs/other.html",
                        "../../docs/maintainers/new.html"),
                links);
    }

    private static Page page(String file) {
        Heading heading = new Heading();
        heading.appendChild(new Text(file));
        Document document = new Document();
        document.appendChild(heading);
        return new Page(file, document);
    }

    /** Each line of code is an element of its own, with the indentation of its text. */
    @Test
    void eachLineOfCodeHasAHangingIndent() throws IOException {
        for (Path file : files(SITE.resolve("docs"), ".html")) {
            for (Element block : Jsoup.parse(file).select("pre.wrapped")) {
                Elements lines = block.select(".line");
                assertEquals(
                        block.wholeText().lines().toList(),
                        lines.stream().map(l -> l.wholeText().stripTrailing()).toList().stream()
                                .toList());
                for (Element line : lines) {
                    String text = line.wholeText();
                    int indent = text.isBlank()
                            ? 0
                            : text.length() - text.stripLeading().length();
                    assertEquals(indent == 0 ? "" : "--indent:" + indent, line.attr("style"), text);
                }
            }
        }
    }

    /** A missing font would show as a failed request. */
    @Test
    void everyFileInAStyleSheetExists() throws IOException {
        List<String> missing = new ArrayList<>();
        int found = 0;
        Pattern url = Pattern.compile("url\\(['\"]?(?!data:)([^'\")]+)");
        for (Path css : files(SITE, ".css")) {
            Matcher names = url.matcher(Files.readString(css));
            while (names.find()) {
                if (Files.isRegularFile(css.resolveSibling(names.group(1)))) found++;
                else missing.add(SITE.relativize(css) + ": " + names.group(1));
            }
        }
        assertEquals(List.of(), missing);
        assertTrue(found > 0, "the Javadoc has icons");
    }
}
