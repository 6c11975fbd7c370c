package game;

import yarts.physics.Unit;

/** A unit of the game, with an engine. */
final class Tank extends Unit {
    static final double BRAKES = 200_000; // N

    private final double engine; // N

    Tank(double engine) {
        super(40_000);
        this.engine = engine;
        setFriction(8_000).setMaxSpeed(15);
    }

    double getEngine() {
        return engine;
    }

    /** Full throttle. */
    void drive() {
        applyForce(engine, 0);
    }

    void go(double vx, double vy) {
        setMotor(vx, vy, engine);
    }

    void brake() {
        setMotor(0, 0, BRAKES);
    }
}
