package yarts.physics;

import java.util.Objects;

/**
 * The rule by which {@code World.advance} divides the time of a frame into steps, such as 60 equal steps per second.
 *
 * <pre>{@code
 * Timestep.fixed(60)                   // always 1/60 s: the same steps on every machine
 * Timestep.variable(1 / 30.0)          // as long as the frame, but never longer than 1/30 s
 * Timestep.fixed(60).withMaxSteps(4)   // after a long frame, run at most 4 steps and drop the rest of the time
 * }</pre>
 *
 * <p>Immutable and thread-safe.
 */
public final strictfp class Timestep {
    private static final int MAX_RATE = 1_000_000;

    /** Steps per second, or 0 if variable. */
    final int rate;
    /** The longest step; in seconds. */
    final double maxStep;
    /** The maximum number of steps of one advance. */
    final int maxSteps;

    private Timestep(int rate, double maxStep, int maxSteps) {
        this.rate = rate;
        this.maxStep = maxStep;
        this.maxSteps = maxSteps;
    }

    /**
     * Creates a timestep with steps of equal length, 1/rate seconds. Time that does not fill a step waits for the next
     * frame, and so does the impulse of forces during that time.
     *
     * <p>Time is counted in integers, so that no step is lost, no matter how long the game runs. Whole nanoseconds are
     * exact. Other times are rounded to 1e-9 of a step, and the rounding error is carried over to the next frame. So n
     * frames of 1.0/n seconds are exactly one second.
     *
     * @param stepsPerSecond the rate, from 1 to 1,000,000 steps per second
     * @return a timestep with at most rate/4 steps per frame, rounded up: a frame of up to 0.25 s drops no time
     * @throws IllegalArgumentException if stepsPerSecond is out of range
     */
    public static Timestep fixed(int stepsPerSecond) {
        if (stepsPerSecond < 1 || stepsPerSecond > MAX_RATE) {
            throw Check.invalid("stepsPerSecond", "from 1 to " + MAX_RATE, stepsPerSecond);
        }
        return new Timestep(stepsPerSecond, 1.0 / stepsPerSecond, (stepsPerSecond + 3) / 4);
    }

    /**
     * Creates a timestep with one step for each frame, as long as the frame. A frame longer than maxStep is divided
     * into equal steps that do not exceed it.
     *
     * @param maxStep the longest step, in seconds, from 1e-6 to 1e9
     * @return a timestep with at most 0.25/maxStep steps per frame, rounded up: a frame of up to 0.25 s drops no time
     * @throws IllegalArgumentException if maxStep is NaN or out of range
     */
    public static Timestep variable(double maxStep) {
        if (!(maxStep >= 1.0 / MAX_RATE && maxStep <= Check.MAX_TIME)) {
            throw Check.invalid("maxStep", "from 1.0E-6 to 1.0E9 s", maxStep);
        }
        int steps = (int) (0.25 / maxStep);
        if (steps * maxStep < 0.25) steps++;
        return new Timestep(0, maxStep, steps);
    }

    /**
     * Returns a copy with another limit on the number of steps of one {@code World.advance}. Time beyond the limit is
     * dropped, together with its share of the forces' impulse; {@link World#getDroppedTime()} counts it. So a game on a
     * slow machine slows down, and does not fall further behind with every frame.
     *
     * @param n the maximum number of steps, at least 1
     * @return a timestep with this limit
     * @throws IllegalArgumentException if n is less than 1
     */
    public Timestep withMaxSteps(int n) {
        if (n < 1) throw Check.invalid("maxSteps", ">= 1", n);
        return new Timestep(rate, maxStep, n);
    }

    /** {@return whether all steps have the same length: true for {@link #fixed}, false for {@link #variable}} */
    public boolean isFixed() {
        return rate > 0;
    }

    /** {@return the number of fixed steps per second; 0 if steps are variable} */
    public int getStepsPerSecond() {
        return rate;
    }

    /** {@return the length of the longest step, in seconds; if steps are fixed, the length of every step, 1/rate} */
    public double getMaxStep() {
        return maxStep;
    }

    /** {@return the maximum number of steps of one {@code World.advance}} */
    public int getMaxSteps() {
        return maxSteps;
    }

    /**
     * Compares all properties of two timesteps.
     *
     * @param other a timestep, or any other object
     * @return whether the other object is a timestep with the same properties
     */
    @Override
    public boolean equals(Object other) {
        if (!(other instanceof Timestep)) return false;
        Timestep that = (Timestep) other;
        return rate == that.rate && maxStep == that.maxStep && maxSteps == that.maxSteps;
    }

    /** {@return a hash code of all properties} */
    @Override
    public int hashCode() {
        return Objects.hash(rate, maxStep, maxSteps);
    }

    /** {@return the code that creates an equal timestep, such as {@code Timestep.fixed(60).withMaxSteps(15)}} */
    @Override
    public String toString() {
        String steps = isFixed() ? "fixed(" + rate + ")" : "variable(" + maxStep + ")";
        return "Timestep." + steps + ".withMaxSteps(" + maxSteps + ")";
    }
}
