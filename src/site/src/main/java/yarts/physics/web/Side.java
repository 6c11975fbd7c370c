package yarts.physics.web;

import org.teavm.jso.browser.Window;
import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.dom.events.EventListener;
import org.teavm.jso.dom.events.MouseEvent;
import org.teavm.jso.dom.html.HTMLCanvasElement;
import org.teavm.jso.dom.html.HTMLDocument;
import org.teavm.jso.dom.html.HTMLElement;
import yarts.physics.Integrator;
import yarts.physics.demo.Skirmish;

/** One of the two games on the page, by the naive rule or by the library, with its canvas and its displays. */
final class Side {
    /** Receives the place of a click or tap, in metres. */
    interface Tap {
        void at(double x, double y);
    }

    static final int TANKS_PER_ARMY = 480;
    static final long SEED = 1;

    /** The part of the map that is drawn, around the front; in m. */
    static final double VIEW_WIDTH = 240, VIEW_HEIGHT = 160;

    static final double VIEW_X = (Skirmish.WIDTH - VIEW_WIDTH) / 2, VIEW_Y = (Skirmish.HEIGHT - VIEW_HEIGHT) / 2;
    /** Device pixels per CSS pixel. More are not visible and cost time. */
    private static final double MOST_PIXELS = 2;

    private final boolean naive;
    private final HTMLCanvasElement canvas;
    private final HTMLElement jittering, hash, hashTick;
    private final Painter painter = new Painter();
    private Skirmish game;

    Side(String name, boolean naive, Tap tap) {
        this.naive = naive;
        HTMLDocument page = HTMLDocument.current();
        canvas = (HTMLCanvasElement) page.getElementById(name);
        jittering = page.getElementById(name + "-jitters");
        hash = page.getElementById(name + "-hash");
        hashTick = page.getElementById(name + "-tick");
        canvas.addEventListener("click", (EventListener<MouseEvent>) e -> {
            double metres = VIEW_WIDTH / canvas.getClientWidth();
            tap.at(metres * e.getOffsetX() + VIEW_X, metres * e.getOffsetY() + VIEW_Y);
        });
    }

    void restart() {
        game = new Skirmish(TANKS_PER_ARMY, SEED);
        game.setNaive(naive);
    }

    void set(double friction, int ticksPerSecond, Integrator integrator) {
        game.setFriction(friction);
        game.setTicksPerSecond(ticksPerSecond);
        game.setIntegrator(integrator);
    }

    void tick() {
        game.tick();
    }

    long ticks() {
        return game.world().getTick();
    }

    void blastAt(double x, double y) {
        game.blastAt(x, y);
    }

    /** Draws the game between its last two ticks. */
    void paint(double alpha) {
        double pixels = Math.min(MOST_PIXELS, Window.current().getDevicePixelRatio());
        int width = (int) (pixels * canvas.getClientWidth()), height = (int) (width * VIEW_HEIGHT / VIEW_WIDTH);
        if (canvas.getWidth() != width) canvas.setWidth(width);
        if (canvas.getHeight() != height) canvas.setHeight(height);
        CanvasRenderingContext2D g = (CanvasRenderingContext2D) canvas.getContext("2d");
        double scale = width / VIEW_WIDTH;
        g.setTransform(scale, 0, 0, scale, -VIEW_X * scale, -VIEW_Y * scale);
        painter.paint(g, game, alpha);
    }

    void showJitters() {
        jittering.setTextContent(String.valueOf(game.jittering()));
    }

    void showHash() {
        String bits = Long.toHexString(game.stateHash());
        hash.setTextContent("0".repeat(16 - bits.length()) + bits);
        hashTick.setTextContent(String.valueOf(ticks()));
    }
}
