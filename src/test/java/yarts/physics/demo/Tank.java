package yarts.physics.demo;

import yarts.physics.Unit;

/** A tank with a place in its company. The physics moves it; the rest is the game's. */
public final class Tank extends Unit {
    public static final double MASS = 20_000; // kg
    public static final double LENGTH = 3.4, BREADTH = 2.8; // m
    /** f/m, in 1/s. So high that a tank stops within a fraction of a metre, and that z > 1 below 40 ticks a second. */
    public static final double FRICTION = 40;

    static final double TOP_SPEED = 60; // m/s, reached in blasts
    static final double CRUISE = 9; // m/s
    /** Near its place, a tank drives by so much of the way that is left in a second. */
    private static final double ARRIVAL = 2; // 1/s
    /** Closer than this it is there. */
    private static final double THERE = 0.01; // m

    /** What a blast has thrown slides for a while, with so much friction at most. */
    private static final double SLIDE = 0.6, SLIDE_FRICTION = 6; // s, 1/s

    final Company company;
    private final double back, y; // its place
    private double lastVx, lastVy;
    private boolean turned;
    double lastHit = Double.NEGATIVE_INFINITY, lastShot = Double.NEGATIVE_INFINITY; // s
    /** Where its gun points. */
    double aimX, aimY;

    Tank(Company company, int rank, int file, Dice dice) {
        super(MASS);
        this.company = company;
        back = company.back(rank, file) + dice.within(0.25); // nobody stands quite where they should
        y = company.y(rank, file) + dice.within(0.25);
        aimX = isWest() ? 1 : -1;
        setPosition(placeX(), placeY()).setMaxSpeed(TOP_SPEED);
    }

    public boolean isWest() {
        return company.isWest();
    }

    /** When a blast last threw it; in s. */
    public double lastHit() {
        return lastHit;
    }

    /** When it last fired; in s. */
    public double lastShot() {
        return lastShot;
    }

    /** Where its gun points, with {@link #aimY} a vector of length 1. */
    public double aimX() {
        return aimX;
    }

    public double aimY() {
        return aimY;
    }

    double placeX() {
        return company.x(back, y);
    }

    double placeY() {
        return y;
    }

    /** How far it is from its place. */
    public double astray() {
        double dx = placeX() - getX(), dy = placeY() - getY();
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Whether it still slides from a blast, and cannot drive. */
    public boolean isSliding(double time) {
        return time - lastHit < SLIDE;
    }

    /** Its friction, in N·s/m: the ground's, in N·s/m, unless it slides. */
    double friction(double ground, double time) {
        return isSliding(time) ? Math.min(ground, SLIDE_FRICTION * MASS) : ground;
    }

    /** Pushes it towards its place by the force that friction, in N·s/m, balances at the speed that it wants. */
    void drive(double friction) {
        double dx = placeX() - getX(), dy = placeY() - getY();
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance < THERE) return;
        double k = friction * Math.min(ARRIVAL, CRUISE / distance);
        applyForce(k * dx, k * dy);
    }

    /** Whether it was turned round by each of the last two steps; to be asked before every step. */
    boolean jitters() {
        double vx = getVx(), vy = getVy();
        boolean turns = vx * lastVx + vy * lastVy < 0, jitters = turns && turned;
        turned = turns;
        lastVx = vx;
        lastVy = vy;
        return jitters;
    }
}
