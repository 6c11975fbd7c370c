package yarts.physics;

/**
 * The rule by which {@code World.advance} turns the seconds of a frame into steps. Immutable.
 *
 * <pre>{@code
 * Timestep.fixed(60)                   // always 1/60 s: the same steps on every machine
 * Timestep.variable(1 / 30.0)          // as long as the frame, but never longer than 1/30 s
 * Timestep.fixed(60).withMaxSteps(4)   // after a long frame, run at most 4 steps and drop the rest of the time
 * }</pre>
 */
public final class Timestep {
    private static final int MAX_RATE = 1_000_000;

    /** Steps per second, or 0 if variable. */
    final int rate;
    /** The longest step; in seconds. */
    final double maxStep;
    /** The greatest number of steps of one advance. */
    final int maxSteps;

    private Timestep(int rate, double maxStep, int maxSteps) {
        this.rate = rate;
        this.maxStep = maxStep;
        this.maxSteps = maxSteps;
    }

    /**
     * Creates a timestep with steps of equal length. Time that does not fill a step waits for the next frame, and so does
     * the impulse of forces during that time. Time is counted in integers, so that no step is lost however long the game
     * runs: whole nanoseconds are exact; other times are rounded to 1e-9 of a step, and the error is carried over to the
     * next frame. So n frames of 1.0/n seconds are exactly one second.
     *
     * @param stepsPerSecond the rate, from 1 to 1,000,000
     * @return a timestep that runs at most the steps of a quarter of a second at a time
     * @throws IllegalArgumentException if stepsPerSecond is out of range
     */
    public static Timestep fixed(int stepsPerSecond) {
        if (stepsPerSecond < 1 || stepsPerSecond > MAX_RATE) {
            throw Check.refused("stepsPerSecond", "from 1 to " + MAX_RATE, stepsPerSecond);
        }
        return new Timestep(stepsPerSecond, 1.0 / stepsPerSecond, Math.max(1, stepsPerSecond / 4));
    }

    /**
     * Creates a timestep with steps as long as the frame. A frame longer than maxStep is divided into equal steps that are
     * not longer.
     *
     * @param maxStep the longest step, in seconds, from 1e-6 to 1e9
     * @return a timestep that runs at most a quarter of a second at a time, or one step if maxStep is longer
     * @throws IllegalArgumentException if maxStep is NaN or out of range
     */
    public static Timestep variable(double maxStep) {
        if (!(maxStep >= 1.0 / MAX_RATE && maxStep <= Check.MAX_TIME)) {
            throw Check.refused("maxStep", "from 1.0E-6 to 1.0E9 s", maxStep);
        }
        return new Timestep(0, maxStep, Math.max(1, (int) (0.25 / maxStep)));
    }

    /**
     * Returns a copy with another limit on the steps of one {@code World.advance}. Time beyond the limit is dropped, with
     * its share of the forces' impulse, and is counted by {@link World#getDroppedTime()}: a game that cannot keep up slows
     * down instead of falling behind further with every frame.
     *
     * @param n the greatest number of steps, at least 1
     * @return a timestep with that limit
     * @throws IllegalArgumentException if n is less than 1
     */
    public Timestep withMaxSteps(int n) {
        if (n < 1) throw Check.refused("maxSteps", ">= 1", n);
        return new Timestep(rate, maxStep, n);
    }

    /** {@return whether steps are of equal length: {@link #fixed}, not {@link #variable}} */
    public boolean isFixed() {
        return rate > 0;
    }

    /** {@return the rate of fixed steps, in steps per second; 0 if steps are variable} */
    public int getStepsPerSecond() {
        return rate;
    }

    /** {@return the length of the longest step, in seconds: exactly 1/rate if steps are fixed} */
    public double getMaxStep() {
        return maxStep;
    }

    /** {@return the greatest number of steps of one {@code World.advance}} */
    public int getMaxSteps() {
        return maxSteps;
    }

    /**
     * Compares all properties of two timesteps.
     *
     * @param other a timestep, or any other object
     * @return whether the other is a timestep with the same properties
     */
    @Override
    public boolean equals(Object other) {
        return other instanceof Timestep that
                && rate == that.rate
                && maxStep == that.maxStep
                && maxSteps == that.maxSteps;
    }

    /** {@return a hash code of all properties} */
    @Override
    public int hashCode() {
        return 31 * (31 * rate + Double.hashCode(maxStep)) + maxSteps;
    }

    /** {@return a description for logs: the code that creates an equal timestep} */
    @Override
    public String toString() {
        String steps = isFixed() ? "fixed(" + rate + ")" : "variable(" + maxStep + ")";
        return "Timestep." + steps + ".withMaxSteps(" + maxSteps + ")";
    }
}
