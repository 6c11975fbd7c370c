package yarts.physics.benchmarks;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/** The results in a JSON file of JMH, per unit and step. */
final class Results {
    /** The number of steps in a call, if it is not one. */
    private static final Map<String, Integer> STEPS = Stream.of("advance", "steps", "advanceAlone", "stepsAlone")
            .collect(Collectors.toMap(name -> "GameBenchmark." + name, name -> GameBenchmark.STEPS));

    /**
     * A benchmark with its parameters.
     *
     * @param median of all measurements, in ns per unit and step
     * @param low the lower quartile
     * @param high the upper quartile
     * @param bytes allocated, per unit and step
     */
    record Row(String benchmark, Map<String, String> params, double median, double low, double high, double bytes) {
        int units() {
            return Integer.parseInt(params.get("units"));
        }
    }

    final Path file;
    private final List<Row> rows = new ArrayList<>();

    Results(Path file) throws IOException {
        this.file = file;
        for (JsonElement run : JsonParser.parseString(Files.readString(file)).getAsJsonArray()) {
            rows.add(row(run.getAsJsonObject()));
        }
    }

    private static Row row(JsonObject run) {
        String name = run.get("benchmark").getAsString().replaceFirst("^.*\\.(?=\\w+\\.\\w+$)", "");
        Map<String, String> params = new TreeMap<>();
        run.getAsJsonObject("params")
                .entrySet()
                .forEach(e -> params.put(e.getKey(), e.getValue().getAsString()));
        double calls = Double.parseDouble(params.get("units")) * STEPS.getOrDefault(name, 1);
        double[] ns =
                measurements(run.getAsJsonObject("primaryMetric")).sorted().toArray();
        double bytes = measurements(run.getAsJsonObject("secondaryMetrics").getAsJsonObject("gc.alloc.rate.norm"))
                .average()
                .orElseThrow();
        return new Row(
                name,
                params,
                quantile(ns, 0.5) / calls,
                quantile(ns, 0.25) / calls,
                quantile(ns, 0.75) / calls,
                bytes / calls);
    }

    /** All measurements: the JSON has an array for each fork, with a number for each iteration. */
    private static DoubleStream measurements(JsonObject metric) {
        List<Double> all = new ArrayList<>();
        for (JsonElement fork : metric.getAsJsonArray("rawData")) {
            JsonArray iterations = fork.getAsJsonArray();
            iterations.forEach(iteration -> all.add(iteration.getAsDouble()));
        }
        return all.stream().mapToDouble(d -> d);
    }

    private static double quantile(double[] sorted, double q) {
        double at = q * (sorted.length - 1);
        int i = (int) at;
        return sorted[i] + (at - i) * (sorted[Math.min(i + 1, sorted.length - 1)] - sorted[i]);
    }

    /** The row of a benchmark with these parameters: name, value, name, value and so on. */
    Optional<Row> find(String benchmark, int units, String... params) {
        return rows.stream()
                .filter(row -> row.benchmark.equals(benchmark) && row.units() == units)
                .filter(row -> {
                    for (int i = 0; i < params.length; i += 2) {
                        if (!params[i + 1].equals(row.params.get(params[i]))) return false;
                    }
                    return true;
                })
                .findFirst();
    }

    /** The numbers of units in the results of all benchmarks, except ChangesBenchmark, which has only one number. */
    int[] sizes() {
        return rows.stream()
                .filter(row -> !row.benchmark.startsWith("ChangesBenchmark."))
                .mapToInt(Row::units)
                .distinct()
                .sorted()
                .toArray();
    }

    String name() {
        return file.getFileName().toString().replaceFirst("\\.json$", "");
    }

    /** {@return the JDK that the name ends with: "JDK 17"} */
    String jdk() {
        return "JDK " + name().replaceFirst(".*-jdk", "");
    }

    /** A description of the machine on which the benchmarks ran. */
    String machine() throws IOException {
        return Files.readString(file.resolveSibling(name() + ".txt"));
    }
}
