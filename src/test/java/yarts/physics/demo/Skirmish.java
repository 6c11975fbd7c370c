package yarts.physics.demo;

import java.util.Arrays;
import yarts.physics.Integrator;
import yarts.physics.StepListener;
import yarts.physics.Timestep;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * A game of two armies that hold a front against each other. The front bends to and fro, companies follow it, sally and
 * withdraw, shells throw tanks out of the ranks, and they drive back to their places. Before each step the game drives its
 * tanks, keeps them apart and fires; the world moves them. The same seed plays the same battle, to the bit, on the web as
 * on a JVM.
 */
public final class Skirmish {
    public static final int TICKS_PER_SECOND = 60;
    public static final double WIDTH = 400; // m
    public static final double HEIGHT = 300; // m

    static final double NO_MANS_LAND = 34; // m
    private static final int MOST_LANES = 12;
    private static final double WIDEST_LANE = 48, MARGIN = 5; // m
    private static final double ORDERS_PER_SECOND = 0.8, SALLIES_PER_SECOND = 1;
    private static final double FIRST_SHOT = 3, FIRST_ORDER = 5; // s

    /** Tanks closer than the first are pushed apart gently, and closer than the second firmly. */
    private static final double APART = 4.2, TOUCH = 3.6; // m

    private static final double GENTLE = 2.5, FIRM = 12; // m/s, for tanks in the same place

    /** Where and when a shell burst; in m and s. */
    public record Blast(double x, double y, double time) {}

    /** One in flight: from where, to where, when it was fired and when it bursts. Only a heavy one makes a blast. */
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
    private int turned;

    public Skirmish(int tanksAnArmy, long seed) {
        dice = new Dice(seed);
        int perArmy = (tanksAnArmy + Company.SIZE - 1) / Company.SIZE;
        int lanes = Math.min(perArmy, MOST_LANES);
        front = new Front((perArmy + lanes - 1) / lanes);
        companies = new Company[2 * perArmy];
        for (int i = 0; i < companies.length; i++) companies[i] = company(i % 2 == 0, i / 2, lanes);
        tanks = new Tank[2 * tanksAnArmy];
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
        brake();
    }

    /** Companies go side by side from the middle outwards, and then behind each other. */
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

    /** Whether the game brakes its tanks itself, by a force of −f·v, as one does until one sees the jitters. */
    public void setNaive(boolean naive) {
        this.naive = naive;
    }

    /** Plays a frame's time; returns how many ticks that were. */
    public int advance(double seconds) {
        return world.advance(seconds);
    }

    /** Plays one tick. */
    public void tick() {
        world.step();
    }

    /** A player's shell. */
    public void blastAt(double x, double y) {
        artillery.burst(x, y, time);
    }

    private void command(double dt) {
        time += dt;
        if (time > FIRST_ORDER && dice.next() < ORDERS_PER_SECOND * dt) front.order(dice, time);
        if (time > FIRST_ORDER && dice.next() < SALLIES_PER_SECOND * dt) sally();
        front.march(time, dt);
        for (Company company : companies) company.march(time, dt);
        turned = 0;
        for (int i = 0; i < tanks.length; i++) {
            Tank tank = tanks[i];
            if (tank.jitters()) turned++;
            if (!tank.isSliding(time)) tank.drive(friction);
            x[i] = tank.getX();
            y[i] = tank.getY();
        }
        brake();
        separate();
        if (time > FIRST_SHOT) artillery.fire(dice, time, dt);
    }

    private void sally() {
        Company company = companies[dice.below(companies.length)];
        if (company.line.depth == 0) company.sally(time);
    }

    /** By the library's friction; or by a force, which is the bug that the library is for. */
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

    /** Pushes two tanks apart: the closer, the harder. */
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

    static double limit(double v, double most) {
        return Math.max(-most, Math.min(most, v));
    }

    /** In the order in which their interpolated positions are copied. */
    public Tank[] tanks() {
        return tanks;
    }

    /** The last ones, oldest first. */
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

    /** How many tanks the last step turned round, as had the one before: the jitters. */
    public int turned() {
        return turned;
    }

    /** The world's, and all else that decides how the game goes on. */
    public long stateHash() {
        long hash = Churn.scramble(world.stateHash() + dice.state) + Double.doubleToRawLongBits(time);
        hash = Churn.scramble(hash + Double.doubleToRawLongBits(friction)) + (naive ? 1 : 0);
        hash = artillery.hash(front.hash(hash));
        for (Company company : companies) hash = company.hash(hash);
        return hash;
    }
}
