package yarts.physics.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.Rectangle;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.interactions.PointerInput;
import org.openqa.selenium.interactions.Sequence;
import org.openqa.selenium.logging.LogEntry;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.support.ui.Select;
import yarts.physics.Integrator;
import yarts.physics.demo.Skirmish;

/** The page works in a browser as its text says, and plays the same games as this JVM, to the bit. */
@Tag("long")
class SkirmishPageTest {
    private static final Path PAGE =
            Path.of(System.getProperty("site"), "skirmish", "index.html").normalize();
    private static final Path SCREENSHOTS =
            Path.of(System.getProperty("screenshots")).normalize();

    private ChromeDriver chromium;

    private void openOnDesktop() {
        open(1280, 1000);
    }

    private void openOnPhone() {
        open(390, 844);
    }

    private void open(int width, int height) {
        chromium = Programs.chromium(width, height);
        load();
    }

    private void load() {
        chromium.get(PAGE.toUri().toString());
        until(() -> number("tick") > 0);
    }

    /** No test may leave a message on the console. */
    @AfterEach
    void closeAQuietBrowser() {
        if (chromium == null) return;
        try {
            List<LogEntry> console =
                    chromium.manage().logs().get(LogType.BROWSER).getAll();
            assertEquals("", console.stream().map(LogEntry::getMessage).collect(Collectors.joining("\n")));
        } finally {
            chromium.quit();
        }
    }

    @Test
    void itMoves() throws IOException {
        openOnDesktop();
        String naive = picture("naive"), library = picture("library");
        until(() -> number("tick") >= 20 * 30);
        assertTrue(!picture("naive").equals(naive) && !picture("library").equals(library));
        assertTrue(number("fps") > 0, text("fps")); // 60 on an idle machine
        screenshot("desktop");
        System.out.println("The page draws " + text("fps") + " frames/s; its script takes, in ms for each: " + work());
    }

    /** {@return the time that the page's script takes for a frame} */
    private Object work() {
        chromium.manage().timeouts().scriptTimeout(Duration.ofMinutes(1));
        return chromium.executeAsyncScript("const done = arguments[0], real = window.requestAnimationFrame, ms = [];"
                + "window.requestAnimationFrame = f => real(t => { const start = performance.now(); f(t);"
                + "ms.push(performance.now() - start); if (ms.length == 120) { ms.sort((a, b) => a - b);"
                + "done('median ' + ms[60].toFixed(1) + ', 95% below ' + ms[114].toFixed(1)); } })");
    }

    @Test
    void theNaiveRuleJittersWhereZIsAbove1AndTheLibraryDoesNot() throws IOException {
        openOnDesktop();
        slide("friction", 55);
        slide("rate", 30);
        assertEquals("1.83", text("z"));
        until(() -> number("tick") >= 8 * 30 && number("naive-jitters") > 100);
        assertFew("library-jitters");
        screenshot("jitters");
        slide("friction", 27);
        assertEquals("0.90", text("z"));
        until(() -> number("naive-jitters") == 0);
        assertFew("naive-jitters");
        slide("rate", 10);
        assertEquals("2.70", text("z"));
        until(() -> number("naive-jitters") > 900);
        assertFew("library-jitters");
        screenshot("grows");
    }

    /** Under every rule, neighbours may push a tank to and fro for a moment. */
    private void assertFew(String readout) {
        for (int i = 0; i < 100; i++) assertTrue(number(readout) <= 4, text(readout) + " at tick " + text("tick"));
    }

    /** It follows that two loads of the page play the same too. */
    @Test
    void thePageAndThisJvmPlayTheSame() {
        openOnDesktop();
        for (Integrator integrator : Integrator.values()) {
            load();
            new Select(chromium.findElement(By.id("integrator"))).selectByVisibleText(integrator.name());
            slide("rate", 60);
            chromium.findElement(By.id("restart")).click();
            until(() -> number("library-tick") >= 420);
            String[] shown = text("library-tick", "naive-hash", "library-hash").split(" ");
            int tick = Integer.parseInt(shown[0]);
            assertEquals(hash(tick, true, integrator, 40, 60, game -> {}), shown[1]);
            assertEquals(hash(tick, false, integrator, 40, 60, game -> {}), shown[2]);
            System.out.println(integrator + " at tick " + tick + ": naive " + shown[1] + ", library " + shown[2]);
        }
    }

    @Test
    void aClickIsABlastInBoth() {
        openOnDesktop();
        assertBlast(
                "naive",
                -160,
                (canvas, right) -> new Actions(chromium)
                        .moveToElement(canvas, right, 10)
                        .click()
                        .perform());
    }

    @Test
    void aTapIsABlastInBoth() {
        openOnPhone();
        PointerInput finger = new PointerInput(PointerInput.Kind.TOUCH, "finger");
        assertBlast(
                "library",
                -100,
                (canvas, right) -> chromium.perform(List.of(new Sequence(finger, 0)
                        .addAction(finger.createPointerMove(
                                Duration.ZERO, PointerInput.Origin.fromElement(canvas), right, 10))
                        .addAction(finger.createPointerDown(PointerInput.MouseButton.LEFT.asArg()))
                        .addAction(finger.createPointerUp(PointerInput.MouseButton.LEFT.asArg())))));
    }

