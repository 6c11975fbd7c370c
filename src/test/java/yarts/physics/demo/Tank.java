package yarts.physics.demo;

import yarts.physics.Unit;

/** A tank with a place in its company. The library moves it; the rest belongs to the game. */
public final class Tank extends Unit {
    public static final double MASS = 20_000; // kg
    public static final double LENGTH = 3.4, BREADTH = 2.8; // m
    /** f/m, in 1/s. A tank stops within a fraction of a metre, and z > 1 below 40 ticks/s. */
    public static final double FRICTION = 40;

    static final double TOP_SPEED = 60; // m/s, which only blasts reach
    static final double CRUISE = 9; // m/s
    /** Near its place, a tank drives at this rate times the distance that is left. */
    private static final double ARRIVAL = 2; // 1/s
    /** A closer tank has arrived. */
    private static final double ARRIVED = 0.01; // m

    /** A tank that a blast threw slides for this time, with at most this friction. */
    private static final double SLIDE = 0.6, SLIDE_FRICTION = 6; // s, 1/s

    /** Reversals in a row that count as jitter. One or two can have other causes: an order, another tank, a blast. */
    private static final int JITTER = 3;

    final Company company;
    private final double back, y; // its place, in m
    private double lastVx, lastVy; // m/s, after the last step
    private int reversals;
    double lastHit = Double.NEGATIVE_INFINITY, lastShot = Double.NEGATIVE_INFINITY; // s
    /** The direction of its gun, a vector of length 1. */
    double aimX, aimY;

    Tank(Company company, int rank, int file, Dice dice) {
        super(MASS);
        this.company = company;
        back = company.back(rank, file) + dice.within(0.25); // places are not quite regular
        y = company.y(rank, file) + dice.within(0.25);
        aimX = isWest() ? 1 : -1;
        setPosition(placeX(), placeY()).setMaxSpeed(TOP_SPEED);
    }

    public boolean isWest() {
        return company.isWest();
    }

    /** The time at which a blast last threw it; in s. */
    public double lastHit() {
        return lastHit;
    }

    /** The time of its last shot; in s. */
    public double lastShot() {
        return lastShot;
    }

    /** The direction of its gun; with {@link #aimY}, a vector of length 1. */
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

    /** The distance from its place; in m. */
    public double distanceFromPlace() {
        double dx = placeX() - getX(), dy = placeY() - getY();
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Whether it slides after a blast and cannot drive. */
    public boolean isSliding(double time) {
        return time - lastHit < SLIDE;
    }

    /** Its friction: that of the ground, or less while it slides. Both in N·s/m. */
    double friction(double ground, double time) {
        return isSliding(time) ? Math.min(ground, SLIDE_FRICTION * MASS) : ground;
    }

    /** Pushes it towards its place. The friction, in N·s/m, balances the force at the intended speed. */
    void drive(double friction) {
        double dx = placeX() - getX(), dy = placeY() - getY();
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance < ARRIVED) return;
        double k = friction * Math.min(ARRIVAL, CRUISE / distance);
        applyForce(k * dx, k * dy);
    }

    /** Counts reversals of its velocity; called after every step. */
    void countReversal() {
        double vx = getVx(), vy = getVy();
        reversals = vx * lastVx + vy * lastVy < 0 ? reversals + 1 : 0;
        lastVx = vx;
        lastVy = vy;
    }

    /** Whether each of the last three steps reversed it. */
    public boolean jitters() {
        return reversals >= JITTER;
    }
}
