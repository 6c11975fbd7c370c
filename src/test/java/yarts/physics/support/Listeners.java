package yarts.physics.support;

import yarts.physics.StepListener;
import yarts.physics.World;

/** One listener before each step of a world and one after it, both replaceable by tests. */
public final class Listeners {
    private final World world;
    private StepListener before, after;

    /** Starts without listeners in a world. */
    public Listeners(World world) {
        this.world = world;
    }

    /** Replaces both. */
    public void set(StepListener before, StepListener after) {
        clear();
        this.before = before;
        this.after = after;
        world.addBeforeStep(before);
        world.addAfterStep(after);
    }

    /** Replaces both by one that is called before each step. */
    public void setBefore(StepListener listener) {
        set(listener, (w, dt) -> {});
    }

    /** Replaces both by one that is called after each step. */
    public void setAfter(StepListener listener) {
        set((w, dt) -> {}, listener);
    }

    /** Removes both. */
    public void clear() {
        world.removeStepListener(before);
        world.removeStepListener(after);
    }
}
