package yarts.physics.web;

import static org.junit.jupiter.api.Assumptions.abort;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;
import org.openqa.selenium.support.ui.WebDriverWait;

/** The programs that run code compiled for the web. They come from the PATH; tests whose program is missing are skipped. */
final class Programs {
    private static final Duration PATIENCE = Duration.ofMinutes(2), POLL = Duration.ofMillis(20);

    /** Warns that it does not know the version of Chromium; nothing here depends on that. */
    private static final Logger SELENIUM = Logger.getLogger("org.openqa.selenium");

    private Programs() {}

    /** {@return the first of some names that is on the PATH} */
    static Path find(String... names) {
        for (String name : names) {
            for (String folder : System.getenv("PATH").split(File.pathSeparator)) {
                Path program = Path.of(folder).resolve(name);
                if (Files.isExecutable(program)) return program;
            }
        }
        String missing = "no " + String.join(" or ", names) + " on the PATH";
        System.out.println(missing + ": its tests are skipped");
        return abort(missing);
    }

    /** {@return a headless Chromium; it emulates a phone if the width is below 600 pixels} */
    static ChromeDriver chromium(int width, int height) {
        Path chromium = find("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome");
        ChromeOptions options = new ChromeOptions();
        options.setBinary(chromium.toFile());
        options.addArguments("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run");
        options.addArguments("--disable-background-networking", "--disable-component-update", "--disable-sync");
        options.addArguments("--window-size=" + width + "," + height);
        if (width < 600) {
            Map<String, Object> screen = Map.of("width", width, "height", height, "pixelRatio", 3.0, "touch", true);
            options.setExperimentalOption("mobileEmulation", Map.of("deviceMetrics", screen));
        }
        SELENIUM.setLevel(Level.SEVERE);
        LoggingPreferences logs = new LoggingPreferences();
        logs.enable(LogType.BROWSER, Level.ALL);
        options.setCapability(ChromeOptions.LOGGING_PREFS, logs);
        ChromeDriverService service = new ChromeDriverService.Builder()
                .usingDriverExecutable(find("chromedriver").toFile())
                .build();
        return new ChromeDriver(service, options);
    }

    /** Waits until a condition is true. */
    static void until(ChromeDriver chromium, BooleanSupplier condition) {
        new WebDriverWait(chromium, PATIENCE, POLL).until(driver -> condition.getAsBoolean());
    }

    /** {@return the output of a script in node} */
    static String node(String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(find("node").toString()));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        try {
            process.getOutputStream().close();
            String text = new String(process.getInputStream().readAllBytes()).trim();
            return process.waitFor() == 0 ? text : "node ended with " + process.exitValue() + ": " + text;
        } finally {
            process.destroy();
        }
    }
}
