package yarts.physics.comparison;

import java.util.function.DoubleConsumer;

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

        /** Drives it to an ordered velocity by at most maxForce: by a friction joint to a moving body, or by our motor. */
        default Drive drive(double maxForce) {
            throw new UnsupportedOperationException();
        }

        /**
         * The same by a motor joint, which removes a part of its distance from its target in a step. With a correction of 0,
         * the joint is to a moving body instead.
         */
        default Drive drive(double maxForce, double correction) {
            throw new UnsupportedOperationException();
        }
    }

    /** What drives a body to an ordered velocity. */
    interface Drive {
        void order(double velocity);

        /** To be called before each step. */
        default void beforeStep(double dt) {}
    }

    /** The drive of a motor joint: its target moves at the ordered velocity. */
    final class MovingTarget implements Drive {
        private final DoubleConsumer setTarget;
        private double velocity, target;

        MovingTarget(double from, DoubleConsumer setTarget) {
            this.target = from;
            this.setTarget = setTarget;
        }

        @Override
        public void order(double velocity) {
            this.velocity = velocity;
        }

        @Override
        public void beforeStep(double dt) {
            target += velocity * dt;
            setTarget.accept(target);
        }
    }
}
