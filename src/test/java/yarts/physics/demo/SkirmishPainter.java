package yarts.physics.demo;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RadialGradientPaint;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntBinaryOperator;

/** Draws a skirmish: in a picture of any size, or its field alone. */
final class SkirmishPainter {
    // Colour-blind people can tell them apart.
    private static final Color WEST = new Color(0xE69F00), WEST_TURRET = new Color(0xFFC95C);
    private static final Color EAST = new Color(0x56B4E9), EAST_TURRET = new Color(0xA6DCFA);
    private static final Color THROWN = new Color(0xFFFFFF), THROWN_TURRET = new Color(0xC8C8C8);
    static final Color JITTERS = new Color(0xFF5C9A), JITTERS_TURRET = new Color(0xFFB0CE);
    private static final Color GROUND = new Color(0x23281F), FURROW = new Color(0x2A3026);
    private static final Color TRACKS = new Color(0x11140F), SCORCHED = new Color(0x171A14);
    private static final Color FIRE = new Color(0xFFD27F), SMOKE = new Color(0x5A5A52);
    static final Color BEYOND = new Color(0x14181B), INK = new Color(0xE8E8E8), CALM = new Color(0x4CC38A);

    private static final Color[] HULLS = {WEST, EAST, THROWN, JITTERS};
    private static final Color[] TURRETS = {WEST_TURRET, EAST_TURRET, THROWN_TURRET, JITTERS_TURRET};

    // Of a tank, in m
    private static final double TURRET = 1.8, GUN = 2.8, BARREL = 0.55;
    private static final double THROWN_AT = 3; // m/s
    private static final double FLAME = 0.45, SMOKES = 1.6, COLD = 8, FLASH = 0.1; // s
    private static final double SQUARE = 25; // m
    private static final int CAPTION = 26; // pixels
    private static final int MIXTURES = 8;

    private final Rectangle2D.Double box = new Rectangle2D.Double();
    private final Ellipse2D.Double circle = new Ellipse2D.Double();
    private final Line2D.Double line = new Line2D.Double();
    private float[] xy = {};

    /** All colours, and mixtures for the edges of letters and for shapes that fade. */
    static List<Color> palette() {
        List<Color> palette = new ArrayList<>(List.of(GROUND, FURROW, TRACKS, SCORCHED, BEYOND));
        palette.addAll(List.of(HULLS));
        palette.addAll(List.of(TURRETS));
        for (Color letters : List.of(INK, JITTERS, CALM)) mix(palette, BEYOND, letters);
        for (Color light : List.of(SMOKE, FIRE, Color.WHITE)) mix(palette, GROUND, light);
        mix(palette, FIRE, Color.WHITE);
        return palette;
    }

    private static void mix(List<Color> palette, Color a, Color b) {
        for (int i = 1; i <= MIXTURES; i++) {
            int parts = i;
            IntBinaryOperator mix = (from, to) -> from + (to - from) * parts / MIXTURES;
            palette.add(new Color(
                    mix.applyAsInt(a.getRed(), b.getRed()),
                    mix.applyAsInt(a.getGreen(), b.getGreen()),
                    mix.applyAsInt(a.getBlue(), b.getBlue())));
        }
    }

    void paint(Graphics2D g, int width, int height, Skirmish game) {
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(BEYOND);
        g.fillRect(0, 0, width, height);
        AffineTransform pixels = g.getTransform(), map = map(width, height);
        g.transform(map);
        paintField(g, game);
        g.setTransform(pixels);
        paintCaption(g, width, map.getScaleX(), String.format(Locale.ROOT, "t = %4.1f s", game.time()));
    }

    /** Draws the field without a caption; in metres. */
    void paintField(Graphics2D g, Skirmish game) {
        paintGround(g);
        double time = game.time();
        for (Skirmish.Blast blast : game.blasts()) {
            double left = 1 - (time - blast.time()) / COLD;
            if (left > 0) disc(g, blast.x(), blast.y(), 3.5 * Math.min(1, 2 * left), SCORCHED);
        }
        paintTanks(g, game);
        for (Skirmish.Blast blast : game.blasts()) paintBlast(g, blast, time - blast.time());
        for (Skirmish.Shell shell : game.shells()) paintShell(g, shell, time);
    }

    /** The transform from metres to pixels. */
    static AffineTransform map(int width, int height) {
        double scale = Math.min(width / Skirmish.WIDTH, (height - CAPTION) / Skirmish.HEIGHT);
        double left = (width - scale * Skirmish.WIDTH) / 2;
        double top = CAPTION + (height - CAPTION - scale * Skirmish.HEIGHT) / 2;
        return new AffineTransform(scale, 0, 0, scale, left, top);
    }

    private void paintGround(Graphics2D g) {
        fill(g, 0, 0, Skirmish.WIDTH, Skirmish.HEIGHT, GROUND);
        for (double x = SQUARE; x < Skirmish.WIDTH; x += SQUARE) fill(g, x, 0, 0.5, Skirmish.HEIGHT, FURROW);
        for (double y = SQUARE; y < Skirmish.HEIGHT; y += SQUARE) fill(g, 0, y, Skirmish.WIDTH, 0.5, FURROW);
    }

