package yarts.physics.demo;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * A game of two armies that hold a front against each other. Orders move the front to and fro, lane by lane; companies
 * advance and withdraw in turn; shells throw tanks out of the ranks, and they drive back to their places. Before each step
 * the game drives its tanks, keeps them apart and fires; the world moves them. The same seed plays the same battle, to the
 * bit, on the web as on a JVM.
 */
public final class Skirmish {
    public static final int TICKS_PER_SECOND = 60;
    public static final double WIDTH = 400; // m
    public static final double HEIGHT = 300; // m

    static final int LANES = 5;
    static final double LANE = 58; // m
    static final double NO_MANS_LAND = 24; // m

    /** How far apart the armies begin: each by so much behind the first line. */
    private static final double ASSEMBLY = 34; // m
    /** How far the front may be from the middle, and one lane's front from the next one's. */
    private static final double FARTHEST = 36, STEEPEST = 24; // m

    private static final double SHORTEST = 10; // m: an order
    private static final double ORDERS_PER_SECOND = 1.2;
    private static final double COMPANY_DELAY = 0.8, ATTACK_DELAY = 2.5, LANE_DELAY = 0.7; // s

    /** Tanks closer than the first are pushed apart gently, and closer than the second firmly. */
    private static final double APART = 4.6, TOUCH = 3.6; // m

    private static final double GENTLE = 2.5, FIRM = 12; // m/s, for tanks in the same place

    private static final double SHELLS_PER_SECOND = 0.004; // of each tank
    static final double BLAST_RADIUS = 13; // m
    /** How fast a blast throws a tank at its centre: friction stops it within 6 m. */
    private static final double BLAST = 240; // m/s

    private static final int KEPT_BLASTS = 24;

    /** Where and when a shell burst, and where it came from; a player's comes from where it bursts. */
    public record Blast(double x, double y, double time, double fromX, double fromY) {}

    private final Tank[] tanks;
    private final Company[] companies;
    /** Where the fronts of the lanes are ordered to be. */
    private final double[] front = new double[LANES];

    private final Grid grid;
    private final Grid.Pair keepApart = this::keepApart;
    private final double[] x, y, fx, fy;
    private final Deque<Blast> blasts = new ArrayDeque<>();
    private final World world = new World(Integrator.EULER, Timestep.fixed(TICKS_PER_SECOND));
    private boolean naive;
    private double friction = Tank.FRICTION * Tank.MASS; // N·s/m
    private double time; // s
    private long seed;
    private int blastCount, turned;

    public Skirmish(int tanksAnArmy, long seed) {
        this.seed = Churn.scramble(seed);
        Arrays.fill(front, WIDTH / 2);
        int perArmy = (tanksAnArmy + Company.SIZE - 1) / Company.SIZE;
        companies = new Company[2 * perArmy];
        tanks = new Tank[2 * tanksAnArmy];
        for (int i = 0; i < companies.length; i++) {
            boolean west = i % 2 == 0;
            // The middle lane first, then those on its left and right.
            int k = i / 2 % LANES, lane = LANES / 2 + (k % 2 == 0 ? -k / 2 : k / 2 + 1);
            companies[i] = new Company(west, lane, i / 2 / LANES, WIDTH / 2 + (west ? -ASSEMBLY : ASSEMBLY));
            companies[i].order(WIDTH / 2, 1 + k * LANE_DELAY + companies[i].depth * COMPANY_DELAY);
        }
        for (int i = 0; i < tanks.length; i++) {
            int k = i / 2;
            Company company = companies[k / Company.SIZE * 2 + i % 2];
            int place = k % Company.SIZE;
            tanks[i] = new Tank(company, place / Company.FILES, place % Company.FILES, near(0.35), near(0.35));
            world.add(tanks[i]);
        }
        x = new double[tanks.length];
        y = new double[tanks.length];
        fx = new double[tanks.length];
        fy = new double[tanks.length];
        grid = new Grid(WIDTH, HEIGHT, APART, tanks.length);
        world.setStepListener((w, dt) -> command(dt));
        setNaive(false);
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
        setNaive(naive);
    }

    /** Whether the game brakes its tanks itself, by a force of −f·v, as one does until one sees the jitters. */
    public void setNaive(boolean naive) {
        this.naive = naive;
        for (Tank tank : tanks) tank.setFriction(naive ? 0 : friction);
    }

