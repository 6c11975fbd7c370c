package yarts.physics.demo;

import yarts.physics.Unit;

/** A tank of one of two armies, with a place to go to. The physics moves it; the rest is the game's. */
public final class Tank extends Unit {
    public static final double MASS = 20_000; // kg
    /** In N·s/m. So high that a tank stops within a fraction of a metre, and that z > 1 below 40 ticks a second. */
    public static final double FRICTION = 40 * MASS;

    static final double CRUISE = 10; // m/s
    static final double TOP_SPEED = 100; // m/s, reached in blasts
    private static final double BRAKING = 5; // m

    final boolean west;
    private final double targetX;
    private final double targetY;
    int hits;
    /** When a blast last threw it; in s. */
    double lastHit = Double.NEGATIVE_INFINITY;

    private double lastVx;
    private double lastVy;

    Tank(boolean west, double x, double y, double targetX, double targetY) {
        super(MASS);
        this.west = west;
        this.targetX = targetX;
        this.targetY = targetY;
        setPosition(x, y).setFriction(FRICTION).setMaxSpeed(TOP_SPEED);
    }

    /** Pushes it towards its target by the force that friction balances at cruising speed, and by less close by. */
    void drive() {
        double dx = targetX - getX();
        double dy = targetY - getY();
        double force = FRICTION * CRUISE / Math.max(BRAKING, Math.sqrt(dx * dx + dy * dy));
        applyForce(force * dx, force * dy);
    }

    /** Whether it moves backwards, compared with when it was last asked. */
    boolean hasTurned() {
        boolean turned = getVx() * lastVx + getVy() * lastVy < 0;
        lastVx = getVx();
        lastVy = getVy();
        return turned;
    }

    boolean isAcross() {
        return west == getX() > Skirmish.WIDTH / 2;
    }
}
