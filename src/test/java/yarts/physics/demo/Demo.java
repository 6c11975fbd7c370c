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
 * Shows the physics at work: {@code mvn -q test-compile exec:java}, with options as in {@code -Dexec.args=--window}.
 */
@Command(
        name = "demo",
        sortOptions = false,
        description = "Prints the jitters, plays a skirmish of 2 x 1,000 tanks, and draws both.")
public final class Demo implements Callable<Integer> {
    private static final int TANKS_AN_ARMY = 1000;
    private static final int SECONDS = 20;
    private static final long SEED = 1;
    private static final int LINE = 79; // characters

    @Option(names = "--window", description = "Play the skirmish live, in a window, and do nothing else.")
    private boolean window;

    @Option(names = "--images", paramLabel = "DIR", description = "Draw the pictures of the docs, and do nothing else.")
    private Path images;

    @Option(names = "--help", usageHelp = true, description = "Show this help.")
    @SuppressWarnings("unused") // picocli looks at it
    private boolean help;

    public static void main(String[] args) {
        int exit = new CommandLine(new Demo()).execute(args);
        if (exit != 0) System.exit(exit);
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (window) {
            if (GraphicsEnvironment.isHeadless()) {
                System.err.println("There is no display to open a window on. Without --window, the demo needs none.");
                return 1;
            }
            SkirmishWindow.show(() -> new Skirmish(TANKS_AN_ARMY, SEED));
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
                "%nNow look at jitter.png, terminal-speed.png, motor.png, skirmish.png and skirmish.gif in %s%n",
                folder);
        return 0;
    }

    private static SkirmishFilm draw(Path folder) throws IOException {
        Files.createDirectories(folder);
        Plots.jitter(folder.resolve("jitter.png"));
        Plots.terminalSpeed(folder.resolve("terminal-speed.png"));
        Plots.motor(folder.resolve("motor.png"));
        SkirmishFilm film = new SkirmishFilm(new Skirmish(TANKS_AN_ARMY, SEED));
        int ticks = SECONDS * Skirmish.TICKS_PER_SECOND;
        try (ProgressBar bar = progress(ticks)) {
            film.shoot(folder, ticks, bar::step);
        }
        return film;
    }

    /** A bar on a terminal; elsewhere, such as in a log, a line every few seconds. */
    /** A bar that moves where somebody looks at it, or a line now and then. */
    @SuppressWarnings("SystemConsoleNull") // from JDK 22 to 24 it is never null, and logs get the bar
    private static ProgressBar progress(int ticks) {
        ProgressBarBuilder bar = new ProgressBarBuilder()
                .setTaskName("Skirmish")
                .setUnit(" ticks", 1)
                .setInitialMax(ticks)
                .setStyle(ProgressBarStyle.ASCII);
        if (System.console() != null) {
            bar.setUpdateIntervalMillis(100).setConsumer(new ConsoleProgressBarConsumer(System.out, LINE));
        } else {
            Set<String> printed = new HashSet<>(); // for the last line comes twice
            Consumer<String> log = line -> {
                if (printed.add(line)) System.out.println(line);
            };
            bar.setUpdateIntervalMillis(5000).setConsumer(new DelegatingProgressBarConsumer(log, LINE));
        }
        return bar.build();
    }
}
