package yarts.physics.web;

import org.teavm.jso.canvas.CanvasRenderingContext2D;
import yarts.physics.demo.Skirmish;
import yarts.physics.demo.Tank;

/** Draws a skirmish, in metres. It draws all shapes of one colour together, because a canvas changes its colour slowly. */
final class Painter {
    private static final String GROUND = "#23281f", FURROW = "#2a3026", TRACKS = "#11140f", SCORCHED = "#171a14";
    private static final String FIRE = "#ffd27f", SMOKE = "#5a5a52", RING = "#ffffff";

    /** The colours of a tank, as indices of the two arrays below. */
    private static final int WEST = 0, EAST = 1, THROWN = 2, JITTERS = 3;

    private static final String[] HULL = {"#b87e00", "#3e8ab5", "#b4b4b4", "#c2185b"};
    private static final String[] TURRET = {"#e69f00", "#56b4e9", "#ffffff", "#ff5c9a"};

    // In m
    private static final double LENGTH = 3.4, BREADTH = 2.8, HULL_BREADTH = 2.1, TURRET_SIZE = 1.6, GUN = 2.8;
    private static final double BARREL = 0.55, SQUARE = 25, BLAST_RADIUS = 17;
    private static final double THROWN_AT = 3; // m/s
    private static final double FLAME = 0.45, SMOKES = 1.6, COLD = 8, FLASH = 0.1; // s

    private float[] xy = {};
    private int[] looks = {};

    void paint(CanvasRenderingContext2D g, Skirmish game, double alpha) {
        ground(g);
        double time = game.time();
        g.setFillStyle(SCORCHED);
        for (Skirmish.Blast blast : game.blasts()) {
            double left = 1 - (time - blast.time()) / COLD;
            if (left > 0) disc(g, blast.x(), blast.y(), 3.5 * Math.min(1, 2 * left));
        }
        tanks(g, game, alpha);
        for (Skirmish.Blast blast : game.blasts()) blast(g, blast.x(), blast.y(), time - blast.time());
        g.setGlobalAlpha(1);
        for (Skirmish.Shell shell : game.shells()) shell(g, shell, time);
    }

    private static void ground(CanvasRenderingContext2D g) {
        g.setFillStyle(GROUND);
        g.fillRect(0, 0, Skirmish.WIDTH, Skirmish.HEIGHT);
        g.setFillStyle(FURROW);
        for (double x = SQUARE; x < Skirmish.WIDTH; x += SQUARE) g.fillRect(x, 0, 0.5, Skirmish.HEIGHT);
        for (double y = SQUARE; y < Skirmish.HEIGHT; y += SQUARE) g.fillRect(0, y, Skirmish.WIDTH, 0.5);
    }

    /** Hulls on tracks, which never rotate, and turrets that aim. */
    private void tanks(CanvasRenderingContext2D g, Skirmish game, double alpha) {
        Tank[] tanks = game.tanks();
        if (looks.length != tanks.length) {
            looks = new int[tanks.length];
            xy = new float[2 * tanks.length];
        }
        game.world().copyPositions(xy, 0, alpha);
        double time = game.time();
        for (int i = 0; i < tanks.length; i++) looks[i] = look(tanks[i], time);
        g.setFillStyle(TRACKS);
        for (int i = 0; i < tanks.length; i++) rectangle(g, i, LENGTH, BREADTH);
        for (int look = WEST; look <= JITTERS; look++) {
            g.setFillStyle(HULL[look]);
            for (int i = 0; i < tanks.length; i++) if (looks[i] == look) rectangle(g, i, LENGTH, HULL_BREADTH);
        }
        g.setLineWidth(BARREL);
        for (int look = WEST; look <= JITTERS; look++) {
            g.setFillStyle(TURRET[look]);
            g.setStrokeStyle(TURRET[look]);
            g.beginPath();
            for (int i = 0; i < tanks.length; i++) {
                if (looks[i] != look) continue;
                rectangle(g, i, TURRET_SIZE, TURRET_SIZE);
                g.moveTo(xy[2 * i], xy[2 * i + 1]);
                g.lineTo(xy[2 * i] + GUN * tanks[i].aimX(), xy[2 * i + 1] + GUN * tanks[i].aimY());
            }
            g.stroke();
        }
        g.setFillStyle(FIRE);
        for (int i = 0; i < tanks.length; i++) {
            Tank tank = tanks[i];
            if (time - tank.lastShot() < FLASH)
                disc(g, xy[2 * i] + GUN * tank.aimX(), xy[2 * i + 1] + GUN * tank.aimY(), 1.1);
        }
    }

    private static int look(Tank tank, double time) {
        if (tank.jitters()) return JITTERS;
        if (tank.isSliding(time) && tank.getSpeed() > THROWN_AT) return THROWN;
        return tank.isWest() ? WEST : EAST;
    }

    /** Around a tank's position. */
    private void rectangle(CanvasRenderingContext2D g, int tank, double length, double breadth) {
        g.fillRect(xy[2 * tank] - length / 2, xy[2 * tank + 1] - breadth / 2, length, breadth);
    }

    private static void blast(CanvasRenderingContext2D g, double x, double y, double age) {
        double smoke = age / SMOKES, flame = age / FLAME;
        if (smoke >= 1) return;
        g.setGlobalAlpha(0.6 * (1 - smoke));
        g.setFillStyle(SMOKE);
        disc(g, x, y, 3 + 5 * smoke);
        if (flame >= 1) return;
        g.setGlobalAlpha(1 - flame / 2);
        g.setFillStyle(FIRE);
        disc(g, x, y, 5 * (1 - flame));
        g.setGlobalAlpha(0.7 * (1 - flame));
        g.setStrokeStyle(RING);
        g.setLineWidth(1);
        g.beginPath();
        g.arc(x, y, BLAST_RADIUS * (0.25 + 0.75 * flame), 0, 2 * Math.PI);
        g.stroke();
    }

    /** The last few metres of its path. */
    private static void shell(CanvasRenderingContext2D g, Skirmish.Shell shell, double time) {
        double flown = (time - shell.fired()) / (shell.bursts() - shell.fired());
        double tail = Math.max(0, flown - (shell.heavy() ? 0.12 : 0.06));
        double dx = shell.x() - shell.fromX(), dy = shell.y() - shell.fromY();
        g.setStrokeStyle(FIRE);
        g.setLineWidth(shell.heavy() ? 0.7 : 0.4);
        g.beginPath();
        g.moveTo(shell.fromX() + tail * dx, shell.fromY() + tail * dy);
        g.lineTo(shell.fromX() + flown * dx, shell.fromY() + flown * dy);
        g.stroke();
    }

    private static void disc(CanvasRenderingContext2D g, double x, double y, double r) {
        g.beginPath();
        g.arc(x, y, r, 0, 2 * Math.PI);
        g.fill();
    }
}
