package yarts.physics.site;

import org.commonmark.node.Node;
import org.commonmark.renderer.text.TextContentRenderer;

/**
 * A page.
 *
 * @param file where it is in the repository: README.md, docs/guide.md
 * @param content what it says
 */
record Page(String file, Node content) {
    private static final TextContentRenderer PLAIN =
            TextContentRenderer.builder().build();

    boolean isFirst() {
        return file.equals("README.md");
    }

    /** {@return where it is in the site} */
    String html() {
        return html(file);
    }

    static String html(String file) {
        return file.replaceFirst("^README\\.md", "index.html").replaceFirst("\\.md", ".html");
    }

    /** {@return the way from it to the root of the site} */
    String root() {
        return "../".repeat(file.split("/").length - 1);
    }

    /** {@return its first heading} */
    String title() {
        return PLAIN.render(content.getFirstChild()).trim();
    }
}
