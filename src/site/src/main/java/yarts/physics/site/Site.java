package yarts.physics.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * Writes the site: one page for README.md and one for each Markdown file in docs. The pages are in the same folders as these
 * files, so that relative links and pictures work.
 *
 * <pre>{@code java -cp … yarts.physics.site.Site <repository> <site>}</pre>
 */
public final class Site {
    private static final List<Extension> EXTENSIONS =
            List.of(TablesExtension.create(), HeadingAnchorExtension.create());
    private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();
    private static final HtmlRenderer RENDERER =
            HtmlRenderer.builder().extensions(EXTENSIONS).build();

    private final Path repository, site;
    private final List<Page> pages = new ArrayList<>();
    private final Menu menu;

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
        menu = new Menu(pages);
    }

    public static void main(String[] args) throws IOException {
        Site site = new Site(Path.of(args[0]).toRealPath(), Path.of(args[1]).toAbsolutePath());
        site.copyPictures();
        site.write("site.css", resource("site.css"));
        for (Page page : site.pages) site.write(page);
        site.removeFonts();
    }

    private void write(Page page) throws IOException {
        page.content().accept(new Edit(repository, site, page));
        String content = RENDERER.render(page.content());
        String html = resource("page.html")
                .replace(
                        "{title}",
                        page.isFirst()
                                ? page.title()
                                : page.title() + " · " + pages.get(0).title())
                .replace("{root}", page.root())
                .replace("{menu}", menu.html(page))
                .replace("{content}", page.isFirst() ? content : Contents.addTo(content));
        write(page.html(), html);
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

    /** The Javadoc's style sheet imports a font file that not every JDK has. Without it, the fonts are the system's. */
    private void removeFonts() throws IOException {
        try (Stream<Path> files = Files.walk(site.resolve("api"))) {
            for (Path css :
                    files.filter(file -> file.endsWith("stylesheet.css")).toList()) {
                String text = Files.readString(css);
                Files.writeString(css, text.replaceAll("@import url\\([^)]*fonts[^)]*\\);", ""));
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
