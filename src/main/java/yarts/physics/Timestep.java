package yarts.physics;

/**
 * How {@code World.advance} turns the seconds of a frame into steps. Immutable.
 *
 * <pre>{@code
 * Timestep.fixed(60)                   // always 1/60 s: the same steps on every machine
 * Timestep.variable(1 / 30.0)          // as long as the frame, but never longer than 1/30 s
 * Timestep.fixed(60).withMaxSteps(4)   // after a hitch, catch up by at most 4 steps and drop the rest
 * }</pre>
 */
public final class Timestep {
    private static final int MAX_RATE = 1_000_000;

    /** Steps a second, or 0 if variable. */
    final int rate;
    /** The longest step; in seconds. */
    final double maxStep;
    /** The most steps of one advance. */
    final int maxSteps;

    private Timestep(int rate, double maxStep, int maxSteps) {
        this.rate = rate;
        this.maxStep = maxStep;
        this.maxSteps = maxSteps;
    }

    /**
     * Steps of equal length. A frame's time that does not fill a step waits for the next frame, and the forces' impulse
     * with it. Time is counted in integers, so that no step is lost however long the game runs: whole nanoseconds are
     * exact, and other times are rounded to 1e-9 of a step, with the error carried on. So n frames of 1.0/n seconds are
     * one second.
     *
     * @param stepsPerSecond the rate, from 1 to 1,000,000
     * @return a policy that catches up by at most a quarter of a second at a time
     * @throws IllegalArgumentException if stepsPerSecond is out of range
     */
    public static Timestep fixed(int stepsPerSecond) {
        if (stepsPerSecond < 1 || stepsPerSecond > MAX_RATE) {
            throw Check.refused("stepsPerSecond", "from 1 to " + MAX_RATE, stepsPerSecond);
        }
        return new Timestep(stepsPerSecond, 1.0 / stepsPerSecond, Math.max(1, stepsPerSecond / 4));
    }

    /**
     * Steps as long as the frame; a frame longer than maxStep is cut into equal steps that are not.
     *
     * @param maxStep the longest step, in seconds, from 1e-6 to 1e9
     * @return a policy that catches up by at most a quarter of a second at a time, or by one step if maxStep is longer
     * @throws IllegalArgumentException if maxStep is NaN or out of range
     */
    public static Timestep variable(double maxStep) {
        if (!(maxStep >= 1.0 / MAX_RATE && maxStep <= Check.MAX_TIME)) {
            throw Check.refused("maxStep", "from 1.0E-6 to 1.0E9 s", maxStep);
        }
        return new Timestep(0, maxStep, Math.max(1, (int) (0.25 / maxStep)));
    }

    /**
     * Limits how many steps one {@code World.advance} may run. The time beyond is dropped, with the forces' share of it,
     * and counted in {@link World#getDroppedTime()}: a game that cannot keep up slows down rather than fall behind further with every frame.
     *
     * @param n the most steps, at least 1
     * @return a policy like this one with that limit
     * @throws IllegalArgumentException if n is less than 1
     */
    public Timestep withMaxSteps(int n) {
        if (n < 1) throw Check.refused("maxSteps", ">= 1", n);
        return new Timestep(rate, maxStep, n);
    }

    boolean isFixed() {
        return rate > 0;
    }

    /** Says what the policy is, for logs. */
    @Override
    public String toString() {
        String steps = isFixed() ? "fixed(" + rate + ")" : "variable(" + maxStep + ")";
        return "Timestep." + steps + ".withMaxSteps(" + maxSteps + ")";
    }
}