    /** Presses a point of a canvas where tanks are: some pixels to the right of its centre, and 10 below it. */
    private void assertBlast(String field, int right, BiConsumer<WebElement, Integer> finger) {
        press(" ", "r", ".", ".", ".");
        String before = text("library-hash");
        assertEquals(hash(3, false, Integrator.EULER, 40, 30, game -> {}), before);
        WebElement canvas = chromium.findElement(By.id(field));
        chromium.executeScript("arguments[0].addEventListener('click', e => at = [e.offsetX, e.offsetY])", canvas);
        finger.accept(canvas, right);
        until(() -> !text("library-hash").equals(before));
        press(".");
        List<?> at = (List<?>) chromium.executeScript("return at");
        int width = canvas.getSize().width;
        assertEquals(width / 2.0 + right, (long) at.get(0), 1.5);
        double metres = Side.VIEW_WIDTH / width;
        double x = metres * (long) at.get(0) + Side.VIEW_X, y = metres * (long) at.get(1) + Side.VIEW_Y;
        Consumer<Skirmish> blast = game -> {
            if (game.world().getTick() == 3) game.blastAt(x, y);
        };
        assertEquals(hash(4, true, Integrator.EULER, 40, 30, blast), text("naive-hash"));
        assertEquals(hash(4, false, Integrator.EULER, 40, 30, blast), text("library-hash"));
    }

    @Test
    void keysDoWhatThePageSays() {
        openOnDesktop();
        press(" ");
        assertEquals("Play", text("pause"));
        long tick = number("tick");
        press(".");
        press(".");
        assertEquals(tick + 2, number("tick"));
        assertEquals(text("tick"), text("naive-tick"));
        press("r");
        assertEquals(0, number("naive-tick"));
        press(Keys.ARROW_UP, Keys.ARROW_UP, Keys.ARROW_DOWN, "+", "-");
        assertEquals("45 /s", text("friction-value"));
        press(Keys.ARROW_LEFT, Keys.ARROW_RIGHT, Keys.ARROW_LEFT);
        assertEquals("25 /s", text("rate-value"));
        assertEquals("1.80", text("z"));
        press("I");
        assertEquals("SEMI_IMPLICIT", chromium.executeScript("return document.getElementById('integrator').value"));
        for (int i = 0; i < 3; i++) press(".");
        assertEquals(hash(3, true, Integrator.SEMI_IMPLICIT, 45, 25, game -> {}), text("naive-hash"));
        chromium.findElement(By.id("restart")).click();
        press(" "); // continues; does not press the button again
        assertEquals("Pause", text("pause"));
        until(() -> number("tick") > 5);
    }

    @Test
    void aPhoneShowsItAllInOneColumn() throws IOException {
        openOnPhone();
        assertEquals(390L, chromium.executeScript("return document.documentElement.scrollWidth"));
        assertEquals(390L, chromium.executeScript("return document.documentElement.clientWidth"));
        WebElement naive = chromium.findElement(By.id("naive")), library = chromium.findElement(By.id("library"));
        assertEquals(naive.getRect().x, library.getRect().x);
        assertTrue(naive.getRect().y + naive.getRect().height < library.getRect().y);
        assertTrue(naive.getRect().width > 350);
        until(() -> number("tick") >= 20 * 30);
        screenshot("phone");
        chromium.executeScript("window.scrollTo(0, document.body.scrollHeight)");
        screenshot("phone-end");
    }

    @Test
    void theLegendAndTheControlsAreVisibleWithoutScrolling() {
        open(1280, 800);
        for (String id : List.of("legend", "naive", "library", "friction", "pause", "integrator")) {
            int bottom = bottom(id);
            assertTrue(bottom <= 800, id + " ends at " + bottom);
        }
    }

    private int bottom(String id) {
        Rectangle place = chromium.findElement(By.id(id)).getRect();
        return place.y + place.height;
    }

    /** The two games are side by side or one below the other. */
    @Test
    void theTextDoesNotDependOnTheLayout() {
        openOnPhone();
        String text = (String) chromium.executeScript("return document.body.textContent");
        assertFalse(text.matches("(?is).*\\b(left|right|beside|above it|below it)\\b.*"), text);
    }

    /** {@return the hash after some ticks on this JVM} */
    private static String hash(
            int ticks, boolean naive, Integrator integrator, int friction, int rate, Consumer<Skirmish> beforeTick) {
        Skirmish game = new Skirmish(Side.TANKS_PER_ARMY, Side.SEED);
        game.setNaive(naive);
        game.setFriction(friction);
        game.setTicksPerSecond(rate);
        game.setIntegrator(integrator);
        while (game.world().getTick() < ticks) {
            beforeTick.accept(game);
            game.tick();
        }
        return String.format("%016x", game.stateHash());
    }

    private void until(BooleanSupplier condition) {
        Programs.until(chromium, condition);
    }

    private void press(CharSequence... keys) {
        new Actions(chromium).sendKeys(keys).perform();
    }

    private void slide(String slider, int value) {
        chromium.executeScript(
                "const s = document.getElementById(arguments[0]); s.value = arguments[1]; s.dispatchEvent(new Event('input'))",
                slider,
                value);
    }

    /** {@return the texts of some elements at one moment} */
    private String text(Object... ids) {
        return (String) chromium.executeScript(
                "return [...arguments].map(id => document.getElementById(id).textContent).join(' ')", ids);
    }

    private long number(String id) {
        String text = text(id);
        return text.matches("\\d+") ? Long.parseLong(text) : 0;
    }

    private String picture(String canvas) {
        return (String) chromium.executeScript("return document.getElementById(arguments[0]).toDataURL()", canvas);
    }

    private void screenshot(String name) throws IOException {
        Files.createDirectories(SCREENSHOTS);
        Files.write(SCREENSHOTS.resolve(name + ".png"), chromium.getScreenshotAs(OutputType.BYTES));
    }
}
