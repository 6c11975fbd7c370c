package yarts.physics.demo;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.DelegatingProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * The demo: {@code mvn -q test-compile exec:java}, with options such as {@code -Dexec.args=--window}.
 */
@Command(
        name = "demo",
        sortOptions = false,
        description = "Prints the jitters, plays a skirmish of 2 x 1,000 tanks, and draws plots and a film.")
public final class Demo implements Callable<Integer> {
    private static final int TANKS_PER_ARMY = 1000;
    private static final int SECONDS = 20;
    private static final int FILMED_TANKS_PER_ARMY = 480, FRAMES = 160;
    private static final long SEED = 1;
    private static final int LINE = 79; // characters

    @Option(names = "--window", description = "Only play the skirmish live, in a window.")
    private boolean window;

    @Option(
            names = "--images",
            paramLabel = "DIR",
            description = "Only draw the pictures of the docs, into this folder.")
    private Path images;

    @Option(names = "--help", usageHelp = true, description = "Show this help.")
    @SuppressWarnings("unused") // picocli reads it
    private boolean help;

    public static void main(String[] args) {
        int exit = new CommandLine(new Demo()).execute(args);
        if (exit != 0) System.exit(exit);
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (window) {
            if (GraphicsEnvironment.isHeadless()) {
                System.err.println("There is no display for a window. Without --window, the demo needs no display.");
                return 1;
            }
            SkirmishWindow.show(() -> new Skirmish(TANKS_PER_ARMY, SEED));
            return 0;
        }
        System.setProperty("java.awt.headless", "true");
        if (images != null) {
            draw(images);
            return 0;
        }
        JitterTable.print(System.out);
        System.out.println();
        Path folder = Path.of("target", "demo");
        draw(folder).report(System.out);
        System.out.printf(
                "%nThe pictures are in %s: jitter.png, terminal-speed.png, motor.png, skirmish.png, skirmish.gif%n",
                folder);
        return 0;
    }

    private static SkirmishRun draw(Path folder) throws IOException {
        Files.createDirectories(folder);
        Plots.jitter(folder.resolve("jitter.png"));
        Plots.terminalSpeed(folder.resolve("terminal-speed.png"));
        Plots.motor(folder.resolve("motor.png"));
        SkirmishRun run = new SkirmishRun(new Skirmish(TANKS_PER_ARMY, SEED));
        int ticks = SECONDS * Skirmish.TICKS_PER_SECOND;
        try (ProgressBar bar = progress(ticks + FRAMES)) {
            run.play(ticks, bar::step);
            run.draw(folder.resolve("skirmish.png"));
            new SkirmishFilm(FILMED_TANKS_PER_ARMY, SEED).shoot(folder.resolve("skirmish.gif"), FRAMES, bar::step);
        }
        return run;
    }

    /** A bar on a terminal; otherwise, as in a log, a line every few seconds. */
    @SuppressWarnings("SystemConsoleNull") // from JDK 22 to 24, it is never null, and a log gets the bar
    private static ProgressBar progress(int ticks) {
        ProgressBarBuilder bar = new ProgressBarBuilder()
                .setTaskName("Skirmish")
                .setUnit(" ticks", 1)
                .setInitialMax(ticks)
                .setStyle(ProgressBarStyle.ASCII);
        if (System.console() != null) {
            bar.setUpdateIntervalMillis(100).setConsumer(new ConsoleProgressBarConsumer(System.out, LINE));
        } else {
            Set<String> printed = new HashSet<>(); // because the last line comes twice
            Consumer<String> log = line -> {
                if (printed.add(line)) System.out.println(line);
            };
            bar.setUpdateIntervalMillis(5000).setConsumer(new DelegatingProgressBarConsumer(log, LINE));
        }
        return bar.build();
    }
}
