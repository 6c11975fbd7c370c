package yarts.physics;

/**
 * A game's own part of each step of a {@link World}. A world has any number of listeners before the step and after it.
 *
 * <pre>{@code
 * world.addBeforeStep((w, dt) -> steer(w));        // forces that depend on the state of each step
 * world.addAfterStep((w, dt) -> resolveWalls(w));  // corrections, by Unit.moveTo
 * }</pre>
 *
 * <p>A force that is applied before a step acts for exactly that step; one that is applied after a step acts for exactly
 * the next step, whichever call runs it. Listeners may add and remove units and listeners. They must not step, save or
 * restore their world, nor set its integrator or timestep: that is an {@link IllegalStateException}.
 *
 * <p>If a listener throws an exception, the listeners after it are not called, and the call that runs the step ends with
 * that exception. Before a step, this also cancels the step: no unit changes, and the forces for it are discarded. In
 * {@code World.advance}, the time of the steps that have not run is dropped.
 */
@FunctionalInterface
public interface StepListener {
    /**
     * Called before or after a step, as the listener was added.
     *
     * @param world the world
     * @param dt the length of the step, in seconds
     */
    void onStep(World world, double dt);
}
