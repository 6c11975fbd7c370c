package yarts.physics.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * Writes the site: a page from README.md and from each Markdown file in docs, in the folders that they have in the repository, so
 * that links and pictures are where the text looks for them.
 *
 * <pre>{@code java -cp … yarts.physics.site.Site <repository> <site>}</pre>
 */
public final class Site {
    /** The order of the pages in the navigation. Others come last. */
    private static final List<String> ORDER = List.of(
            "README getting-started guide cookbook two-hundred-tanks troubleshooting engines adopting lockstep snapshots"
                    .concat(
                            " limits physics jitters comparison benchmarks changelog contributing quality source releasing")
                    .split(" "));

    private static final List<Extension> EXTENSIONS =
            List.of(TablesExtension.create(), HeadingAnchorExtension.create());
    private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();
    private static final HtmlRenderer RENDERER =
            HtmlRenderer.builder().extensions(EXTENSIONS).build();

    private final Path repository, site;
    private final List<Page> pages = new ArrayList<>();

    private Site(Path repository, Path site) throws IOException {
        this.repository = repository;
        this.site = site;
        List<String> files = new ArrayList<>(List.of("README.md"));
        try (Stream<Path> docs = Files.walk(repository.resolve("docs"))) {
            docs.map(doc -> repository.relativize(doc).toString().replace('\\', '/'))
                    .filter(file -> file.endsWith(".md"))
                    .forEach(files::add);
        }
        for (String file : files) pages.add(new Page(file, PARSER.parse(Files.readString(repository.resolve(file)))));
        pages.sort(Comparator.comparing(Site::rank).thenComparing(Page::file));
    }

    public static void main(String[] args) throws IOException {
        Site site = new Site(Path.of(args[0]).toRealPath(), Path.of(args[1]).toAbsolutePath());
        site.copyPictures();
        site.write("site.css", resource("site.css"));
        for (Page page : site.pages) site.write(page);
    }

    private static int rank(Page page) {
        int rank = ORDER.indexOf(page.file().replaceAll(".*/|\\.md", ""));
        return rank < 0 ? ORDER.size() : rank;
    }

    private void write(Page page) throws IOException {
        page.content().accept(new Edit(repository, site, page));
        String html = resource("page.html")
                .replace(
                        "{title}",
                        page.isFirst()
                                ? page.title()
                                : page.title() + " · " + pages.get(0).title())
                .replace("{root}", page.root())
                .replace("{navigation}", navigation(page))
                .replace("{content}", RENDERER.render(page.content()));
        write(page.html(), html);
    }

    private String navigation(Page here) {
        StringBuilder links = new StringBuilder();
        for (Page page : pages) {
            links.append(link(here, page.html(), page == here ? " aria-current=\"page\"" : "", page.title()));
            if (page.isFirst()) links.append(link(here, "skirmish/index.html", "", "Skirmish, live"));
        }
        return links.append(link(here, "api/index.html", "", "Javadoc")).toString();
    }

    private static String link(Page from, String to, String attribute, String text) {
        return "<a href=\"" + from.root() + to + '"' + attribute + '>' + text + "</a>\n";
    }

    private void copyPictures() throws IOException {
        try (Stream<Path> pictures = Files.list(repository.resolve("docs/images"))) {
            for (Path picture : pictures.toList()) {
                Path copy = site.resolve("docs/images").resolve(picture.getFileName());
                Files.createDirectories(copy.getParent());
                Files.write(copy, Files.readAllBytes(picture));
            }
        }
    }

    private void write(String file, String text) throws IOException {
        Path path = site.resolve(file);
        Files.createDirectories(path.getParent());
        Files.writeString(path, text);
    }

    private static String resource(String name) throws IOException {
        try (InputStream in = Site.class.getResourceAsStream("/" + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
