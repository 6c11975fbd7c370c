package yarts.physics.demo;

import com.madgag.gif.fmsware.AnimatedGifEncoder;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import javax.imageio.ImageIO;

/** Plays a skirmish without a screen, as fast as it goes, and keeps a GIF and a still of it. */
public final class SkirmishFilm {
    private static final int DELAY = 100; // of a frame, in ms
    private static final int TICKS_PER_FRAME = 12; // twice real time

    private final SkirmishPainter painter = new SkirmishPainter();
    private final Skirmish game;
    private long stepNanos, gameNanos;

    public SkirmishFilm(Skirmish game) {
        this.game = game;
        game.world().removeStepListener(game.commands);
        game.world().addBeforeStep((world, dt) -> {
            long start = System.nanoTime();
            game.commands.onStep(world, dt);
            gameNanos += System.nanoTime() - start;
        });
    }

    /** Plays the ticks. The still is the last frame. */
    public void shoot(Path folder, int ticks, Runnable afterTick) throws IOException {
        AnimatedGifEncoder gif = new AnimatedGifEncoder();
        gif.start(folder.resolve("skirmish.gif").toString());
        gif.setRepeat(0); // for ever
        gif.setDelay(DELAY);
        gif.setQuality(1); // the palette from every pixel
        for (int tick = 1; tick <= ticks; tick++) {
            long start = System.nanoTime();
            game.tick();
            stepNanos += System.nanoTime() - start;
            if (tick % TICKS_PER_FRAME == 0) gif.addFrame(frame(480, 386, false));
            afterTick.run();
        }
        if (!gif.finish()) throw new IOException("skirmish.gif could not be written to " + folder);
        File still = folder.resolve("skirmish.png").toFile();
        ImageIO.write(frame(960, 746, true), "png", still);
    }

    /** A frame of the GIF is not smooth: fewer colours make it smaller. */
    private BufferedImage frame(int width, int height, boolean smooth) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_3BYTE_BGR);
        Graphics2D g = image.createGraphics();
        if (smooth) g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        painter.paint(g, width, height, game);
        g.dispose();
        return image;
    }

    public void report(PrintStream out) {
        Tank[] tanks = game.tanks();
        long ticks = game.world().getTick();
        double steps = (double) tanks.length * ticks, seconds = stepNanos / 1e9;
        long thrown = Arrays.stream(tanks).filter(tank -> tank.lastHit() > 0).count();
        out.printf(Locale.ROOT, "%nThe skirmish: %,d tanks, %,d ticks of 1/60 s, EULER%n", tanks.length, ticks);
        line(out, "played in", "%.1f s, without the pictures: %.0f times real time", seconds, game.time() / seconds);
        line(
                out,
                "library",
                "%.0f ns a tank and step, in a JVM that has just started",
                (stepNanos - gameNanos) / steps);
        line(out, "game", "%.0f ns a tank and step: driving, keeping apart, firing", gameNanos / steps);
        line(out, "blasts", "%,d, which have thrown %,d tanks out of their ranks", game.blastCount(), thrown);
        line(out, "distance", "%.1f m between the closest two, which are %.1f m broad", closest(tanks), Tank.BREADTH);
        line(out, "state", "%016x, the same on every machine and in every run", game.stateHash());
    }

    private static double closest(Tank[] tanks) {
        double least = Double.POSITIVE_INFINITY;
        for (Tank a : tanks) {
            for (Tank b : tanks)
                if (a != b) least = Math.min(least, Math.hypot(a.getX() - b.getX(), a.getY() - b.getY()));
        }
        return least;
    }

    private static void line(PrintStream out, String label, String format, Object... values) {
        out.printf(Locale.ROOT, "  %-14s %s%n", label, String.format(Locale.ROOT, format, values));
    }
}
