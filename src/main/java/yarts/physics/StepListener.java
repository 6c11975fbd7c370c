package yarts.physics;

/**
 * Is called before each step of a {@link World}: the place for forces that the game works out anew for every step, such
 * as steering or springs.
 *
 * <p>A force applied here acts for this one step. Units may be added and removed here; stepping the world from here is
 * an {@link IllegalStateException}.
 */
@FunctionalInterface
public interface StepListener {
    /**
     * Is called before a step.
     *
     * @param world the world about to step
     * @param dt the length of the step, in seconds
     */
    void beforeStep(World world, double dt);
}
