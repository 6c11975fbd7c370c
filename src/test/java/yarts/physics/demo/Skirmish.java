package yarts.physics.demo;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Random;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.World;

/**
 * A game of two armies that drive at, and through, each other. Before each step the game drives its tanks, keeps them apart
 * and fires; the world moves them. The same seed plays the same battle, to the bit.
 */
public final class Skirmish {
    public static final int TICKS_PER_SECOND = 60;
    public static final double WIDTH = 320; // m
    public static final double HEIGHT = 240; // m

    private static final int ROWS = 40;
    private static final double FRIENDS_APART = 4.5; // m
    private static final double ENEMIES_APART = 9; // m
    /** The force between tanks in the same place, in N: against friction it moves them at 22 m/s. */
    private static final double SHOVE = 22 * Tank.FRICTION;

    private static final double BLASTS_PER_SECOND = 8;
    static final double BLAST_RADIUS = 14; // m
    /** What a blast gives a tank at its centre, in N·s: it throws it at 100 m/s, which friction stops within 2.5 m. */
    private static final double BLAST = 100 * Tank.MASS;

    /** Where and when a shell burst. */
    record Blast(double x, double y, double time) {}

    private final Tank[] tanks;
    private final Random random;
    private final Grid grid;
    private final Grid.Pair keepApart = this::keepApart;
    private final double[] x, y, fx, fy;
    private final Deque<Blast> blasts = new ArrayDeque<>();
    private World world;
    private boolean naive;
    private double time;
    private int blastCount;
    private int turned;
    private long gameNanos;

    public Skirmish(int tanksAnArmy, long seed) {
        random = new Random(seed);
        tanks = new Tank[2 * tanksAnArmy];
        for (int i = 0; i < tanks.length; i++) tanks[i] = recruit(i / 2, i % 2 == 0);
        x = new double[tanks.length];
        y = new double[tanks.length];
        fx = new double[tanks.length];
        fy = new double[tanks.length];
        grid = new Grid(WIDTH, HEIGHT, ENEMIES_APART, tanks.length);
        use(Integrator.EULER, Timestep.fixed(TICKS_PER_SECOND));
    }

    /** The west strikes through the centre, the east in two wings; each tank has its place in the formation. */
    private Tank recruit(int index, boolean west) {
        double back = 10 + 4.4 * (index / ROWS) + random.nextDouble();
        double across = (index % ROWS - (ROWS - 1) / 2.0) * 5.4 + random.nextDouble();
        double goal = west ? 0.55 * across : 0.55 * across + Math.copySign(46, across);
        double middle = HEIGHT / 2;
        return west
                ? new Tank(true, back, middle + across, WIDTH - 130 + back, middle + goal)
                : new Tank(false, WIDTH - back, middle + across, 130 - back, middle + goal);
    }

    /** Plays on in a new world: the units take their state along. */
    void use(Integrator integrator, Timestep timestep) {
        if (world != null) world.clear();
        world = new World(integrator, timestep);
        world.setStepListener((w, dt) -> command(dt));
        for (Tank tank : tanks) world.add(tank);
    }

    /** Whether the game brakes its tanks itself, by a force of −f·v, as one does until one sees the jitters. */
    void setNaiveFriction(boolean naive) {
        this.naive = naive;
        for (Tank tank : tanks) tank.setFriction(naive ? 0 : Tank.FRICTION);
    }

    /** Plays one tick. */
    public void tick() {
        world.step();
    }

    /** What the game does before each step. */
    private void command(double dt) {
        long start = System.nanoTime();
        time += dt;
        turned = 0;
        for (int i = 0; i < tanks.length; i++) {
            Tank tank = tanks[i];
            if (tank.hasTurned()) turned++;
            tank.drive();
            if (naive) tank.applyForce(-Tank.FRICTION * tank.getVx(), -Tank.FRICTION * tank.getVy());
            x[i] = tank.getX();
            y[i] = tank.getY();
        }
        separate();
        if (random.nextDouble() < BLASTS_PER_SECOND * dt) fire();
        gameNanos += System.nanoTime() - start;
    }

    private void separate() {
        Arrays.fill(fx, 0);
        Arrays.fill(fy, 0);
        grid.fill(x, y);
        grid.forEachPair(keepApart);
        for (int i = 0; i < tanks.length; i++) tanks[i].applyForce(fx[i], fy[i]);
    }

    /** Pushes two tanks apart: the closer, the harder. */
    private void keepApart(int i, int j) {
        double dx = x[i] - x[j];
        double dy = y[i] - y[j];
        double squared = dx * dx + dy * dy;
        double apart = tanks[i].west == tanks[j].west ? FRIENDS_APART : ENEMIES_APART;
        if (squared >= apart * apart || squared == 0) return;
        double distance = Math.sqrt(squared);
        double force = SHOVE * (1 / distance - 1 / apart); // times distance: SHOVE (1 − distance/apart)
        fx[i] += force * dx;
        fy[i] += force * dy;
        fx[j] -= force * dx;
        fy[j] -= force * dy;
    }

    /** A shell bursts near one of the tanks, and throws those around it outwards. */
    private void fire() {
        Tank aim = tanks[random.nextInt(tanks.length)];
        Blast blast = new Blast(aim.getX() + miss(), aim.getY() + miss(), time);
        blasts.add(blast);
        if (blasts.size() > 16) blasts.remove();
        blastCount++;
        for (Tank tank : tanks) {
            double dx = tank.getX() - blast.x;
            double dy = tank.getY() - blast.y;
            double distance = Math.sqrt(dx * dx + dy * dy);
            if (distance >= BLAST_RADIUS || distance == 0) continue;
            double impulse = BLAST * (1 - distance / BLAST_RADIUS) / distance;
            tank.applyImpulse(impulse * dx, impulse * dy);
            tank.hits++;
            tank.lastHit = time;
        }
    }

    private double miss() {
        return 8 * random.nextDouble() - 4;
    }

    /** In the order in which their interpolated positions are copied. */
    Tank[] tanks() {
        return tanks;
    }

    Deque<Blast> blasts() {
        return blasts;
    }

    World world() {
        return world;
    }

    double time() {
        return time;
    }

    int blastCount() {
        return blastCount;
    }

    /** How many tanks the last step turned round. */
    int turned() {
        return turned;
    }

    /** The time that the game's own part has taken so far. */
    long gameNanos() {
        return gameNanos;
    }

    /** A hash of where every tank is and how it moves. */
    public int stateHash() {
        int hash = 1;
        for (Tank tank : tanks) {
            double[] state = {tank.getX(), tank.getY(), tank.getVx(), tank.getVy()};
            hash = 31 * hash + Arrays.hashCode(state);
        }
        return hash;
    }
}