    private void paintTanks(Graphics2D g, Skirmish game) {
        Tank[] tanks = game.tanks();
        if (xy.length < 2 * tanks.length) xy = new float[2 * tanks.length];
        game.world().copyPositions(xy, 0);
        for (int i = 0; i < tanks.length; i++) paintTank(g, tanks[i], xy[2 * i], xy[2 * i + 1], game.time());
    }

    /** A hull on tracks, which never rotates, and a turret that aims. */
    private void paintTank(Graphics2D g, Tank tank, double x, double y, double time) {
        boolean thrown = tank.isSliding(time) && tank.getSpeed() > THROWN_AT;
        int look = tank.jitters() ? 3 : thrown ? 2 : tank.isWest() ? 0 : 1;
        double length = Tank.LENGTH, breadth = Tank.BREADTH, hull = breadth - 0.7;
        fill(g, x - length / 2, y - breadth / 2, length, breadth, TRACKS);
        fill(g, x - length / 2, y - hull / 2, length, hull, HULLS[look]);
        Color colour = TURRETS[look];
        disc(g, x, y, TURRET / 2, colour);
        stroke(g, x, y, x + GUN * tank.aimX(), y + GUN * tank.aimY(), BARREL, colour);
        if (time - tank.lastShot() < FLASH) disc(g, x + GUN * tank.aimX(), y + GUN * tank.aimY(), 1.1, FIRE);
    }

    private void paintBlast(Graphics2D g, Skirmish.Blast blast, double age) {
        double x = blast.x(), y = blast.y();
        double smoke = age / SMOKES, flame = age / FLAME;
        if (smoke < 1) glow(g, x, y, 5 + 5 * smoke, SMOKE, 1 - smoke);
        if (flame >= 1) return;
        glow(g, x, y, 9 * (1 - flame), FIRE, 1);
        disc(g, x, y, 3 * (1 - flame), Color.WHITE);
        double r = Artillery.BLAST_RADIUS * (0.25 + 0.75 * flame);
        circle.setFrame(x - r, y - r, 2 * r, 2 * r);
        g.setColor(faded(Color.WHITE, 0.7 * (1 - flame)));
        g.setStroke(new BasicStroke(1));
        g.draw(circle);
    }

    /** The last few metres of its path. */
    private void paintShell(Graphics2D g, Skirmish.Shell shell, double time) {
        double flown = (time - shell.fired()) / (shell.bursts() - shell.fired());
        double dx = shell.x() - shell.fromX(), dy = shell.y() - shell.fromY();
        double tail = Math.max(0, flown - (shell.heavy() ? 0.12 : 0.06));
        stroke(
                g,
                shell.fromX() + tail * dx,
                shell.fromY() + tail * dy,
                shell.fromX() + flown * dx,
                shell.fromY() + flown * dy,
                shell.heavy() ? 0.7 : 0.4,
                FIRE);
    }

    /** A disc that fades towards its edge. */
    private void glow(Graphics2D g, double x, double y, double r, Color colour, double opacity) {
        circle.setFrame(x - r, y - r, 2 * r, 2 * r);
        float[] parts = {0, 0.4f, 1};
        Color[] colours = {faded(colour, opacity), faded(colour, 0.8 * opacity), faded(colour, 0)};
        g.setPaint(new RadialGradientPaint((float) x, (float) y, (float) r, parts, colours));
        g.fill(circle);
    }

    private static Color faded(Color colour, double opacity) {
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), (int) (255 * opacity));
    }

    private void stroke(Graphics2D g, double x1, double y1, double x2, double y2, double width, Color colour) {
        line.setLine(x1, y1, x2, y2);
        g.setColor(colour);
        g.setStroke(new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER));
        g.draw(line);
    }

    private void disc(Graphics2D g, double x, double y, double r, Color colour) {
        circle.setFrame(x - r, y - r, 2 * r, 2 * r);
        g.setColor(colour);
        g.fill(circle);
    }

    /** Above the field: the legend, the time and a scale. */
    private void paintCaption(Graphics2D g, int width, double scale, String caption) {
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        int baseline = CAPTION - 8;
        int text = legend(g, 8, baseline);
        g.drawString(caption, text, baseline);
        int bar = (int) (50 * scale);
        int right = width - 8;
        int label = right - bar - 6 - g.getFontMetrics().stringWidth("50 m");
        g.drawString("50 m", label, baseline);
        g.drawLine(right - bar, baseline - 4, right, baseline - 4);
        g.drawLine(right - bar, baseline - 8, right - bar, baseline);
        g.drawLine(right, baseline - 8, right, baseline);
    }

    /** Draws the names of the tanks' colours; returns the x at its end. */
    static int legend(Graphics2D g, int left, int baseline) {
        String[] names = {"west", "east", "thrown by a blast", "jitters"};
        int size = g.getFontMetrics().getAscent() * 2 / 3, x = left;
        for (int look = 0; look < names.length; look++) {
            g.setColor(HULLS[look]);
            g.fillRect(x, baseline - size, size, size);
            g.setColor(INK);
            x += size + 5;
            g.drawString(names[look], x, baseline);
            x += g.getFontMetrics().stringWidth(names[look]) + 14;
        }
        return x;
    }

    private void fill(Graphics2D g, double x, double y, double width, double height, Color colour) {
        box.setFrame(x, y, width, height);
        g.setColor(colour);
        g.fill(box);
    }
}
