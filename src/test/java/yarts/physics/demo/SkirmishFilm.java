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
    private static final int FRAMES_PER_SECOND = 10;
    private static final int SPEED = 2; // times real time
    private static final int TICKS_PER_FRAME = SPEED * Skirmish.TICKS_PER_SECOND / FRAMES_PER_SECOND;

    private final SkirmishPainter painter = new SkirmishPainter();
    private final Skirmish game;
    private long stepNanos;

    public SkirmishFilm(Skirmish game) {
        this.game = game;
    }

    /** Plays the ticks. The still is from halfway. */
    public void shoot(Path folder, int ticks, Runnable afterTick) throws IOException {
        AnimatedGifEncoder gif = new AnimatedGifEncoder();
        File still = folder.resolve("skirmish.png").toFile();
        gif.start(folder.resolve("skirmish.gif").toString());
        gif.setRepeat(0); // for ever
        gif.setDelay(1000 / FRAMES_PER_SECOND);
        for (int tick = 1; tick <= ticks; tick++) {
            long start = System.nanoTime();
            game.tick();
            stepNanos += System.nanoTime() - start;
            if (tick % TICKS_PER_FRAME == 0) gif.addFrame(frame(480, 386, false));
            if (tick == ticks / 2) ImageIO.write(frame(960, 746, true), "png", still);
            afterTick.run();
        }
        if (!gif.finish()) throw new IOException("skirmish.gif could not be written to " + folder);
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
        double seconds = stepNanos / 1e9;
        long thrown = Arrays.stream(tanks).filter(tank -> tank.lastHit() > 0).count();
        long placed = Arrays.stream(tanks).filter(tank -> tank.astray() < 1).count();
        out.printf(Locale.ROOT, "%nThe skirmish: %,d tanks, %,d ticks of 1/60 s, EULER%n", tanks.length, ticks);
        line(out, "played in", "%.1f s, without the pictures: %.0f times real time", seconds, game.time() / seconds);
        line(
                out,
                "a tick takes",
                "%.0f ns a tank, driving, keeping apart and blasts included",
                stepNanos / (double) ticks / tanks.length);
        line(out, "blasts", "%,d, which have thrown %,d tanks", game.blastCount(), thrown);
        line(out, "in place", "%,d tanks are within 1 m of their place in the ranks", placed);
        line(out, "state", "%016x, the same on every machine and in every run", game.stateHash());
    }

    private static void line(PrintStream out, String label, String format, Object... values) {
        out.printf(Locale.ROOT, "  %-14s %s%n", label, String.format(Locale.ROOT, format, values));
    }
}