    /** Plays a frame's time; returns how many ticks that were. */
    public int advance(double seconds) {
        return world.advance(seconds);
    }

    /** Plays one tick. */
    public void tick() {
        world.step();
    }

    /** What the game does before each step. */
    private void command(double dt) {
        time += dt;
        turned = 0;
        if (random() < ORDERS_PER_SECOND * dt) moveFront();
        for (Company company : companies) company.obey(time);
        for (int i = 0; i < tanks.length; i++) {
            Tank tank = tanks[i];
            if (tank.hasTurned()) turned++;
            tank.drive(friction);
            if (naive) tank.applyForce(-friction * tank.getVx(), -friction * tank.getVy());
            x[i] = tank.getX();
            y[i] = tank.getY();
        }
        separate();
        if (random() < SHELLS_PER_SECOND * tanks.length * dt) fire();
    }

    /** One lane gives way, from the rear on; then the other side follows, its first company first. */
    private void moveFront() {
        int lane = (int) (random() * LANES);
        double next = WIDTH / 2 + near(FARTHEST);
        for (int other = Math.max(0, lane - 1); other <= Math.min(LANES - 1, lane + 1); other++) {
            if (other != lane && Math.abs(front[other] - next) > STEEPEST) return;
        }
        if (Math.abs(next - front[lane]) < SHORTEST) return;
        boolean eastwards = next > front[lane];
        front[lane] = next;
        int deepest = companies[companies.length - 1].depth;
        for (Company company : companies) {
            if (company.lane != lane) continue;
            boolean attacks = company.west == eastwards;
            int turn = attacks ? company.depth : deepest - company.depth;
            company.order(next, time + turn * COMPANY_DELAY + (attacks ? ATTACK_DELAY : 0));
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

    /** A tank in the first company of a lane fires at one on the other side. */
    private void fire() {
        Tank shooter = tanks[(int) (random() * tanks.length)], target = tanks[(int) (random() * tanks.length)];
        for (int tries = 0; tries < 50; tries++) {
            Company a = shooter.company, b = target.company;
            if (a.west != b.west && a.depth == 0 && b.depth == 0 && a.lane - b.lane <= 1 && b.lane - a.lane <= 1) {
                shooter.lastShot = time;
                burst(target.getX() + near(4), target.getY() + near(4), shooter.getX(), shooter.getY());
                return;
            }
            shooter = tanks[(int) (random() * tanks.length)];
            target = tanks[(int) (random() * tanks.length)];
        }
    }

    /** A player's shell. */
    public void blastAt(double x, double y) {
        burst(x, y, x, y);
    }

    /** Throws those around it outwards. */
    private void burst(double x, double y, double fromX, double fromY) {
        blasts.add(new Blast(x, y, time, fromX, fromY));
        if (blasts.size() > KEPT_BLASTS) blasts.remove();
        blastCount++;
        for (Tank tank : tanks) {
            double dx = tank.getX() - x, dy = tank.getY() - y;
            double distance = Math.sqrt(dx * dx + dy * dy);
            if (distance >= BLAST_RADIUS || distance == 0) continue;
            double impulse = Tank.MASS * BLAST * (1 - distance / BLAST_RADIUS) / distance;
            tank.applyImpulse(impulse * dx, impulse * dy);
            tank.lastHit = time;
        }
    }

    /** From 0 to 1, from the game's own state: java.util.Random is not the same everywhere. */
    private double random() {
        return (Churn.scramble(seed += Churn.GOLDEN) >>> 11) * 0x1p-53;
    }

    private double near(double most) {
        return most * (2 * random() - 1);
    }

    /** In the order in which their interpolated positions are copied. */
    public Tank[] tanks() {
        return tanks;
    }

    public Iterable<Blast> blasts() {
        return blasts;
    }

    public World world() {
        return world;
    }

    public double time() {
        return time;
    }

    int blastCount() {
        return blastCount;
    }

    /** How many tanks the last step turned round. */
    public int turned() {
        return turned;
    }

    /** The world's, and what else decides how the game goes on. */
    public long stateHash() {
        long hash = Churn.scramble(world.stateHash() + seed);
        for (Company company : companies) hash = Churn.scramble(hash + Double.doubleToRawLongBits(company.front));
        return hash;
    }
}
