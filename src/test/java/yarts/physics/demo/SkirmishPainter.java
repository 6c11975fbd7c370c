package yarts.physics.demo;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;

/** Draws a skirmish to fit a picture of any size: the film, the still and the window. */
final class SkirmishPainter {
    // Told apart by the colour-blind too.
    private static final Color WEST = new Color(0xE69F00);
    private static final Color EAST = new Color(0x56B4E9);
    private static final Color GROUND = new Color(0x20262B);
    private static final Color BEYOND = new Color(0x14181B);
    private static final Color INK = new Color(0xE8E8E8);

    private static final double TANK = 2.8; // m
    private static final double FLASH = 0.5; // s
    private static final double FLAME = 0.4; // s
    private static final int CAPTION = 26; // pixels

    private final Rectangle2D.Double box = new Rectangle2D.Double();
    private final Ellipse2D.Double ring = new Ellipse2D.Double();
    private float[] xy = new float[0];

    void paint(Graphics2D g, int width, int height, Skirmish game) {
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        double scale = Math.min(width / Skirmish.WIDTH, (height - CAPTION) / Skirmish.HEIGHT);
        g.setColor(BEYOND);
        g.fillRect(0, 0, width, height);
        AffineTransform pixels = g.getTransform();
        g.translate((width - scale * Skirmish.WIDTH) / 2, CAPTION + (height - CAPTION - scale * Skirmish.HEIGHT) / 2);
        g.scale(scale, scale);
        fill(g, 0, 0, Skirmish.WIDTH, Skirmish.HEIGHT, GROUND);
        paintTanks(g, game);
        paintBlasts(g, game);
        g.setTransform(pixels);
        paintCaption(g, width, scale, String.format(Locale.ROOT, "t = %4.1f s", game.time()));
    }

    private void paintTanks(Graphics2D g, Skirmish game) {
        Tank[] tanks = game.tanks();
        if (xy.length < 2 * tanks.length) xy = new float[2 * tanks.length];
        game.world().copyPositions(xy, 0);
        for (int i = 0; i < tanks.length; i++) {
            Tank tank = tanks[i];
            double x = xy[2 * i];
            double y = xy[2 * i + 1];
            boolean thrown = game.time() - tank.lastHit < FLASH;
            Color colour = thrown ? INK : tank.west ? WEST : EAST;
            fill(g, x - TANK / 2, y - TANK / 2, TANK, TANK, colour);
            // The gun: a pushed unit never turns.
            fill(g, tank.west ? x : x - TANK, y - TANK / 8, TANK, TANK / 4, colour);
        }
    }

    private void paintBlasts(Graphics2D g, Skirmish game) {
        g.setColor(INK);
        g.setStroke(new BasicStroke(0.8f));
        for (Skirmish.Blast blast : game.blasts()) {
            double age = (game.time() - blast.time()) / FLAME;
            if (age >= 1) continue;
            double r = Skirmish.BLAST_RADIUS * (0.2 + 0.8 * age);
            ring.setFrame(blast.x() - r, blast.y() - r, 2 * r, 2 * r);
            g.draw(ring);
        }
    }

    /** Above the field: what one sees, the two armies, and a scale. */
    private void paintCaption(Graphics2D g, int width, double scale, String caption) {
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        int baseline = CAPTION - 8;
        int x = 8;
        x = key(g, x, baseline, "west", WEST);
        x = key(g, x, baseline, "east", EAST);
        x = key(g, x, baseline, "just blasted", INK);
        g.drawString(caption, x, baseline);
        int bar = (int) (50 * scale);
        int right = width - 8;
        int label = right - bar - 6 - g.getFontMetrics().stringWidth("50 m");
        g.drawString("50 m", label, baseline);
        g.drawLine(right - bar, baseline - 4, right, baseline - 4);
        g.drawLine(right - bar, baseline - 8, right - bar, baseline);
        g.drawLine(right, baseline - 8, right, baseline);
    }

    private int key(Graphics2D g, int x, int baseline, String text, Color colour) {
        fill(g, x, baseline - 9, 9, 9, colour);
        g.setColor(INK);
        g.drawString(text, x + 13, baseline);
        return x + 13 + g.getFontMetrics().stringWidth(text) + 14;
    }

    private void fill(Graphics2D g, double x, double y, double width, double height, Color colour) {
        box.setFrame(x, y, width, height);
        g.setColor(colour);
        g.fill(box);
    }
}
