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

/** One of the two games on the page, with its canvas and its readouts: by the naive rule, or by the library. */
final class Side {
    /** Tells where somebody has tapped, in metres. */
    interface Tap {
        void at(double x, double y);
    }

    static final int TANKS_AN_ARMY = 480;
    static final long SEED = 1;

    /** The part of the map that is drawn: the front. In m. */
    static final double VIEW_WIDTH = 240, VIEW_HEIGHT = 160;

    static final double VIEW_X = (Skirmish.WIDTH - VIEW_WIDTH) / 2, VIEW_Y = (Skirmish.HEIGHT - VIEW_HEIGHT) / 2;
    /** More pixels than two for one of the page's are not seen, but cost time. */
    private static final double MOST_PIXELS = 2;

    private final boolean naive;
    private final HTMLCanvasElement canvas;
    private final HTMLElement jittering, hash, hashTick;
    private final Painter painter = new Painter();
    private final Jitters jitters = new Jitters(2 * TANKS_AN_ARMY);
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
        game = new Skirmish(TANKS_AN_ARMY, SEED);
        game.setNaive(naive);
        jitters.clear();
    }

    void set(double friction, int ticksPerSecond, Integrator integrator) {
        game.setFriction(friction);
        game.setTicksPerSecond(ticksPerSecond);
        game.setIntegrator(integrator);
    }

    void tick() {
        game.tick();
        jitters.look(game.world());
    }

    long ticks() {
        return game.world().getTick();
    }

    void blastAt(double x, double y) {
        game.blastAt(x, y);
    }

    /** Draws the game as it is between its last two ticks. */
    void paint(double alpha) {
        double pixels = Math.min(MOST_PIXELS, Window.current().getDevicePixelRatio());
        int width = (int) (pixels * canvas.getClientWidth()), height = (int) (width * VIEW_HEIGHT / VIEW_WIDTH);
        if (canvas.getWidth() != width) canvas.setWidth(width);
        if (canvas.getHeight() != height) canvas.setHeight(height);
        CanvasRenderingContext2D g = (CanvasRenderingContext2D) canvas.getContext("2d");
        double scale = width / VIEW_WIDTH;
        g.setTransform(scale, 0, 0, scale, -VIEW_X * scale, -VIEW_Y * scale);
        painter.paint(g, game, jitters, alpha);
    }

    void showJitters() {
        jittering.setTextContent(String.valueOf(jitters.count()));
    }

    void showHash() {
        String bits = Long.toHexString(game.stateHash());
        hash.setTextContent("0".repeat(16 - bits.length()) + bits);
        hashTick.setTextContent(String.valueOf(ticks()));
    }
}
