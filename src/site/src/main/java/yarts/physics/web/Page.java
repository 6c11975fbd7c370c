package yarts.physics.web;

import org.teavm.jso.browser.Window;
import org.teavm.jso.dom.events.EventListener;
import org.teavm.jso.dom.events.KeyboardEvent;
import org.teavm.jso.dom.events.MouseEvent;
import org.teavm.jso.dom.html.HTMLDocument;
import org.teavm.jso.dom.html.HTMLElement;
import org.teavm.jso.dom.html.HTMLInputElement;
import org.teavm.jso.dom.html.HTMLSelectElement;
import yarts.physics.Integrator;

/**
 * The page: one skirmish twice, by the naive rule and by the library, at the same ticks. The page keeps the time for both
 * games, so the state at a tick depends only on the inputs, not on the times of the frames.
 */
public final class Page {
    /** Longer frames count as this long; in seconds. */
    private static final double LONGEST_FRAME = 0.25;

    /** Ticks from one hash to the next. */
    private static final int HASHED = 60;

    private static final HTMLDocument PAGE = HTMLDocument.current();

    private final HTMLInputElement friction = (HTMLInputElement) PAGE.getElementById("friction");
    private final HTMLInputElement rate = (HTMLInputElement) PAGE.getElementById("rate");
    private final HTMLSelectElement integrator = (HTMLSelectElement) PAGE.getElementById("integrator");
    private final Side[] sides = {new Side("naive", true, this::blastAt), new Side("library", false, this::blastAt)};

    private boolean paused;
    private double last;
    /** The time since the last tick; in ticks. */
    private double rest;

    private int frames;
    private double counted;

    private Page() {}

    public static void main(String[] args) {
        new Page().run();
    }

    private void run() {
        for (HTMLElement control : new HTMLElement[] {friction, rate, integrator}) {
            control.addEventListener("input", e -> set());
        }
        onPress("pause", this::pause);
        onPress("step", this::stepOnce);
        onPress("restart", this::restart);
        PAGE.addEventListener("keydown", (EventListener<KeyboardEvent>) this::key);
        restart();
        Window.requestAnimationFrame(this::frame);
    }

    private static void onPress(String button, Runnable action) {
        HTMLElement element = PAGE.getElementById(button);
        element.addEventListener("click", (EventListener<MouseEvent>) e -> {
            if (e.getDetail() > 0) element.blur(); // so that the space bar does not press it again
            action.run();
        });
    }

    private void key(KeyboardEvent e) {
        if (e.isCtrlKey() || e.isAltKey() || e.isMetaKey()) return;
        String on = ((HTMLElement) e.getTarget()).getTagName();
        boolean arrow = e.getKey().startsWith("Arrow");
        if (arrow && !on.equals("BODY") || e.getKey().equals(" ") && on.equals("BUTTON"))
            return; // the control handles the key itself
        switch (e.getKey()) {
            case " ":
                pause();
                break;
            case ".":
                stepOnce();
                break;
            case "r", "R":
                restart();
                break;
            case "i", "I":
                integrator.setSelectedIndex((integrator.getSelectedIndex() + 1) % Integrator.values().length);
                set();
                break;
            case "ArrowUp":
            case "+":
                move(friction, 5);
                break;
            case "ArrowDown":
            case "-":
                move(friction, -5);
                break;
            case "ArrowRight":
                move(rate, 5);
                break;
            case "ArrowLeft":
                move(rate, -5);
                break;
            default:
                return;
        }
        e.preventDefault();
    }

    private void move(HTMLInputElement slider, int by) {
        slider.setValue(String.valueOf(Integer.parseInt(slider.getValue()) + by)); // the slider keeps to its limits
        set();
    }

    private void restart() {
        for (Side side : sides) side.restart();
        rest = 0;
        set();
        showHash();
    }

    private void set() {
        int f = Integer.parseInt(friction.getValue()), ticks = Integer.parseInt(rate.getValue());
        Integrator how = Integrator.values()[integrator.getSelectedIndex()];
        for (Side side : sides) side.set(f, ticks, how);
        double z = (double) f / ticks;
        show("friction-value", f + " /s");
        show("rate-value", ticks + " /s");
        show("z", twoPlaces(z));
        PAGE.getBody().setClassName(z <= 1 ? "calm" : z < 2 ? "jitters" : "grows");
    }

    private void pause() {
        paused = !paused;
        show("pause", paused ? "Play" : "Pause");
        if (paused) showHash();
    }

    /** Pauses and plays one tick. */
    private void stepOnce() {
        if (!paused) pause();
        rest = 0;
        tick();
        showHash();
    }

    private void blastAt(double x, double y) {
        for (Side side : sides) side.blastAt(x, y);
        if (paused) showHash();
    }

    private void frame(double now) {
        double elapsed = Math.min(Math.max(0, (now - last) / 1000), LONGEST_FRAME);
        last = now;
        if (!paused) {
            rest += elapsed * Integer.parseInt(rate.getValue());
            for (; rest >= 1; rest--) tick();
        }
        for (Side side : sides) side.paint(paused ? 1 : rest);
        count(now);
        Window.requestAnimationFrame(this::frame);
    }

    private void tick() {
        for (Side side : sides) side.tick();
        for (Side side : sides) side.showJitters();
        show("tick", String.valueOf(sides[0].ticks()));
        if (sides[0].ticks() % HASHED == 0) showHash();
    }

    private void showHash() {
        for (Side side : sides) side.showHash();
    }

    private void count(double now) {
        frames++;
        if (now - counted < 1000) return;
        show("fps", String.valueOf(Math.round(1000 * frames / (now - counted))));
        frames = 0;
        counted = now;
    }

    private static String twoPlaces(double v) {
        long hundredths = Math.round(100 * v);
        return hundredths / 100 + "." + hundredths / 10 % 10 + hundredths % 10;
    }

    private static void show(String id, String text) {
        PAGE.getElementById(id).setTextContent(text);
    }
}
