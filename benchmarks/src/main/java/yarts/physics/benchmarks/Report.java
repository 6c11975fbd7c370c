package yarts.physics.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import yarts.physics.Integrator;
import yarts.physics.benchmarks.Results.Row;

/** Writes results as Markdown tables, and draws the plot. */
final class Report {
    private static final String START = "<!-- results -->", END = "<!-- end of results -->";
    private static final int GAME = 10_000; // units
    private static final double FRAME = 1e9 / 60; // ns

    /** A line of a table: a label, and which benchmark it is with which parameters. */
    record Line(String label, String benchmark, String... params) {
        Optional<Row> in(Results results, int units) {
            return results.find(benchmark, units, params);
        }
    }

    private static final Line OBJECT_LIST = peer(Peers.OBJECT_LIST);

    private Report() {}

    /** Puts the tables of every file of results into docs/benchmarks.md, and the first file's plot beside it. */
    static void write(Path results, Path docs) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.list(results)) {
            files = all.filter(file -> file.toString().endsWith(".json"))
                    .sorted()
                    .collect(Collectors.toList());
        }
        if (files.isEmpty()) throw new IllegalStateException("no results in " + results);
        StringBuilder text = new StringBuilder(START);
        for (Path file : files) text.append("\n\n").append(tables(new Results(file)));
        text.append(END);
        Path page = docs.resolve("benchmarks.md");
        String old = Files.readString(page);
        int start = old.indexOf(START), end = old.indexOf(END);
        if (start < 0 || end < start) throw new IllegalStateException(page + " has no " + START + " ... " + END);
        Files.writeString(page, old.substring(0, start) + text + old.substring(end + END.length()));
        Plot.draw(new Results(files.get(0)), docs.resolve("images").resolve("benchmarks.png"));
    }

    /** The library's integrators, then the peers. */
    static List<Line> contest() {
        List<Line> lines = new ArrayList<>(ours("yarts-physics, ", "both"));
        for (Peers peer : Peers.values()) lines.add(peer(peer));
        return lines;
    }

    private static Line peer(Peers peer) {
        return new Line(peer.label, "PeerBenchmark.both", "peer", peer.name());
    }

    private static List<Line> ours(String label, String method) {
        return Stream.of(Integrator.values())
                .map(integrator ->
                        new Line(label + integrator, "StepBenchmark." + method, "integrator", integrator.name()))
                .collect(Collectors.toList());
    }

    private static List<Line> workloads() {
        List<Line> lines = new ArrayList<>();
        lines.add(new Line("force on all, no step", "StepBenchmark.force", "integrator", "EULER"));
        lines.add(new Line("the same after each step", "StepBenchmark.forceAfterStep", "integrator", "EULER"));
        lines.add(new Line(
                "force on all by the world's iterator, no step",
                "StepBenchmark.forceByIterator",
                "integrator",
                "EULER"));
        lines.addAll(ours("force on all by `applyForces` and step, ", "bulk"));
        lines.addAll(ours("force on two in each tile and step, ", "twoInEachTile"));
        lines.addAll(ours("force on one in a thousand and step, ", "oneInAThousand"));
        lines.addAll(ours("step alone, ", "step"));
        lines.addAll(ours("dt changes every step, ", "changingDt"));
        for (String threads : new String[] {"1", "2"}) {
            lines.add(new Line("step alone, pool of " + threads, "ThreadsBenchmark.step", "threads", threads));
        }
        lines.add(new Line("12 times a force on all, 5 `step`s", "GameBenchmark.steps"));
        lines.add(new Line("the same in 12 `advance`s of 1/144 s", "GameBenchmark.advance"));
        lines.add(new Line("a force on all and an `advance` of 1/60 s", "GameBenchmark.advanceAt60"));
        lines.add(new Line("12 times a force on one unit, 5 `step`s", "GameBenchmark.stepsAlone"));
        lines.add(new Line("the same in 12 `advance`s of 1/144 s", "GameBenchmark.advanceAlone"));
        lines.add(new Line("all at rest, step alone", "UnitsBenchmark.atRest"));
        lines.add(new Line("force and step, no top speed", "UnitsBenchmark.uncapped"));
        lines.add(new Line("force and step, half at top speed", "UnitsBenchmark.halfCapped"));
        lines.add(new Line("force and step, after an hour of three units", "HistoryBenchmark.afterFew"));
        lines.add(new Line("force and step, shuffled heap", "UnitsBenchmark.scattered"));
        lines.add(new Line("the same, forces in shuffled order", "UnitsBenchmark.shuffled"));
        lines.add(new Line("step, 1 % removed and added", "GameBenchmark.churn"));
        lines.add(new Line("remove and add, no step", "GameBenchmark.removeAndAdd"));
        lines.add(new Line("remove, and add a new unit", "GameBenchmark.replace"));
        lines.add(new Line("`new Unit`", "GameBenchmark.create"));
        lines.add(new Line("`save`", "GameBenchmark.save"));
        lines.add(new Line("`restore`", "GameBenchmark.restore"));
        lines.add(new Line("one `restore`, after 400 others", "RestoreBenchmark.after400"));
        lines.add(new Line("`save`, 8 steps with forces, `restore`, `find`", "GameBenchmark.rollback"));
        lines.add(new Line("the same, 8 units added between", "GameBenchmark.rollbackWithSpawns"));
        lines.add(new Line("`stateHash`", "GameBenchmark.stateHash"));
        lines.add(new Line("positions, by getters", "GameBenchmark.getters"));
        lines.add(new Line("positions, by `copyPositions`", "GameBenchmark.copyPositions"));
        lines.add(new Line("positions in `double`, by `copyPositions`", "GameBenchmark.copyPositionsInFull"));
        lines.add(new Line("velocities, by `copyVelocities`", "GameBenchmark.copyVelocities"));
        return lines;
    }

    static String tables(Results results) throws IOException {
        StringBuilder out = new StringBuilder("### " + results.name() + "\n\n");
        results.machine().lines().forEach(line -> out.append("- ").append(line).append('\n'));

        out.append("\nA force on every unit and a step: ns per unit and step, median (quartiles).\n\n");
        String[] more = {"÷ list of objects", "of a 60 Hz frame", "bytes per unit", "what it cannot do"};
        head(out, results, "", more);
        for (Line line : contest()) {
            Optional<Row> game = line.in(results, GAME);
            Optional<Row> list = OBJECT_LIST.in(results, GAME);
            row(
                    out,
                    results,
                    line,
                    game.isPresent() && list.isPresent()
                            ? number(game.get().median() / list.get().median())
                            : "",
                    game.map(r -> percent(r.median() * GAME / FRAME)).orElse(""),
                    game.map(r -> bytes(r.bytes())).orElse(""),
                    lacks(line));
        }
        out.append("\n÷ list of objects and what follows it are for 10,000 units.\n");

        out.append("\nOther work, by EULER where nothing else is said: ns per unit and step, median (quartiles).\n\n");
        head(out, results, "", "bytes per unit");
        for (Line line : workloads()) {
            row(
                    out,
                    results,
                    line,
                    line.in(results, GAME).map(r -> bytes(r.bytes())).orElse(""));
        }

        changes(out, results);

        out.append("\nThe step alone, 10,000 units, with and without HotSpot's vectoriser: ns per unit and step.\n\n");
        out.append("|  | vectorised | `-XX:-UseSuperWord` | ratio |\n| --- | --: | --: | --: |\n");
        for (Integrator integrator : Integrator.values()) {
            for (boolean changing : new boolean[] {false, true}) {
                String[] params = {"integrator", integrator.name(), "changingDt", Boolean.toString(changing)};
                Optional<Row> fast = results.find("VectorisedBenchmark.vectorised", GAME, params);
                Optional<Row> slow = results.find("VectorisedBenchmark.scalar", GAME, params);
                if (fast.isEmpty() || slow.isEmpty()) continue;
                cells(
                        out,
                        integrator + (changing ? ", dt changes every step" : ""),
                        spread(fast.get()),
                        spread(slow.get()),
                        number(slow.get().median() / fast.get().median()));
            }
        }
        return out.append('\n').toString();
    }

    private static void changes(StringBuilder out, Results results) {
        List<String> names = new ArrayList<>(), cells = new ArrayList<>();
        for (ChangesBenchmark.Change change : ChangesBenchmark.Change.values()) {
            results.find("ChangesBenchmark.tick", ChangesBenchmark.WORLD, "change", change.name())
                    .ifPresent(row -> {
                        names.add(change.label);
                        cells.add(spread(row));
                    });
        }
        if (names.isEmpty()) return;
        out.append("\nTen changes before each step, 5,000 units, EXACT: ns per unit and step, median (quartiles).\n\n");
        cells(out, names.toArray(new String[0]));
        cells(out, names.stream().map(name -> "--:").toArray(String[]::new));
        cells(out, cells.toArray(new String[0]));
    }

    private static String lacks(Line line) {
        for (Peers peer : Peers.values()) if (peer.label.equals(line.label)) return peer.lacks();
        return "";
    }

    private static void head(StringBuilder out, Results results, String first, String... more) {
        List<String> cells = new ArrayList<>(List.of(first));
        for (int units : results.sizes()) cells.add(String.format(Locale.ROOT, "%,d units", units));
        cells.addAll(List.of(more));
        cells(out, cells.toArray(new String[0]));
        cells(
                out,
                IntStream.range(0, cells.size())
                        .mapToObj(i -> i == 0 ? "---" : "--:")
                        .toArray(String[]::new));
    }

    private static void row(StringBuilder out, Results results, Line line, String... more) {
        List<String> cells = new ArrayList<>(List.of(line.label));
        for (int units : results.sizes()) {
            cells.add(line.in(results, units).map(Report::spread).orElse(""));
        }
        cells.addAll(List.of(more));
        cells(out, cells.toArray(new String[0]));
    }

    private static void cells(StringBuilder out, String... cells) {
        out.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    private static String spread(Row row) {
        return number(row.median()) + " (" + number(row.low()) + "–" + number(row.high()) + ")";
    }

    /** Three digits or so. */
    private static String number(double d) {
        return String.format(Locale.ROOT, d < 0.1 ? "%.4f" : d < 10 ? "%.2f" : d < 100 ? "%.1f" : "%,.0f", d);
    }

    private static String percent(double part) {
        return String.format(Locale.ROOT, part < 0.1 ? "%.2f %%" : "%.0f %%", 100 * part);
    }

    /** The measuring itself allocates some hundred bytes in a call or a few, whatever the number of units. */
    private static String bytes(double perUnit) {
        return perUnit < 0.1 ? "0" : String.format(Locale.ROOT, "%.0f", perUnit);
    }
}
