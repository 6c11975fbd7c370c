package yarts.physics.comparison;

/**
 * A world of bodies on a line, in some engine. Each body is a disc of radius 0.5 m that follows m dv/dt = F − f v, as
 * well as the engine can. An engine is stepped as its own manual says; bodies never sleep.
 */
interface Engine {
    /** The damping that makes a body of a rigid-body engine follow m dv/dt = −f v; in 1/s. */
    static double damping(double friction, double mass) {
        return friction == 0 ? 0 : friction / mass;
    }

    Body add(double mass, double friction, double x, double v);

    void step(double dt);

    /** Lets forces act until {@link #endFrame}, where an engine can, instead of for one step. */
    default Engine keepingForces() {
        throw new UnsupportedOperationException();
    }

    default void endFrame() {}

    /** A body, seen along the line. */
    interface Body {
        void push(double force);

        double x();

        double v();

        void stop();
    }
}
