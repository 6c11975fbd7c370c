package yarts.physics.comparison;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The tables of docs/comparison.md, between {@code <!-- table: name -->} and {@code <!-- end -->}: they hold what was
 * measured, or the test fails. With {@code -Ddocs.write} they are written.
 */
final class Page {
    private static final Path FILE = Path.of("docs/comparison.md");
    private static final String END = "<!-- end -->";

    private Page() {}

    /** Checks or writes a table. Rows with the same cells become one, under all of their names. */
    static void check(String name, List<String> head, Map<String, List<String>> rows) {
        Map<List<String>, String> merged = new LinkedHashMap<>();
        rows.forEach((row, cells) -> merged.merge(cells, row, (a, b) -> a + "<br>" + b));
        StringBuilder table = new StringBuilder();
        line(table, head.get(0), head.subList(1, head.size()));
        table.append("|---|").append("---|".repeat(head.size() - 1)).append('\n');
        merged.forEach((cells, row) -> line(table, row, cells));

        String page = read(), start = "<!-- table: " + name + " -->\n";
        int from = page.indexOf(start) + start.length(), to = page.indexOf(END, from);
        assertTrue(from >= start.length() && to >= 0, FILE + " has no table " + name);
        if (System.getProperty("docs.write") != null) {
            write(page.substring(0, from) + table + page.substring(to));
        } else {
            assertEquals(table.toString(), page.substring(from, to), FILE + ": -Ddocs.write writes it anew");
        }
    }

    private static void line(StringBuilder table, String first, List<String> cells) {
        table.append("| ")
                .append(first)
                .append(" | ")
                .append(String.join(" | ", cells))
                .append(" |\n");
    }

    /** Three digits: as many as engines with floats agree in on every machine. */
    static String number(double value) {
        return number(value, 3);
    }

    static String number(double value, int digits) {
        return plain(new BigDecimal(value).round(new MathContext(digits)));
    }

    /** How far a value is from what it should be: in percent, to a tenth. */
    static String error(double value, double expected) {
        BigDecimal percent = new BigDecimal(100 * (value / expected - 1)).setScale(1, RoundingMode.HALF_UP);
        return percent.signum() == 0 ? "0" : (percent.signum() > 0 ? "+" : "") + plain(percent) + " %";
    }

    private static String plain(BigDecimal value) {
        return value.signum() == 0
                ? "0"
                : value.stripTrailingZeros().toPlainString().replace('-', '−');
    }

    private static String read() {
        try {
            return Files.readString(FILE);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void write(String page) {
        try {
            Files.writeString(FILE, page);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
