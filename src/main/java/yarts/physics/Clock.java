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

    private static final long MAX_TICKS = Long.MAX_VALUE / 4;
    private static final double MAX_SUM = 1e100; // s

    /** The names of {@link #state}. */
    static final String[] STATE = {
        "tick", "regularTicks", "remainder", "droppedTicks", "time", "timeError", "droppedTime", "droppedTimeError"
    };

    /** From here on in {@link #state} the longs are the bits of doubles. */
    static final int DOUBLES = 4;

    private Timestep timestep;
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
        if (timestep.isFixed()) droppedSteps = Math.min(droppedSteps + steps, MAX_TICKS);
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

    Timestep timestep() {
        return timestep;
    }

    void setTimestep(Timestep timestep) {
        this.timestep = timestep;
    }

    void set(Clock other) {
        timestep = other.timestep;
        tick = other.tick;
        regular = other.regular;
        remainder = other.remainder;
        droppedSteps = other.droppedSteps;
        irregular.set(other.irregular.sum, other.irregular.error);
        dropped.set(other.dropped.sum, other.dropped.error);
    }

    /** {@return the whole state but for the timestep} */
    long[] state() {
        return new long[] {
            tick,
            regular,
            remainder,
            droppedSteps,
            Double.doubleToRawLongBits(irregular.sum),
            Double.doubleToRawLongBits(irregular.error),
            Double.doubleToRawLongBits(dropped.sum),
            Double.doubleToRawLongBits(dropped.error)
        };
    }

    /**
     * The reverse of {@link #state}.
     *
     * @throws IllegalArgumentException if no clock can have come to this; it is to be thrown away then
     */
    void setState(long[] state) {
        tick = Check.count(STATE[0], state[0], MAX_TICKS);
        regular = Check.count(STATE[1], state[1], tick);
        remainder = Check.count(STATE[2], state[2], timestep.isFixed() ? SECOND - 1 : 0);
        droppedSteps = Check.count(STATE[3], state[3], MAX_TICKS);
        irregular.set(sum(4, state), sum(5, state));
        dropped.set(sum(6, state), sum(7, state));
    }

    private static double sum(int i, long[] state) {
        double sum = Check.finite(STATE[i], Double.longBitsToDouble(state[i]));
        if (!(Math.abs(sum) <= MAX_SUM && (i % 2 == 1 || sum >= 0))) {
            throw Check.refused(
                    STATE[i], (i % 2 == 1 ? "" : ">= 0 and ") + "at most " + MAX_SUM + " in magnitude", sum);
        }
        return sum;
    }

    /** A hash of all this that goes on from h. */
    long hash(long h) {
        h = mix(mix(mix(h, timestep.rate), Double.doubleToRawLongBits(timestep.maxStep)), timestep.maxSteps);
        h = mix(mix(mix(mix(h, tick), regular), remainder), droppedSteps);
        return dropped.hash(irregular.hash(h));
    }

    /** One step of a hash. For every h it is one-to-one in v, and for every v in h. */
    static long mix(long h, long v) {
        h = (h ^ v) * 0xD6E8FEB86659FD93L; // any odd number of many mixed bits
        return h ^ (h >>> 32);
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

        void set(double sum, double error) {
            this.sum = sum;
            this.error = error;
        }

        long hash(long h) {
            return mix(mix(h, Double.doubleToRawLongBits(sum)), Double.doubleToRawLongBits(error + 0.0));
        }
    }
}
