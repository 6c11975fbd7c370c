package yarts.physics.demo;

import java.util.Arrays;
import yarts.physics.Integrator;
import yarts.physics.StepListener;
import yarts.physics.Timestep;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * A game of two armies with a front between them. The front moves, companies follow it, sally and withdraw. Blasts throw tanks
 * out of the ranks, and the tanks drive back to their places. Before each step the game drives its tanks, keeps them apart and
 * fires; the world moves them. The same seed plays the same battle, to the bit, on the web and on a JVM.
 */
public final class Skirmish {
    public static final int TICKS_PER_SECOND = 60;
    public static final double WIDTH = 400; // m
    public static final double HEIGHT = 300; // m

    static final double NO_MANS_LAND = 34; // m
    private static final int MAX_LANES = 12;
    private static final double WIDEST_LANE = 48, MARGIN = 5; // m
    private static final double ORDERS_PER_SECOND = 0.8, SALLIES_PER_SECOND = 1;
    private static final double FIRST_SHOT = 3, FIRST_ORDER = 5; // s

    /** Tanks closer than the first distance are pushed apart gently; closer than the second, firmly. */
    private static final double APART = 4.2, TOUCH = 3.6; // m

    private static final double GENTLE = 2.5, FIRM = 12; // m/s, for tanks in the same place

    /** The place and time of a burst; in m and s. */
    public record Blast(double x, double y, double time) {}

    /** A shell in flight: its start, its target, the times of the shot and the burst. Only a heavy shell makes a blast. */
    public record Shell(double fromX, double fromY, double x, double y, double fired, double bursts, boolean heavy) {}

    private final Tank[] tanks;
    private final Company[] companies;
    private final Front front;
    private final Artillery artillery;
    private final Dice dice;
    private final Grid grid;
    private final Grid.Pair keepApart = this::keepApart;
    private final double[] x, y, fx, fy;
    private final World world = new World(Integrator.EULER, Timestep.fixed(TICKS_PER_SECOND));
    /** The game's part of a step. */
    final StepListener commands = (w, dt) -> command(dt);

    private boolean naive;
    private double friction = Tank.FRICTION * Tank.MASS; // N·s/m
    private double time; // s
    private int jittering;

    public Skirmish(int tanksPerArmy, long seed) {
        dice = new Dice(seed);
        int perArmy = (tanksPerArmy + Company.SIZE - 1) / Company.SIZE;
        int lanes = Math.min(perArmy, MAX_LANES);
        front = new Front((perArmy + lanes - 1) / lanes);
        companies = new Company[2 * perArmy];
        for (int i = 0; i < companies.length; i++) companies[i] = company(i % 2 == 0, i / 2, lanes);
        tanks = new Tank[2 * tanksPerArmy];
        for (int i = 0; i < tanks.length; i++) {
            int k = i / 2, place = k % Company.SIZE;
            Company company = companies[k / Company.SIZE * 2 + i % 2];
            tanks[i] = world.add(new Tank(company, place / Company.FILES, place % Company.FILES, dice));
        }
        artillery = new Artillery(tanks);
        x = new double[tanks.length];
        y = new double[tanks.length];
        fx = new double[tanks.length];
        fy = new double[tanks.length];
        grid = new Grid(WIDTH, HEIGHT, APART, tanks.length);
        world.addBeforeStep(commands);
        world.addAfterStep((w, dt) -> countJitters());
        brake();
    }

    /** Companies stand side by side, from the middle outwards, and then behind each other. */
    private Company company(boolean west, int index, int lanes) {
        int k = index % lanes, depth = index / lanes, fromMiddle = (k + 1) / 2;
        double lane = lanes / 2 + (k % 2 == 0 ? fromMiddle : -fromMiddle) - (lanes - 1) / 2.0;
        double width = Math.min(WIDEST_LANE, (HEIGHT - 2 * MARGIN) / lanes);
        double start = 0.5 + 0.3 * fromMiddle + 0.5 * depth;
        return new Company(front.line(west, depth), HEIGHT / 2 + lane * width, start);
    }

    public void setIntegrator(Integrator integrator) {
        world.setIntegrator(integrator);
    }

