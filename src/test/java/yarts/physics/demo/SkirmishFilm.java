package yarts.physics.demo;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/**
 * Films one skirmish twice, side by side: by the naive rule and by the library, from one seed and at the same tick rate. Each
 * half shows how many of its visible tanks jitter. A frame is a tick, so the film runs in real time.
 */
public final class SkirmishFilm {
    /** z = 42 / 20 = 2.1: the naive rule diverges, and the jitters are long enough to be seen. */
    private static final int TICKS_PER_SECOND = 20;

    private static final double FRICTION = 42; // f/m, in 1/s
    private static final int SKIPPED = 2 * TICKS_PER_SECOND; // ticks before the first frame
    private static final int LAST_DELAY = 1500; // ms

    // In pixels. On GitHub, a README is about 830 pixels wide.
    private static final int HALF = 410, GAP = 8, FIELD = 320, TOP = 34, BOTTOM = 28;
    private static final int WIDTH = 2 * HALF + GAP, HEIGHT = TOP + FIELD + BOTTOM;
    private static final double SCALE = 2.5; // pixels per metre

    private static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 20);
    private static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 15);

    private final SkirmishPainter painter = new SkirmishPainter();
    private final Skirmish naive, library;

    public SkirmishFilm(int tanksPerArmy, long seed) {
        naive = new Skirmish(tanksPerArmy, seed);
        naive.setNaive(true);
        library = new Skirmish(tanksPerArmy, seed);
        for (Skirmish game : new Skirmish[] {naive, library}) {
            game.setFriction(FRICTION);
            game.setTicksPerSecond(TICKS_PER_SECOND);
            for (int tick = 0; tick < SKIPPED; tick++) game.tick();
        }
    }

    /** Writes a GIF of some frames, which repeats. */
    public void shoot(Path file, int frames, Runnable afterFrame) throws IOException {
        FilmEncoder gif = new FilmEncoder(SkirmishPainter.palette());
        gif.start(file.toString());
        gif.setRepeat(0); // without end
        for (int frame = 1; frame <= frames; frame++) {
            naive.tick();
            library.tick();
            gif.setDelay(frame < frames ? 1000 / TICKS_PER_SECOND : LAST_DELAY);
            gif.addFrame(frame());
            afterFrame.run();
        }
        if (!gif.finish()) throw new IOException("could not write " + file);
    }

    /** Shapes are drawn without antialiasing: fewer colours make the file smaller. */
    private BufferedImage frame() {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_3BYTE_BGR);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(SkirmishPainter.BEYOND);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        half(g, 0, "The naive rule: ", naive, SkirmishPainter.JITTERS);
        half(g, HALF + GAP, "The library: ", library, SkirmishPainter.CALM);
        g.setFont(TEXT);
        int baseline = HEIGHT - 9, x = SkirmishPainter.legend(g, 8, baseline);
        String rate = String.format(
                Locale.ROOT, "%d ticks/s, z = f·dt/m = %.1f", TICKS_PER_SECOND, FRICTION / TICKS_PER_SECOND);
        g.drawString(rate, Math.max(x, WIDTH - 8 - g.getFontMetrics().stringWidth(rate)), baseline);
        g.dispose();
        return image;
    }

    private void half(Graphics2D g, int left, String title, Skirmish game, Color countColour) {
        AffineTransform pixels = g.getTransform();
        Shape clip = g.getClip();
        g.clipRect(left, TOP, HALF, FIELD);
        g.translate(left + HALF / 2.0, TOP + FIELD / 2.0);
        g.scale(SCALE, SCALE);
        g.translate(-Skirmish.WIDTH / 2, -Skirmish.HEIGHT / 2);
        painter.paintField(g, game);
        g.setTransform(pixels);
        g.setClip(clip);

        int baseline = TOP - 10, x = left + 8;
        g.setFont(TITLE);
        g.setColor(SkirmishPainter.INK);
        g.drawString(title, x, baseline);
        x += g.getFontMetrics().stringWidth(title);
        g.setColor(countColour);
        g.drawString(count(game) + " tanks jitter", x, baseline);
    }

    private static long count(Skirmish game) {
        return Arrays.stream(game.tanks())
                .filter(tank -> tank.jitters() && isVisible(tank))
                .count();
    }

    private static boolean isVisible(Tank tank) {
        return Math.abs(tank.getX() - Skirmish.WIDTH / 2) < HALF / SCALE / 2
                && Math.abs(tank.getY() - Skirmish.HEIGHT / 2) < FIELD / SCALE / 2;
    }
}
