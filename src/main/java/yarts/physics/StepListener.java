package yarts.physics;

/**
 * Is called before and after each step of a {@link World}.
 *
 * <p>Before the step is the place for forces that the game works out anew for every step, such as steering or springs;
 * after it, for corrections of where the step has led, such as out of a wall. Units may be added and removed in both.
 * Stepping, saving or restoring the world from here is an {@link IllegalStateException}.
 *
 * <p>An exception thrown before a step stops it: it changes no unit, and the forces for it are dropped. One thrown after
 * it does not take it back. Either ends {@code World.advance}, which drops the time of the steps that were yet to come.
 */
@FunctionalInterface
public interface StepListener {
    /**
     * Is called before a step. A force applied here acts for this one step. {@link Unit#setPosition} is a teleport, as it
     * is between steps: what is drawn starts from there.
     *
     * @param world the world about to step
     * @param dt the length of the step, in seconds
     */
    void beforeStep(World world, double dt);

    /**
     * Is called after a step. {@link Unit#setPosition} corrects the step's end here: what is drawn runs from where the step
     * began to the corrected place. A force applied here acts for the next step of the same advance; after its last, it is as
     * one applied between frames. Does nothing unless it is overridden.
     *
     * @param world the world that has stepped
     * @param dt the length of the step, in seconds
     */
    default void afterStep(World world, double dt) {}
}
