package yarts.physics.site;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.commonmark.ext.gfm.tables.TableBlock;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.CustomBlock;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.Heading;
import org.commonmark.node.HtmlBlock;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.renderer.html.HtmlWriter;
import prettify.PrettifyParser;
import syntaxhighlight.ParseResult;

/**
 * Makes a page one of the site. Links to pages lead to pages of the site, and those to other files to where these can be
 * read. Where a page first names a type of the library, the name is a link to its Javadoc. Code has colours, and wide
 * tables scroll by themselves.
 */
final class Edit extends AbstractVisitor {
    private static final String REPOSITORY = "https://github.com/yarts/yarts-physics/";
    private static final String API = "api/yarts.physics/yarts/physics/";

    private static final Set<String> COLOURED = Set.of("java", "kotlin", "groovy", "xml", "json", "sh");

    private final Path repository, api;
    private final Page page;
    private final Set<String> named = new HashSet<>();

    Edit(Path repository, Path site, Page page) {
        this.repository = repository;
        api = site.resolve(API);
        this.page = page;
    }

    @Override
    public void visit(Link link) {
        URI to = URI.create(link.getDestination());
        if (to.isAbsolute() || to.getPath().isEmpty()) return;
        URI file = URI.create(page.file()).resolve(to);
        String path = file.getPath();
        if (path.matches("README\\.md|docs/.*\\.md")) link.setDestination(page.root() + Page.html(file.toString()));
        else if (Files.isDirectory(repository.resolve(path))) link.setDestination(REPOSITORY + "tree/main/" + file);
        else if (!path.startsWith("docs/images/")) link.setDestination(REPOSITORY + "blob/main/" + file);
    }

    /** A heading has no links in it. */
    @Override
    public void visit(Heading heading) {}

    @Override
    public void visit(Code code) {
        String file = code.getLiteral() + ".html";
        if (!file.matches("[A-Z]\\w+\\.html") || !Files.exists(api.resolve(file)) || !named.add(file)) return;
        Link link = new Link(page.root() + API + file, null);
        code.insertBefore(link);
        link.appendChild(code);
    }

    @Override
    public void visit(CustomBlock block) {
        visitChildren(block);
        if (!(block instanceof TableBlock)) return;
        block.insertBefore(html("<div class=\"table\">"));
        block.insertAfter(html("</div>"));
    }

    @Override
    public void visit(FencedCodeBlock block) {
        String language = block.getInfo().replaceFirst(" .*", ""), code = block.getLiteral();
        StringBuilder text = new StringBuilder("<pre tabindex=\"0\"><code>");
        HtmlWriter writer = new HtmlWriter(text);
        List<ParseResult> parts = COLOURED.contains(language) ? new PrettifyParser().parse(language, code) : List.of();
        for (ParseResult part : parts) {
            text.append("<span class=\"").append(part.getStyleKeysString()).append("\">");
            writer.text(code.substring(part.getOffset(), part.getOffset() + part.getLength()));
            text.append("</span>");
        }
        if (parts.isEmpty()) writer.text(code);
        block.insertBefore(html(text.append("</code></pre>").toString()));
        block.unlink();
    }

    private static Node html(String text) {
        HtmlBlock block = new HtmlBlock();
        block.setLiteral(text);
        return block;
    }
}
