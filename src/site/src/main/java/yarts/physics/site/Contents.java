package yarts.physics.site;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The table of contents of a long page: links to its headings of levels 2 and 3. */
final class Contents {
    /** Pages with fewer headings are short, and have no table of contents. */
    static final int LONG = 5;

    private static final Pattern HEADING = Pattern.compile("<h([23]) id=\"([^\"]+)\">(.*?)</h\\1>", Pattern.DOTALL);
    private static final Pattern TITLE = Pattern.compile("</h1>\\s*(<p>.*?</p>\\s*)?", Pattern.DOTALL);

    private Contents() {}

    /**
     * {@return a page's HTML with a table of contents after its first paragraph; unchanged if the page is short or has its own
     * list of links}
     */
    static String addTo(String html) {
        List<String> items = new ArrayList<>();
        Matcher heading = HEADING.matcher(html);
        while (heading.find()) {
            String text = heading.group(3).replaceAll("</?a\\b[^>]*>", "");
            items.add("<li class=\"level" + heading.group(1) + "\"><a href=\"#" + heading.group(2) + "\">" + text
                    + "</a></li>\n");
        }
        Matcher title = TITLE.matcher(html);
        if (items.size() < LONG || hasOwn(html) || !title.find()) return html;
        String list = "<nav class=\"contents\" aria-label=\"On this page\">\n<p>On this page</p>\n<ul>\n"
                + String.join("", items) + "</ul>\n</nav>\n";
        return html.substring(0, title.end()) + list + html.substring(title.end());
    }

    /** Whether many links to its places stand before its first heading. */
    static boolean hasOwn(String html) {
        return html.replaceFirst("(?s)<h2.*", "").split("href=\"#").length > LONG;
    }
}
