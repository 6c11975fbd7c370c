package yarts.physics;

/**
 * Code of the game that runs before or after each step of a {@link World}, such as steering or the correction of
 * positions.
 *
 * <pre>{@code
 * world.addBeforeStep((w, dt) -> steer(w));        // forces that depend on the state of each step
 * world.addAfterStep((w, dt) -> resolveWalls(w));  // corrections, by Unit.moveTo
 * }</pre>
 *
 * <p>A force that a before-step listener applies acts for exactly this step. A force that an after-step listener
 * applies acts for exactly the next step, even if a later call runs it. Listeners may add and remove units and
 * listeners. If they step, save or restore their world, or set its integrator or timestep, an {@link
 * IllegalStateException} is thrown.
 *
 * <p>If a listener throws an exception, the listeners after it are not called, and the call that runs the step throws
 * the same exception. An exception before a step also cancels the step: no unit moves, and the forces for the step are
 * discarded. In {@code World.advance}, the time of the steps that have not run is dropped.
 */
@FunctionalInterface
public interface StepListener {
    /**
     * Runs before each step, if the listener was added by {@link World#addBeforeStep}, or after each step, if it was
     * added by {@link World#addAfterStep}.
     *
     * @param world the world that steps
     * @param dt the length of the step, in seconds
     */
    void onStep(World world, double dt);
}
