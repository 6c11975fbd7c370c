package yarts.physics.comparison;

import org.dyn4j.dynamics.TimeStep;
import org.dyn4j.world.PhysicsWorld;
import org.dyn4j.world.listener.StepListenerAdapter;

/** What a game does in a frame: it pushes, or does not, and runs the steps of 1/60 s that the frame has time for. */
interface Loop {
    double TICK = 1 / 60.0;

    void run(boolean pushes);

    /** A loop over an engine and one body of 1 kg without friction, at a number of frames a second, pushed by 1 N. */
    interface Maker {
        Loop of(Engine engine, Engine.Body body, int framesPerSecond);
    }

    /** The usual loop: push, add the frame's time to what is left, step while there is enough for a step. */
    static Loop accumulate(Engine engine, Engine.Body body, int framesPerSecond) {
        int[] left = {0}; // in parts of a tick, of which a frame has 60: this clock loses nothing
        return pushes -> {
            if (pushes) body.push(1);
            for (left[0] += 60; left[0] >= framesPerSecond; left[0] -= framesPerSecond) engine.step(TICK);
        };
    }

    /** As Box2D documents it for steps that are not frames: forces stay for all the frame's steps, then are cleared. */
    static Loop clearOnceAFrame(Engine engine, Engine.Body body, int framesPerSecond) {
        Loop loop = accumulate(engine.keepingForces(), body, framesPerSecond);
        return pushes -> {
            loop.run(pushes);
            engine.endFrame();
        };
    }

    /** The game pushes in every step. */
    static Loop pushInEachStep(Engine engine, Engine.Body body, int framesPerSecond) {
        int[] left = {0};
        return pushes -> {
            for (left[0] += 60; left[0] >= framesPerSecond; left[0] -= framesPerSecond) {
                if (pushes) body.push(1);
                engine.step(TICK);
            }
        };
    }

    /** A step as long as the frame. */
    static Loop stepOfTheFrame(Engine engine, Engine.Body body, int framesPerSecond) {
        return pushes -> {
            if (pushes) body.push(1);
            engine.step(1.0 / framesPerSecond);
        };
    }

    /** dyn4j's own accumulator. */
    static Loop dyn4jUpdate(Engine engine, Engine.Body body, int framesPerSecond) {
        return pushes -> {
            if (pushes) body.push(1);
            ((Dyn4j) engine).world.update(1.0 / framesPerSecond, 10);
        };
    }

    static Loop dyn4jListener(Engine engine, Engine.Body body, int framesPerSecond) {
        boolean[] pushed = {false};
        ((Dyn4j) engine).world.addStepListener(new StepListenerAdapter<>() {
            @Override
            public void begin(TimeStep step, PhysicsWorld<org.dyn4j.dynamics.Body, ?> world) {
                if (pushed[0]) body.push(1);
            }
        });
        return pushes -> {
            pushed[0] = pushes;
            ((Dyn4j) engine).world.update(1.0 / framesPerSecond, 10);
        };
    }

    static Loop dyn4jUpdatev(Engine engine, Engine.Body body, int framesPerSecond) {
        return pushes -> {
            if (pushes) body.push(1);
            ((Dyn4j) engine).world.updatev(1.0 / framesPerSecond);
        };
    }

    /** Ours. */
    static Loop advance(Engine engine, Engine.Body body, int framesPerSecond) {
        return pushes -> {
            if (pushes) body.push(1);
            ((Ours) engine).world.advance(1.0 / framesPerSecond);
        };
    }
}
