package yarts.physics.demo;

import yarts.physics.Unit;

/** A tank with a place in its company. The physics moves it; the rest is the game's. */
public final class Tank extends Unit {
    public static final double MASS = 20_000; // kg
    /** f/m, in 1/s. So high that a tank stops within a fraction of a metre, and that z > 1 below 40 ticks a second. */
    public static final double FRICTION = 40;

    static final double TOP_SPEED = 250; // m/s, reached in blasts
    private static final double CRUISE = 9; // m/s
    /** Near its place, a tank drives by so much of the way that is left in a second. */
    private static final double ARRIVAL = 2; // 1/s
    /** Closer than this it is there. */
    private static final double THERE = 0.01; // m

    final Company company;
    private final int rank, file;
    private final double offX, offY; // m: nobody stands quite where they should
    private double lastVx, lastVy;
    double lastHit = Double.NEGATIVE_INFINITY; // s
    double lastShot = Double.NEGATIVE_INFINITY; // s

    Tank(Company company, int rank, int file, double offX, double offY) {
        super(MASS);
        this.company = company;
        this.rank = rank;
        this.file = file;
        this.offX = offX;
        this.offY = offY;
        setPosition(placeX(), placeY()).setMaxSpeed(TOP_SPEED);
    }

    public boolean isWest() {
        return company.west;
    }

    /** When a blast last threw it; in s. */
    public double lastHit() {
        return lastHit;
    }

    /** When it last fired; in s. */
    public double lastShot() {
        return lastShot;
    }

    double placeX() {
        return company.x(rank) + offX;
    }

    double placeY() {
        return company.y(file) + offY;
    }

    /** How far it is from its place. */
    public double astray() {
        double dx = placeX() - getX(), dy = placeY() - getY();
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Pushes it towards its place by the force that friction, in N·s/m, balances at the speed that it wants. */
    void drive(double friction) {
        double dx = placeX() - getX(), dy = placeY() - getY();
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance < THERE) return;
        double k = friction * Math.min(ARRIVAL, CRUISE / distance);
        applyForce(k * dx, k * dy);
    }

    /** Whether it moves backwards, compared with when it was last asked. */
    boolean hasTurned() {
        double vx = getVx(), vy = getVy();
        boolean turned = vx * lastVx + vy * lastVy < 0;
        lastVx = vx;
        lastVy = vy;
        return turned;
    }
}
