package yarts.physics;

/**
 * Where a world stands in time.
 *
 * <p>Fixed steps are counted, never summed: time is counted in {@link #STEP} parts of a step. Whole nanoseconds times the
 * rate are a whole number of these. Other times are rounded to one, and the error is carried on to the next. Time that is
 * not a whole number of fixed steps is summed with the rounding error carried along.
 */
final class Clock {
    /** Parts of a step; and since the rate is an integer, of a nanosecond, too. */
    private static final long STEP = 1_000_000_000;

    /** The largest float below 1: a renderer that narrows alpha to float still gets less than 1. */
    private static final double MAX_ALPHA = 0x1.fffffep-1;

    private static final long MAX_TICKS = Long.MAX_VALUE / 4;
    private static final double MAX_SUM = 1e100; // s

    /** The names of {@link #state}. */
    static final String[] STATE = {
        "tick",
        "regularTicks",
        "remainder",
        "droppedTicks",
        "remainderError",
        "time",
        "timeError",
        "droppedTime",
        "droppedTimeError"
    };

    /** From here on in {@link #state} the longs are the bits of doubles. */
    static final int DOUBLES = 4;

    private Timestep timestep;
    private long tick;
    /** Of the ticks, those of exactly 1/rate seconds. */
    private long regular;
    /** Elapsed time that no step has covered yet; in parts of a step, less than STEP. */
    private long remainder;

    private long droppedSteps;
    /** What rounding left out of the remainder; in parts of a step, at most a half. */
    private double remainderError;

    private final Sum irregular = new Sum();
    private final Sum dropped = new Sum();

    Clock(Timestep timestep) {
        this.timestep = timestep;
    }

    /** Takes in elapsed time; returns the whole fixed steps due, and keeps the remainder. */
    long stepsDue(double elapsed) {
        long seconds = (long) elapsed;
        remainder += parts(elapsed, seconds); // below 1e15 + 1e9
        long due = remainder / STEP;
        remainder %= STEP;
        return seconds * timestep.rate + due;
    }

    /** Of a time without its whole seconds. */
    private long parts(double elapsed, long seconds) {
        long ns = (long) ((elapsed - seconds) * 1e9 + 0.5);
        if ((seconds * STEP + ns) / 1e9 == elapsed) return ns * timestep.rate;
        double exact = 1e9 * timestep.rate * (elapsed - seconds) + remainderError;
        long rounded = (long) (exact + 0.5);
        remainderError = exact - rounded;
        return rounded;
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
        return time / ((double) STEP * timestep.rate);
    }

    double alpha() {
        return Math.min(remainder / (double) STEP, MAX_ALPHA);
    }

    long tick() {
        return tick;
    }

    double time() {
        return irregular.value() + inSeconds(regular); // in the order that Kernel asks for
    }

    double droppedTime() {
        return dropped.value() + inSeconds(droppedSteps);
    }

    private double inSeconds(long steps) {
        return timestep.isFixed() ? (double) steps / timestep.rate : 0;
    }

    Timestep timestep() {
        return timestep;
    }

    /** Goes on in other steps. The remainder stays the same part of a step; without fixed steps there is none. */
    void setTimestep(Timestep next) {
        if (next.rate != timestep.rate) {
            irregular.add(inSeconds(regular));
            dropped.add(inSeconds(droppedSteps));
            regular = droppedSteps = 0;
        }
        if (!next.isFixed()) {
            if (timestep.isFixed()) drop(seconds(remainder));
            remainder = 0;
            remainderError = 0;
        }
        timestep = next;
    }

    void set(Clock other) {
        timestep = other.timestep;
        tick = other.tick;
        regular = other.regular;
        remainder = other.remainder;
        droppedSteps = other.droppedSteps;
        remainderError = other.remainderError;
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
            Double.doubleToRawLongBits(remainderError),
            Double.doubleToRawLongBits(irregular.sum),
            Double.doubleToRawLongBits(irregular.error),
            Double.doubleToRawLongBits(dropped.sum),
            Double.doubleToRawLongBits(dropped.error)
        };
    }

    /**
     * The reverse of {@link #state}.
     *
     * @param timestep the timestep
     * @throws IllegalArgumentException if no clock can have come to this; it is to be thrown away then
     */
    void setState(Timestep timestep, long[] state) {
        this.timestep = timestep;
        tick = Check.count(STATE[0], state[0], MAX_TICKS);
        regular = Check.count(STATE[1], state[1], tick);
        remainder = Check.count(STATE[2], state[2], timestep.isFixed() ? STEP - 1 : 0);
        droppedSteps = Check.count(STATE[3], state[3], MAX_TICKS);
        remainderError = error(4, state, timestep.isFixed() ? 1 : 0);
        irregular.set(sum(5, state), error(6, state, MAX_SUM));
        dropped.set(sum(7, state), error(8, state, MAX_SUM));
    }

    private static double sum(int i, long[] state) {
        double sum = Double.longBitsToDouble(state[i]) + 0.0;
        if (!(sum >= 0 && sum <= MAX_SUM)) throw Check.refused(STATE[i], ">= 0 and at most " + MAX_SUM, sum);
        return sum;
    }

    private static double error(int i, long[] state, double most) {
        double error = Double.longBitsToDouble(state[i]) + 0.0;
        if (!(Math.abs(error) <= most)) throw Check.refused(STATE[i], "at most " + most + " in magnitude", error);
        return error;
    }

    /** A hash of all this that goes on from h. */
    long hash(long h) {
        h = mix(mix(mix(h, timestep.rate), Double.doubleToRawLongBits(timestep.maxStep)), timestep.maxSteps);
        h = mix(mix(mix(mix(h, tick), regular), remainder), droppedSteps);
        return dropped.hash(irregular.hash(mix(h, Double.doubleToRawLongBits(remainderError))));
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
            return mix(mix(h, Double.doubleToRawLongBits(sum)), Double.doubleToRawLongBits(error));
        }
    }
}
