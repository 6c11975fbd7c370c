package yarts.physics.demo;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import javax.imageio.ImageIO;

/** Plays a skirmish as fast as possible, without a screen; draws its end and reports its times. */
public final class SkirmishRun {
    private static final int WIDTH = 960, HEIGHT = 746; // pixels

    private final Skirmish game;
    private long stepNanos, gameNanos;

    public SkirmishRun(Skirmish game) {
        this.game = game;
        game.world().removeStepListener(game.commands);
        game.world().addBeforeStep((world, dt) -> {
            long start = System.nanoTime();
            game.commands.onStep(world, dt);
            gameNanos += System.nanoTime() - start;
        });
    }

    public void play(int ticks, Runnable afterTick) {
        for (int tick = 0; tick < ticks; tick++) {
            long start = System.nanoTime();
            game.tick();
            stepNanos += System.nanoTime() - start;
            afterTick.run();
        }
    }

    /** Writes a PNG of the game as it is now. */
    public void draw(Path file) throws IOException {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_3BYTE_BGR);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        new SkirmishPainter().paint(g, WIDTH, HEIGHT, game);
        g.dispose();
        ImageIO.write(image, "png", file.toFile());
    }

    public void report(PrintStream out) {
        Tank[] tanks = game.tanks();
        long ticks = game.world().getTick();
        double steps = (double) tanks.length * ticks, seconds = stepNanos / 1e9;
        long thrown = Arrays.stream(tanks).filter(tank -> tank.lastHit() > 0).count();
        out.printf(Locale.ROOT, "%nThe skirmish: %,d tanks, %,d ticks of 1/60 s, EULER%n", tanks.length, ticks);
        line(out, "time", "%.1f s, without the pictures: %.0f times real time", seconds, game.time() / seconds);
        line(out, "library", "%.0f ns per tank and step, in a newly started JVM", (stepNanos - gameNanos) / steps);
        line(out, "game", "%.0f ns per tank and step: driving, keeping apart, firing", gameNanos / steps);
        line(out, "blasts", "%,d; they threw %,d tanks out of their ranks", game.blastCount(), thrown);
        line(
                out,
                "distance",
                "%.1f m between the closest two tanks; a tank is %.1f m wide",
                closest(tanks),
                Tank.BREADTH);
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
