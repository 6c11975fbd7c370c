package game;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** Clicks for 200 tanks, at each tick rate with each integrator: they come to rest in a round crowd, permanently. */
public final class Game {
    private static final int TANKS = 200;
    private static final double PACKED =
            Math.sqrt(TANKS * Battle.APART * Battle.APART * Math.sqrt(0.75) / Math.PI); // m
    private static final double[][] BUILDINGS = {{0, 0, 40, 60}, {60, 60, 20, 50}}; // m: centre, width and height
    private static final double LIMIT = 60, REST = 30; // s: at most until they rest, and how long this is watched

    private final World world;
    private final Battle battle;
    private final int[] turned = new int[TANKS]; // how many ticks in a row
    private final double[] vx = new double[TANKS], vy = new double[TANKS];
    private double closest = Double.MAX_VALUE, radius, axes, time, overlap = Double.MAX_VALUE; // the worst ones
    private int turns;

    private Game(Integrator integrator, int rate) {
        world = new World(integrator, Timestep.fixed(rate));
        battle = new Battle(world);
        for (double[] b : BUILDINGS) battle.addBuilding(b[0], b[1], b[2], b[3]);
    }

    public static void main(String[] args) {
        for (int rate : new int[] {20, 60, 240}) {
            double closest = Double.MAX_VALUE, radius = 0, axes = 0, time = 0, overlap = Double.MAX_VALUE;
            int turns = 0;
            for (Integrator integrator : Integrator.values()) {
                for (boolean scattered : new boolean[] {true, false}) {
                    Game game = new Game(integrator, rate);
                    game.play(scattered);
                    closest = Math.min(closest, game.closest);
                    radius = Math.max(radius, game.radius);
                    axes = Math.max(axes, game.axes);
                    time = Math.max(time, game.time);
                    turns = Math.max(turns, game.turns);
                    if (scattered) overlap = Math.min(overlap, game.overlap);
                }
            }
            System.out.printf(
                    Locale.ROOT,
                    "two-hundred-tanks: %d ticks/s: at rest after %.1f s; closest pair %.2f m; radius %.1f m, %.2f of the"
                            + " densest disc; axes %.2f; turned back in %d ticks in a row; closest while driving %.1f m%n",
                    rate,
                    time,
                    closest,
                    radius,
                    radius / PACKED,
                    axes,
                    turns,
                    overlap);
        }
        require(hash() == hash(), "the same game gives the same bits");
        for (Integrator integrator : Integrator.values()) throughACrowd(integrator);
        for (int groups : new int[] {2, 5, 20})
            for (double apart : new double[] {0, 1, 20}) nearbyClicks(groups, apart);
        oneTank();
    }

    /** Three clicks, the third while they drive, and a blast in the crowd. */
    private void play(boolean scattered) {
        Random random = new Random(1);
        for (int i = 0; i < TANKS; i++) {
            double x = -110 + 100 * (random.nextDouble() - 0.5), y = 120 * (random.nextDouble() - 0.5);
            battle.addTank(scattered ? x : -100, scattered ? y : 0);
        }
        click(battle.tanks, 80, 0);
        comeToRest(80, 0);
        click(battle.tanks, -70, -70);
        for (double end = world.getTime() + 6; world.getTime() < end; ) step();
        require(speed() > 5, "they drive, at " + speed() + " m/s");
        click(battle.tanks, -60, 60);
        comeToRest(-60, 60);
        battle.blast(-60, 50, 25, 15);
        require(speed() > 0.5, "the blast throws them, at " + speed() + " m/s");
        comeToRest(-60, 60);
    }

    private void click(List<Battle.Tank> tanks, double x, double y) {
        battle.order(tanks, x, y);
    }

    /** A mean. */
    private double speed() {
        double sum = 0;
        for (Unit unit : world) sum += unit.getSpeed();
        return sum / TANKS;
    }

    private void step() {
        world.step();
        for (int i = 0; i < TANKS; i++) {
            Unit tank = battle.tanks.get(i);
            turned[i] = tank.getVx() * vx[i] + tank.getVy() * vy[i] < 0 ? turned[i] + 1 : 0;
            vx[i] = tank.getVx();
            vy[i] = tank.getVy();
            turns = Math.max(turns, turned[i]);
            if (turned[i] >= 3) throw new IllegalStateException("a tank turns back three ticks in a row: " + tank);
            for (double[] b : BUILDINGS) {
                double inX = b[2] / 2 + Battle.WALL - Math.abs(tank.getX() - b[0]);
                double inY = b[3] / 2 + Battle.WALL - Math.abs(tank.getY() - b[1]);
                if (Math.min(inX, inY) > 1e-9) throw new IllegalStateException("a tank is in a building: " + tank);
            }
        }
    }

    private double[] positions() {
        double[] xy = new double[2 * TANKS];
        world.copyPositions(xy, 0, 1);
        return xy;
    }

    /** At most LIMIT seconds; then nothing moves, to the bit. */
    private void comeToRest(double x, double y) {
        double start = world.getTime();
        do {
            if (world.getTime() > start + LIMIT) throw new IllegalStateException("no rest: " + speed() + " m/s");
            step();
            boolean isSample = world.getTick() % 20 == 0 && world.getTime() > start + 5;
            if (isSample) overlap = Math.min(overlap, closestPair(positions()));
        } while (!rest());
        time = Math.max(time, world.getTime() - start);
        double[] before = positions();
        for (double end = world.getTime() + REST; world.getTime() < end; ) {
            step();
            require(rest(), "they rest permanently");
        }
        require(Arrays.equals(before, positions()), "they rest at the same positions, to the bit");
        isRound(before, x, y);
    }

