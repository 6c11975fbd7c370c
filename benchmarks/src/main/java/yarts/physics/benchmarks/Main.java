package yarts.physics.benchmarks;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.format.ResultFormatType;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * Runs and reports the benchmarks, from the root of the checkout.
 *
 * <pre>{@code
 * java -jar benchmarks/target/benchmarks.jar all     all benchmarks; writes benchmarks/results/<os>-<cpu>-jdk<version>
 * java -jar benchmarks/target/benchmarks.jar quick   10,000 units, briefly; writes to benchmarks/target
 * java -jar benchmarks/target/benchmarks.jar report  writes benchmarks/results into docs/benchmarks.md and its plot
 * java -jar benchmarks/target/benchmarks.jar limit   seven numbers for a comparison with a loop in C
 * }</pre>
 *
 * <p>After {@code limit}, an integrator and names of numbers may follow: {@code limit euler both}.
 *
 * <p>After {@code all} and {@code quick}, options of JMH may follow. All other arguments are passed to JMH; {@code -h}
 * lists its options.
 */
public final class Main {
    private static final Path RESULTS = Path.of("benchmarks", "results");
    private static final Path TARGET = Path.of("benchmarks", "target");

    /** The folder of the JVM, which is removed from results that are published. */
    private static final String FOLDER_OF_JVM = "(\"jvm\" : \")[^\"]*[/\\\\](?=[^\"]*\")";

    private Main() {}

    /**
     * Runs a command.
     *
     * @param args the command, or options of JMH
     */
    public static void main(String[] args) throws Exception {
        switch (args.length == 0 ? "-h" : args[0]) {
            case "all":
                run(RESULTS.resolve(name()), options(args));
                break;
            case "quick":
                TimeValue brief = TimeValue.milliseconds(200);
                run(
                        TARGET.resolve("quick-" + name()),
                        options(args)
                                .param("units", "10000")
                                .forks(1)
                                .warmupIterations(3)
                                .warmupTime(brief)
                                .measurementIterations(3)
                                .measurementTime(brief));
                break;
            case "report":
                Report.write(RESULTS, Path.of("docs"));
                break;
            case "limit":
                Limit.main(args);
                break;
            default:
                org.openjdk.jmh.Main.main(args.length == 0 ? new String[] {"-h"} : args);
        }
    }

    private static ChainedOptionsBuilder options(String[] args) throws CommandLineOptionException {
        return new OptionsBuilder().parent(new CommandLineOptions(Arrays.copyOfRange(args, 1, args.length)));
    }

    private static String name() {
        String os = System.getProperty("os.name").split(" ")[0].toLowerCase(Locale.ROOT);
        return os + "-" + System.getProperty("os.arch") + "-jdk"
                + Runtime.version().feature();
    }

    private static void run(Path name, ChainedOptionsBuilder options) throws Exception {
        if (!Files.isDirectory(TARGET)) {
            throw new IllegalStateException("run this in the root of the checkout: there is no " + TARGET);
        }
        Files.createDirectories(name.getParent());
        new Runner(options.shouldFailOnError(true)
                        .addProfiler(GCProfiler.class)
                        .resultFormat(ResultFormatType.JSON)
                        .result(name + ".json")
                        .build())
                .run();
        Path json = Path.of(name + ".json");
        Files.writeString(json, Files.readString(json).replaceAll(FOLDER_OF_JVM, "$1"));
        Files.writeString(Path.of(name + ".txt"), Machine.describe());
        System.out.println(Report.tables(List.of(new Results(json))));
    }
}
