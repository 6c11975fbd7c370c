package yarts.physics.site;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.regex.Pattern;
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
 * Changes a document into a page of the site. Links to documents lead to their pages, and links to other files lead to the
 * repository on GitHub. The first mention of each type of the library links to its Javadoc. Code is coloured, and its long
 * lines wrap. Wide tables scroll on their own.
 */
final class Edit extends AbstractVisitor {
    private static final String REPOSITORY = "https://github.com/yarts/yarts-physics/";
    private static final String API = "api/yarts.physics/yarts/physics/";

    private static final Set<String> COLOURED = Set.of("java", "kotlin", "groovy", "xml", "json", "sh");

    /** Marks a place for a line break until the code is coloured: a zero-width space. */
    private static final String MARK = "\u200B";

    private static final Pattern BREAK = Pattern.compile("(?<=\\w\\()(?=[^)])|(?=\\.[A-Za-z])");

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

    /** Adds no links to headings. */
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
        String language = block.getInfo().replaceFirst(" .*", "");
        String code = block.getLiteral();
        StringBuilder text = new StringBuilder();
        if (COLOURED.contains(language)) {
            text.append("<pre class=\"wrapped\"><code>");
            String[] coloured = coloured(language, code).split("\n", -1), lines = code.split("\n", -1);
            for (int i = 0; i < lines.length - 1; i++) {
                int indent = lines[i].length() - lines[i].stripLeading().length();
                text.append("<span class=\"line\"").append(indent > 0 ? " style=\"--indent:" + indent + "\"" : "");
                text.append('>').append(coloured[i]).append("\n</span>");
            }
        } else {
            text.append("<pre tabindex=\"0\"><code>");
            new HtmlWriter(text).text(code);
        }
        block.insertBefore(html(text.append("</code></pre>").toString()));
        block.unlink();
    }

    /** {@return code as HTML; no element spans lines, and a long line can break in front of a method or an argument} */
    private static String coloured(String language, String code) {
        StringBuilder text = new StringBuilder();
        HtmlWriter writer = new HtmlWriter(text);
        String breakable = BREAK.matcher(code).replaceAll(MARK);
        for (ParseResult part : new PrettifyParser().parse(language, breakable)) {
            String separator = "";
            for (String piece : breakable
                    .substring(part.getOffset(), part.getOffset() + part.getLength())
                    .split("\n", -1)) {
                text.append(separator)
                        .append("<span class=\"")
                        .append(part.getStyleKeysString())
                        .append("\">");
                writer.text(piece);
                text.append("</span>");
                separator = "\n";
            }
        }
        return text.toString().replace(MARK, "<wbr>");
    }

    private static Node html(String text) {
        HtmlBlock block = new HtmlBlock();
        block.setLiteral(text);
        return block;
    }
}