    private boolean rest() {
        for (Unit unit : world) if (unit.getSpeed() != 0) return false;
        return true;
    }

    /** By the farthest tank from the centre, and by the principal axes. */
    private void isRound(double[] xy, double clickX, double clickY) {
        double x = 0, y = 0, farthest = 0;
        for (int i = 0; i < TANKS; i++) {
            x += xy[2 * i] / TANKS;
            y += xy[2 * i + 1] / TANKS;
        }
        for (int i = 0; i < TANKS; i++) farthest = Math.max(farthest, Math.hypot(xy[2 * i] - x, xy[2 * i + 1] - y));
        double ratio = axes(xy, x, y), pair = closestPair(xy);
        closest = Math.min(closest, pair);
        radius = Math.max(radius, farthest);
        axes = Math.max(axes, ratio);
        require(pair >= Battle.APART, "two tanks are " + pair + " m apart");
        require(farthest <= 1.3 * PACKED, "a tank is " + farthest + " m from the centre");
        require(ratio <= 1.1, "the axes of the crowd have a ratio of " + ratio);
        require(Math.hypot(x - clickX, y - clickY) <= 3, "the crowd is around " + x + ", " + y);
    }

    /** The ratio of the principal axes around a centre: 1 for a disc, infinite for a line. */
    private static double axes(double[] xy, double x, double y) {
        double xx = 0, cross = 0, yy = 0;
        for (int i = 0; i < TANKS; i++) {
            double dx = xy[2 * i] - x, dy = xy[2 * i + 1] - y;
            xx += dx * dx;
            cross += dx * dy;
            yy += dy * dy;
        }
        double mean = (xx + yy) / 2, difference = Math.hypot((xx - yy) / 2, cross);
        return Math.sqrt((mean + difference) / Math.max(0, mean - difference));
    }

    private static double closestPair(double[] xy) {
        double square = Double.MAX_VALUE;
        for (int i = 0; i < xy.length; i += 2) {
            for (int j = 0; j < i; j += 2) {
                double dx = xy[i] - xy[j], dy = xy[i + 1] - xy[j + 1];
                square = Math.min(square, dx * dx + dy * dy);
            }
        }
        return Math.sqrt(square);
    }

    /** Of the state after 20 s from one point. */
    private static long hash() {
        Game game = new Game(Integrator.EXACT, 60);
        for (int i = 0; i < TANKS; i++) game.battle.addTank(-100, 0);
        game.click(game.battle.tanks, 80, 0);
        while (game.world.getTime() < 20) game.step();
        return game.world.stateHash();
    }

    /** Half of the tanks rest at the goal of an earlier click; the others drive through them. All come to rest. */
    private static void throughACrowd(Integrator integrator) {
        Game game = new Game(integrator, 60);
        for (int i = 0; i < TANKS; i++) game.battle.addTank(i < TANKS / 2 ? -100 : 0, 100);
        List<Battle.Tank> first = new ArrayList<>(game.battle.tanks.subList(0, TANKS / 2));
        List<Battle.Tank> second = game.battle.tanks.subList(TANKS / 2, TANKS);
        game.click(second, 0, 80);
        while (game.world.getTime() < 20) game.step();
        double[] before = game.positions();
        game.click(first, 100, -80);
        do game.step();
        while (!game.rest() && game.world.getTime() < 20 + LIMIT);
        double[] after = game.positions();
        require(game.rest(), "two crowds come to rest");
        for (int i = TANKS; i < 2 * TANKS; i++) require(Math.abs(after[i] - before[i]) < 60, "the second crowd stays");
        for (int i = 0; i < TANKS; i += 2) require(after[i] > 60 && after[i + 1] < -40, "the first crowd arrives");
    }

    /** Several groups drive from one place to clicks near each other, at the same time. All come to rest. */
    private static void nearbyClicks(int groups, double apart) {
        Game game = new Game(Integrator.EXACT, 60);
        Random random = new Random(groups);
        for (int i = 0; i < TANKS; i++) game.battle.addTank(-110 + 50 * random.nextDouble(), 90 * random.nextDouble());
        for (int i = 0; i < groups; i++) {
            game.click(
                    game.battle.tanks.subList(i * TANKS / groups, (i + 1) * TANKS / groups), 80 + apart * (i % 3), 0);
        }
        do game.step();
        while (!game.rest() && game.world.getTime() < LIMIT);
        require(game.rest(), groups + " groups come to rest, with clicks " + apart + " m apart");
        require(closestPair(game.positions()) >= Battle.APART, "they keep their distance");
    }

    /** A single tank stops on the click. */
    private static void oneTank() {
        World world = new World();
        Battle battle = new Battle(world);
        battle.addTank(-100, 0);
        battle.order(battle.tanks, 80, 0);
        for (int tick = 0; tick < 40 * 60; tick++) world.step();
        Unit tank = world.get(0);
        require(Math.hypot(tank.getX() - 80, tank.getY()) < 1e-9 && tank.getSpeed() == 0, "one tank stops: " + tank);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
