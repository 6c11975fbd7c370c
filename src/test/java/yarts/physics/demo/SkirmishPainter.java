package yarts.physics.demo;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;

/** Draws a skirmish to fit a picture of any size: the film, the still and the window. */
final class SkirmishPainter {
    // Told apart by the colour-blind too.
    private static final Color WEST = new Color(0xE69F00), WEST_HULL = new Color(0x8A5F00);
    private static final Color EAST = new Color(0x56B4E9), EAST_HULL = new Color(0x2B6C95);
    private static final Color GROUND = new Color(0x262B24);
    private static final Color BEYOND = new Color(0x14181B);
    private static final Color INK = new Color(0xE8E8E8);
    private static final Color THROWN = new Color(0xFFFFFF), THROWN_HULL = new Color(0x9A9A9A);
    private static final Color SCORCHED = new Color(0x1A1D18), FIRE = new Color(0xFFD27F);

    // A tank, in m
    private static final double LENGTH = 3.4, BREADTH = 2.6, TURRET = 1.5, GUN = 2.6, BARREL = 0.5;
    private static final double SHOWN = 0.6, FLAME = 0.35, SMOKE = 3, TRACE = 0.12; // s
    private static final int CAPTION = 26; // pixels

    private final Rectangle2D.Double box = new Rectangle2D.Double();
    private final Ellipse2D.Double circle = new Ellipse2D.Double();
    private final Line2D.Double line = new Line2D.Double();
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
        for (Skirmish.Blast blast : game.blasts()) paintCrater(g, blast, game.time());
        paintTanks(g, game);
        for (Skirmish.Blast blast : game.blasts()) paintFire(g, blast, game.time());
        g.setTransform(pixels);
        paintCaption(g, width, scale, String.format(Locale.ROOT, "t = %4.1f s", game.time()));
    }

    private void paintTanks(Graphics2D g, Skirmish game) {
        Tank[] tanks = game.tanks();
        if (xy.length < 2 * tanks.length) xy = new float[2 * tanks.length];
        game.world().copyPositions(xy, 0);
        for (int i = 0; i < tanks.length; i++) {
            Tank tank = tanks[i];
            double x = xy[2 * i], y = xy[2 * i + 1];
            boolean west = tank.isWest(), thrown = game.time() - tank.lastHit() < SHOWN;
            Color hull = thrown ? THROWN_HULL : west ? WEST_HULL : EAST_HULL;
            Color turret = thrown ? THROWN : west ? WEST : EAST;
            fill(g, x - LENGTH / 2, y - BREADTH / 2, LENGTH, BREADTH, hull);
            fill(g, x - TURRET / 2, y - TURRET / 2, TURRET, TURRET, turret);
            // The gun: a pushed unit never turns.
            fill(g, west ? x : x - GUN, y - BARREL / 2, GUN, BARREL, turret);
            if (game.time() - tank.lastShot() < TRACE) fill(g, west ? x + GUN : x - GUN - 1.4, y - 0.7, 1.4, 1.4, FIRE);
        }
    }

    /** The ground that a shell has torn up. */
    private void paintCrater(Graphics2D g, Skirmish.Blast blast, double time) {
        double age = (time - blast.time()) / SMOKE;
        if (age < 1) disc(g, blast, 3.5 * (1 - age) + 1, SCORCHED);
    }

    private void paintFire(Graphics2D g, Skirmish.Blast blast, double time) {
        double seconds = time - blast.time(), age = seconds / FLAME;
        if (age >= 1) return;
        if (seconds < TRACE && blast.fromX() != blast.x()) {
            g.setColor(FIRE);
            g.setStroke(new BasicStroke(0.35f));
            line.setLine(blast.fromX(), blast.fromY(), blast.x(), blast.y());
            g.draw(line);
        }
        if (age < 0.5) disc(g, blast, 4 * (1 - age), FIRE);
        double r = Skirmish.BLAST_RADIUS * (0.3 + 0.7 * age);
        g.setColor(new Color(255, 255, 255, (int) (200 * (1 - age))));
        g.setStroke(new BasicStroke(1.2f));
        circle.setFrame(blast.x() - r, blast.y() - r, 2 * r, 2 * r);
        g.draw(circle);
    }

    private void disc(Graphics2D g, Skirmish.Blast blast, double r, Color colour) {
        circle.setFrame(blast.x() - r, blast.y() - r, 2 * r, 2 * r);
        g.setColor(colour);
        g.fill(circle);
    }

    /** Above the field: what one sees, the two armies, and a scale. */
    private void paintCaption(Graphics2D g, int width, double scale, String caption) {
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        int baseline = CAPTION - 8;
        int x = 8;
        x = key(g, x, baseline, "west", WEST);
        x = key(g, x, baseline, "east", EAST);
        x = key(g, x, baseline, "just blasted", THROWN);
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
