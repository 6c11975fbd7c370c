package yarts.physics.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import yarts.physics.Integrator;
import yarts.physics.benchmarks.Results.Row;

/** Writes results as Markdown tables, and draws the plot. */
final class Report {
    private static final String START = "<!-- results -->", END = "<!-- end of results -->";
    private static final int GAME = 10_000; // units
    private static final List<Integer> SIZES = List.of(GAME, 100_000, 1_000_000),
            FEWER_SIZES = List.of(GAME, 1_000_000);
    private static final double FRAME = 1e9 / 60; // ns

    /** A line of a table: a label, and which benchmark it is with which parameters. */
    record Line(String label, String benchmark, String... params) {
        Optional<Row> in(Results results, int units) {
            return results.find(benchmark, units, params);
        }
    }

    /** A column after the times, for the first results and 10,000 units. */
    private record Column(String head, Function<Row, String> cell) {}

    private Report() {}

    /** Puts the tables into docs/benchmarks.md, and the plot of the first results beside it. */
    static void write(Path results, Path docs) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.list(results)) {
            files = all.filter(file -> file.toString().endsWith(".json"))
                    .sorted()
                    .collect(Collectors.toList());
        }
        if (files.isEmpty()) throw new IllegalStateException("no results in " + results);
        List<Results> all = new ArrayList<>();
        for (Path file : files) all.add(new Results(file));
        Path page = docs.resolve("benchmarks.md");
        String old = Files.readString(page);
        int start = old.indexOf(START), end = old.indexOf(END);
        if (start < 0 || end < start) throw new IllegalStateException(page + " has no " + START + " ... " + END);
        String text = START + "\n\n" + tables(all) + END;
        Files.writeString(page, old.substring(0, start) + text + old.substring(end + END.length()));
        Plot.draw(all.get(0), docs.resolve("images").resolve("benchmarks.png"));
    }

    /** The library's integrators, then the peers. */
    static List<Line> contest() {
        List<Line> lines = new ArrayList<>();
        for (Integrator integrator : Integrator.values()) {
            lines.add(exact("yarts-physics, " + integrator, "StepBenchmark.both", integrator));
        }
        for (Peers peer : Peers.values()) lines.add(peer(peer));
        return lines;
    }

    private static Line peer(Peers peer) {
        return new Line(peer.label, "PeerBenchmark.both", "peer", peer.name());
    }

    private static Line exact(String label, String benchmark) {
        return exact(label, benchmark, Integrator.EXACT);
    }

    private static Line exact(String label, String benchmark, Integrator integrator) {
        return new Line(label, benchmark, "integrator", integrator.name());
    }

    private static List<Line> operations() {
        return List.of(
                exact("step, no forces", "StepBenchmark.step"),
                new Line("step, all units at rest", "UnitsBenchmark.atRest"),
                new Line("step, no forces, two threads", "ThreadsBenchmark.step", "threads", "2"),
                exact("step, another dt in each step", "StepBenchmark.changingDt"),
                exact("step, a motor on every unit", "MotorBenchmark.stepWithMotors"),
                exact("`applyForce` on every unit", "StepBenchmark.force"),
                exact("`applyForces` and a step", "StepBenchmark.bulk"),
                new Line("`applyForce` on every unit and `advance` by 1/60 s", "GameBenchmark.advanceAt60"),
                new Line("`applyForce` on every unit in random order, and a step", "UnitsBenchmark.shuffled"),
                exact("`setMotor`", "MotorBenchmark.setMotor"),
                new Line("`new Unit`", "GameBenchmark.create"),
                new Line("`remove` and `add`", "GameBenchmark.removeAndAdd"),
                new Line("`save`", "GameBenchmark.save"),
                new Line("`restore`", "GameBenchmark.restore"),
                new Line("`stateHash`", "GameBenchmark.stateHash"),
                new Line("positions by `getInterpolatedX`, `getInterpolatedY`", "GameBenchmark.getters"),
                new Line("positions by `copyPositions`", "GameBenchmark.copyPositions"));
    }

    /** The tables of results from one machine, each with columns for each of its JDKs. */
    static String tables(List<Results> all) throws IOException {
        Results first = all.get(0);
        StringBuilder out = new StringBuilder();
        Set<String> machine = new LinkedHashSet<>();
        for (Results results : all) results.machine().lines().forEach(machine::add);
        for (String line : machine) out.append("- ").append(line).append('\n');
        out.append("\n## A force on every unit and a step\n\n");
        Optional<Row> list = peer(Peers.OBJECT_LIST).in(first, GAME);
        table(
                out,
                all,
                SIZES,
                contest(),
                new Column(
                        "÷ list",
                        row -> list.map(r -> number(row.median() / r.median())).orElse("")),
                new Column("of a frame", row -> percent(row.median() * GAME / FRAME)),
                new Column("bytes", row -> bytes(row.bytes())));
        out.append("\n## Other operations\n\n");
        table(out, all, FEWER_SIZES, operations(), new Column("bytes", row -> bytes(row.bytes())));
        return out.append('\n').append(spread(all)).append("\n\n").toString();
    }

    private static void table(
            StringBuilder out, List<Results> all, List<Integer> sizes, List<Line> lines, Column... more) {
        List<String> head = new ArrayList<>(List.of(""));
        for (Results results : all) {
            for (int units : sizes) {
                if (lines.stream().anyMatch(line -> line.in(results, units).isPresent())) {
                    head.add(results.jdk() + ": " + String.format(Locale.ROOT, "%,d", units));
                }
            }
        }
        int times = head.size();
        for (Column column : more) head.add(column.head);
        cells(out, head);
        cells(
                out,
                IntStream.range(0, head.size())
                        .mapToObj(i -> i == 0 ? "---" : "--:")
                        .collect(Collectors.toList()));
        for (Line line : lines) {
            List<String> cells = new ArrayList<>(List.of(line.label));
            for (Results results : all) {
                for (int units : sizes) {
                    if (!head.subList(1, times)
                            .contains(results.jdk() + ": " + String.format(Locale.ROOT, "%,d", units))) continue;
                    cells.add(line.in(results, units)
                            .map(row -> number(row.median()))
                            .orElse(""));
                }
            }
            Optional<Row> game = line.in(all.get(0), GAME);
            for (Column column : more) cells.add(game.map(column.cell).orElse(""));
            cells(out, cells);
        }
    }

    private static void cells(StringBuilder out, List<String> cells) {
        out.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    /** How far the quartiles of all that the tables contain are from their medians. */
    private static String spread(List<Results> all) {
        List<Line> lines = new ArrayList<>(contest());
        lines.addAll(operations());
        double[] spreads = all.stream()
                .flatMap(results ->
                        lines.stream().flatMap(line -> SIZES.stream().flatMap(n -> line.in(results, n).stream())))
                .mapToDouble(row -> Math.max(row.high() / row.median() - 1, 1 - row.low() / row.median()))
                .sorted()
                .toArray();
        if (spreads.length == 0) return "";
        return "The quartiles are within " + percent(spreads[9 * (spreads.length - 1) / 10])
                + " of the median in nine of ten cases, and within " + percent(spreads[spreads.length - 1])
                + " in all.";
    }

    /** Three digits or so. */
    private static String number(double d) {
        return String.format(Locale.ROOT, d < 0.1 ? "%.3f" : d < 10 ? "%.2f" : d < 100 ? "%.1f" : "%,.0f", d);
    }

    private static String percent(double part) {
        return String.format(Locale.ROOT, part < 0.1 ? "%.1f %%" : "%.0f %%", 100 * part);
    }

    /** The measuring itself allocates some hundred bytes in a call or a few, whatever the number of units. */
    private static String bytes(double perUnit) {
        return perUnit < 0.1 ? "0" : String.format(Locale.ROOT, "%,.0f", perUnit);
    }
}
