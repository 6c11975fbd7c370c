package yarts.physics;

/**
 * The time of a world.
 *
 * <p>Fixed steps are counted, never summed. The elapsed time that waits for a step is counted in parts of a step; a
 * step has {@link #STEP} parts. Whole nanoseconds are a whole number of parts, because the rate is an integer. Other
 * times are rounded to a part, and the rounding error is carried over. Time that is not a whole number of fixed steps
 * is summed, and so is the rounding error of this sum.
 *
 * <p>With variable steps, time waits only after a change from fixed steps. It is counted as if the rate were 1.
 */
final strictfp class Clock {
    /** The number of parts of a step. */
    private static final long STEP = 1_000_000_000;

    /** The largest float below 1, so that alpha is below 1 even in a renderer that converts it to float. */
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

    /** The index in {@link #state} from which the longs are the bits of doubles. */
    static final int DOUBLES = 4;

    private Timestep timestep;
    private long tick;
    /** The number of steps of exactly 1/rate seconds. */
    private long regular;
    /**
     * The elapsed time that no step has covered yet; in parts of a step. It is less than a second. Only a change of the
     * timestep can make it STEP or more.
     */
    private long remainder;

    private long droppedSteps;
    /** The rounding error of the remainder; in parts of a step, at most one. */
    private double remainderError;

    private final Sum irregular = new Sum();
    private final Sum dropped = new Sum();

    Clock(Timestep timestep) {
        this.timestep = timestep;
    }

    /** Adds elapsed time, returns the number of fixed steps that are due, and keeps the remainder. */
    long stepsDue(double elapsed) {
        long seconds = (long) elapsed;
        remainder += parts(elapsed, seconds); // below 2e15 + 1e9
        long due = remainder / STEP;
        remainder %= STEP;
        return seconds * timestep.rate + due;
    }

    /** The number of parts in a time, without its whole seconds. */
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

    /** The waiting time, in parts; see {@link #seconds}. */
    long remainder() {
        return remainder;
    }

    /** The parts of a remainder that a number of steps does not cover. Steps of a second cover every remainder. */
    long old(long before, long steps) {
        return steps < timestep.rate ? Math.max(0, before - steps * STEP) : 0;
    }

    /** Converts parts to seconds. */
    double seconds(long parts) {
        return parts / ((double) STEP * rate(timestep));
    }

    /**
     * Returns the waiting time in seconds, and sets it to 0, for a variable step. Less than a part continues to wait: it
     * can be negative, because a fixed step may have begun less than a part too early.
     */
    double takeRemainder() {
        double parts = remainder + remainderError;
        if (parts < 1) return 0;
        remainder = 0;
        remainderError = 0;
        return parts / STEP;
    }

    double alpha() {
        return timestep.isFixed() ? Math.min(remainder / (double) STEP, MAX_ALPHA) : 0;
    }

    long tick() {
        return tick;
    }

    double time() {
        return irregular.value() + inSeconds(regular); // Kernel explains the order of operands
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

    /** The rate for the parts of the remainder. */
    private static int rate(Timestep timestep) {
        return timestep.isFixed() ? timestep.rate : 1;
    }

    /** Changes the timestep. The waiting time in seconds stays the same. */
    void setTimestep(Timestep next) {
        if (next.rate != timestep.rate) {
            irregular.add(inSeconds(regular));
            dropped.add(inSeconds(droppedSteps));
            regular = droppedSteps = 0;
            convertRemainder(rate(timestep), rate(next));
        }
        timestep = next;
    }

    /** remainder := remainder · to / from, without overflow, rounded to a part. The rounding error is carried over. */
    private void convertRemainder(long from, long to) {
        long product = remainder % from * to;
        long whole = remainder / from * to + product / from;
        double fraction = remainderError * to / from + (double) (product % from) / from;
        long rounded = whole + (long) (fraction < 0 ? fraction - 0.5 : fraction + 0.5);
        remainder = Math.max(0, Math.min(rounded, STEP * to - 1));
        remainderError = Math.max(-1, Math.min(fraction - (remainder - whole), 1));
    }

    void copy(Clock other) {
        timestep = other.timestep;
        tick = other.tick;
        regular = other.regular;
        remainder = other.remainder;
        droppedSteps = other.droppedSteps;
        remainderError = other.remainderError;
        irregular.set(other.irregular.sum, other.irregular.error);
        dropped.set(other.dropped.sum, other.dropped.error);
    }

    /** {@return the state without the timestep, as {@link #STATE} names it} */
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
     * Sets the state, as {@link #state} returns it.
     *
     * @throws IllegalArgumentException if no clock can have this state; this clock must then not be used any more
     */
    void setState(Timestep timestep, long[] state) {
        this.timestep = timestep;
        tick = Check.count(STATE[0], state[0], MAX_TICKS);
        regular = Check.count(STATE[1], state[1], tick);
        remainder = Check.count(STATE[2], state[2], STEP * rate(timestep) - 1); // less than a second
        droppedSteps = Check.count(STATE[3], state[3], MAX_TICKS);
        remainderError = error(4, state, 1);
        irregular.set(sum(5, state), error(6, state, MAX_SUM));
        dropped.set(sum(7, state), error(8, state, MAX_SUM));
    }

    private static double sum(int i, long[] state) {
        double sum = Double.longBitsToDouble(state[i]) + 0.0;
        if (!(sum >= 0 && sum <= MAX_SUM)) throw Check.invalid(STATE[i], ">= 0 and at most " + MAX_SUM, sum);
        return sum;
    }

    private static double error(int i, long[] state, double most) {
        double error = Double.longBitsToDouble(state[i]) + 0.0;
        if (!(Math.abs(error) <= most)) throw Check.invalid(STATE[i], "at most " + most + " in magnitude", error);
        return error;
    }

    /** A hash of the timestep and the state, from an initial value h. */
    long hash(long h) {
        h = mix(mix(mix(h, timestep.rate), Double.doubleToRawLongBits(timestep.maxStep)), timestep.maxSteps);
        h = mix(mix(mix(mix(h, tick), regular), remainder), droppedSteps);
        return dropped.hash(irregular.hash(mix(h, Double.doubleToRawLongBits(remainderError))));
    }

    /** One round of a hash. It is one-to-one in v for every h, and in h for every v. */
    static long mix(long h, long v) {
        h = (h ^ v) * 0xD6E8FEB86659FD93L; // an odd number with many mixed bits
        return h ^ (h >>> 32);
    }

    /** A running sum with its rounding error (Neumaier, 1974). */
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
