package game;

import yarts.physics.Unit;

/** What a game makes of a unit: it knows its engine, and how to drive. */
final class Tank extends Unit {
    private final double engine; // N

    Tank(double engine) {
        super(40_000);
        this.engine = engine;
        setFriction(8_000).setMaxSpeed(15);
    }

    double getEngine() {
        return engine;
    }

    void drive() {
        applyForce(engine, 0);
    }
}
