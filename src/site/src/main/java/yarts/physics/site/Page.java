package yarts.physics.site;

import org.commonmark.node.Node;
import org.commonmark.renderer.text.TextContentRenderer;

/**
 * A page that is made from a document.
 *
 * @param file the document's path in the repository: README.md, docs/guide.md
 * @param content its parsed text
 */
record Page(String file, Node content) {
    private static final TextContentRenderer PLAIN =
            TextContentRenderer.builder().build();

    boolean isFirst() {
        return file.equals("README.md");
    }

    /** {@return the document's name without folder and extension: README, guide} */
    String name() {
        return file.replaceAll(".*/|\\.md$", "");
    }

    /** {@return its path in the site} */
    String html() {
        return html(file);
    }

    static String html(String file) {
        return file.replaceFirst("^README\\.md", "index.html").replaceFirst("\\.md", ".html");
    }

    /** {@return the relative path from it to the root of the site} */
    String root() {
        return "../".repeat(file.split("/").length - 1);
    }

    /** {@return its first heading} */
    String title() {
        return PLAIN.render(content.getFirstChild()).trim();
    }
}