    public void setTicksPerSecond(int ticks) {
        world.setTimestep(Timestep.fixed(ticks));
    }

    /** f/m, in 1/s. */
    public void setFriction(double perSecond) {
        friction = perSecond * Tank.MASS;
    }

    /** Whether the game brakes its tanks itself, by a force of −f·v: the naive rule. */
    public void setNaive(boolean naive) {
        this.naive = naive;
    }

    /** Plays the time of a frame; returns the number of ticks. */
    public int advance(double seconds) {
        return world.advance(seconds);
    }

    /** Plays one tick. */
    public void tick() {
        world.step();
    }

    /** Makes a blast, as a player's shell does. */
    public void blastAt(double x, double y) {
        artillery.burst(x, y, time);
    }

    private void command(double dt) {
        time += dt;
        if (time > FIRST_ORDER && dice.next() < ORDERS_PER_SECOND * dt) front.order(dice, time);
        if (time > FIRST_ORDER && dice.next() < SALLIES_PER_SECOND * dt) sally();
        front.march(time, dt);
        for (Company company : companies) company.march(time, dt);
        for (int i = 0; i < tanks.length; i++) {
            Tank tank = tanks[i];
            if (!tank.isSliding(time)) tank.drive(friction);
            x[i] = tank.getX();
            y[i] = tank.getY();
        }
        brake();
        separate();
        if (time > FIRST_SHOT) artillery.fire(dice, time, dt);
    }

    private void countJitters() {
        jittering = 0;
        for (Tank tank : tanks) {
            tank.countReversal();
            if (tank.jitters()) jittering++;
        }
    }

    private void sally() {
        Company company = companies[dice.below(companies.length)];
        if (company.line.depth == 0) company.sally(time);
    }

    /** Sets the library's friction; or applies a force instead, which causes the jitters. */
    private void brake() {
        for (Tank tank : tanks) {
            double f = tank.friction(friction, time), library = naive ? 0 : f;
            if (tank.getFriction() != library) tank.setFriction(library);
            if (naive) tank.applyForce(-f * tank.getVx(), -f * tank.getVy());
        }
    }

    private void separate() {
        Arrays.fill(fx, 0);
        Arrays.fill(fy, 0);
        grid.fill(x, y);
        grid.forEachPair(keepApart);
        for (int i = 0; i < tanks.length; i++) if (fx[i] != 0 || fy[i] != 0) tanks[i].applyForce(fx[i], fy[i]);
    }

    /** Pushes two tanks apart, harder at shorter distances. */
    private void keepApart(int i, int j) {
        double dx = x[i] - x[j], dy = y[i] - y[j], squared = dx * dx + dy * dy;
        if (squared >= APART * APART || squared == 0) return;
        double distance = Math.sqrt(squared);
        double speed = GENTLE * (1 - distance / APART) + FIRM * Math.max(0, 1 - distance / TOUCH);
        double force = friction * speed / distance;
        fx[i] += force * dx;
        fy[i] += force * dy;
        fx[j] -= force * dx;
        fy[j] -= force * dy;
    }

    static double limit(double v, double max) {
        return Math.max(-max, Math.min(max, v));
    }

    /** All tanks, in the order of the world's units. */
    public Tank[] tanks() {
        return tanks;
    }

    /** The last blasts, oldest first. */
    public Iterable<Blast> blasts() {
        return artillery.blasts();
    }

    public Iterable<Shell> shells() {
        return artillery.shells();
    }

    int blastCount() {
        return artillery.count();
    }

    public World world() {
        return world;
    }

    public double time() {
        return time;
    }

    /** The number of tanks that jitter. */
    public int jittering() {
        return jittering;
    }

    /** A hash of the world and of all other data that determine the rest of the game. */
    public long stateHash() {
        long hash = Churn.scramble(world.stateHash() + dice.state) + Double.doubleToRawLongBits(time);
        hash = Churn.scramble(hash + Double.doubleToRawLongBits(friction)) + (naive ? 1 : 0);
        hash = artillery.hash(front.hash(hash));
        for (Company company : companies) hash = company.hash(hash);
        return hash;
    }
}
