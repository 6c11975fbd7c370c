package yarts.physics.site;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The menu of all pages, in groups: pages for game programmers first, those for maintainers last. */
final class Menu {
    private static final String OTHERS = "Reference", MAINTAINERS = "For maintainers";

    /** The groups and the names of their pages, in order. {@code *} stands for a page that is not a document. */
    private static final Map<String, List<String>> GROUPS = new LinkedHashMap<>();

    static {
        GROUPS.put("Start", words("README *skirmish getting-started guide cookbook two-hundred-tanks troubleshooting"));
        GROUPS.put("In your game", words("engines adopting lockstep snapshots limits"));
        GROUPS.put("Background", words("physics jitters comparison benchmarks"));
        GROUPS.put(OTHERS, words("*api changelog"));
        GROUPS.put(MAINTAINERS, words("contributing quality source releasing"));
    }

    /** The pages that are not documents, and their titles. */
    private static final Map<String, String> BUILT = Map.of("*skirmish", "Skirmish, live", "*api", "Javadoc");

    private final Map<String, List<Page>> documents = new LinkedHashMap<>();

    /** Puts each page into its group. Pages without a place in the order come last in theirs. */
    Menu(List<Page> pages) {
        GROUPS.keySet().forEach(group -> documents.put(group, new ArrayList<>()));
        for (Page page : pages) documents.get(group(page)).add(page);
    }

    private static List<String> words(String text) {
        return List.of(text.split(" "));
    }

    private static String group(Page page) {
        if (page.file().startsWith("docs/maintainers/")) return MAINTAINERS;
        return GROUPS.entrySet().stream()
                .filter(group -> group.getValue().contains(page.name()))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(OTHERS);
    }

    /** {@return the menu as HTML, as a page shows it} */
    String html(Page here) {
        StringBuilder html = new StringBuilder();
        GROUPS.forEach((group, names) -> {
            html.append("<p>").append(group).append("</p>\n<ul>\n");
            List<Page> left = new ArrayList<>(documents.get(group));
            left.sort(Comparator.comparing(Page::file));
            for (String name : names) {
                if (BUILT.containsKey(name)) {
                    html.append(item(here, name.substring(1) + "/index.html", "", BUILT.get(name)));
                }
                left.stream().filter(page -> page.name().equals(name)).forEach(page -> html.append(item(here, page)));
                left.removeIf(page -> page.name().equals(name));
            }
            for (Page page : left) html.append(item(here, page));
            html.append("</ul>\n");
        });
        return html.toString();
    }

    private static String item(Page here, Page page) {
        return item(here, page.html(), page == here ? " aria-current=\"page\"" : "", page.title());
    }

    private static String item(Page here, String to, String attribute, String text) {
        return "<li><a href=\"" + here.root() + to + '"' + attribute + '>' + text + "</a></li>\n";
    }
}
