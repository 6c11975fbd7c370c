package yarts.physics;

/**
 * Where a world stands in time.
 *
 * <p>Fixed steps are counted, never summed: elapsed time is rounded to whole nanoseconds, and (nanoseconds · rate) /
 * 1e9 is done in integers. Time that is not a whole number of fixed steps is summed with the rounding error carried
 * along.
 */
final class Clock {
    private static final long SECOND = 1_000_000_000; // ns
    /** The largest float below 1: a renderer that narrows alpha to float still gets less than 1. */
    private static final double MAX_ALPHA = 0x1.fffffep-1;

    private final Timestep timestep;
    private long tick;
    /** Of the ticks, those of exactly 1/rate seconds. */
    private long regular;
    /** Elapsed time that no step has covered yet; in 1/rate nanoseconds, less than SECOND: a part of a step. */
    private long remainder;

    private long droppedSteps;
    private final Sum irregular = new Sum();
    private final Sum dropped = new Sum();

    Clock(Timestep timestep) {
        this.timestep = timestep;
    }

    /** Takes in elapsed time, rounded to nanoseconds; returns the whole fixed steps due, and keeps the remainder. */
    long stepsDue(double elapsed) {
        long ns = (long) (elapsed * SECOND + 0.5);
        long part = ns % SECOND * timestep.rate + remainder; // below 1e15 + 1e9
        remainder = part % SECOND;
        return ns / SECOND * timestep.rate + part / SECOND;
    }

    void ran(double dt) {
        tick++;
        if (timestep.isFixed() && dt == timestep.maxStep) regular++;
        else irregular.add(dt);
    }

    void drop(long steps, double dt) {
        if (timestep.isFixed()) droppedSteps += steps;
        else drop(steps * dt);
    }

    void drop(double seconds) {
        dropped.add(seconds);
    }

    /** In units of {@link #seconds}. */
    long remainder() {
        return remainder;
    }

    /** Of a fixed clock's time, such as its remainder or a difference of two. */
    double seconds(long time) {
        return time / ((double) SECOND * timestep.rate);
    }

    double alpha() {
        return Math.min(remainder / (double) SECOND, MAX_ALPHA);
    }

    long tick() {
        return tick;
    }

    double time() {
        return timestep.isFixed() ? (double) regular / timestep.rate + irregular.value() : irregular.value();
    }

    double droppedTime() {
        return timestep.isFixed() ? (double) droppedSteps / timestep.rate : dropped.value();
    }

    /** A running sum that carries its rounding error (Neumaier, 1974). */
    private static final class Sum {
        private double sum, error;

        void add(double t) {
            double s = sum + t;
            error += sum >= t ? sum - s + t : t - s + sum;
            sum = s;
        }

        double value() {
            return sum + error;
        }
    }
}
