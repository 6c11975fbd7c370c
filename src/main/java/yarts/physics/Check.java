package yarts.physics;

/** Argument checks and their messages. NaN fails every check, because each comparison with it is false. */
final strictfp class Check {
    /** The longest dt and elapsed; in seconds (32 years). */
    static final double MAX_TIME = 1e9;

    /** The smallest mass; in kg. */
    static final double MIN_MASS = 1e-50;

    /**
     * The largest friction, mass, and component of a force or impulse; in SI units. With these limits, the square of
     * the velocity does not overflow, even after 2^63 calls of applyForce and a step of MAX_TIME.
     */
    static final double MAX = 1e50;

    /** Volatile, so that no compiler evaluates the check in a thread of its own. */
    private static volatile double smallestNormal = Double.MIN_NORMAL, smallest = Double.MIN_VALUE;

    private Check() {}

    static double time(String name, double t) {
        if (!(t >= 0 && t <= MAX_TIME)) throw invalid(name, "finite, >= 0 and <= 1.0E9 s", t);
        return t + 0.0; // -0.0 is 0.0
    }

    static double mass(double mass) {
        if (!(mass >= MIN_MASS && mass <= MAX)) {
            throw invalid("mass", "finite and > 0 (not zero; from 1.0E-50 to 1.0E50 kg)", mass);
        }
        return mass;
    }

    static double friction(double friction) {
        if (!(friction >= 0 && friction <= MAX)) {
            throw invalid("friction", "finite, >= 0 and <= 1.0E50 N·s/m", friction);
        }
        return friction + 0.0;
    }

    static double maxSpeed(double maxSpeed) {
        if (!(maxSpeed >= 0)) throw invalid("maxSpeed", ">= 0 m/s (infinite: no cap)", maxSpeed);
        return maxSpeed + 0.0;
    }

    static double motorForce(String name, double force) {
        if (!(force >= 0 && force <= MAX)) throw invalid(name, "finite, >= 0 and <= 1.0E50 N", force);
        return force + 0.0;
    }

    static double finite(String name, double value) {
        if (!(Math.abs(value) <= Double.MAX_VALUE)) throw invalid(name, "finite", value);
        return value + 0.0;
    }

    static long count(String name, long n, long most) {
        if (n < 0 || n > most) throw invalid(name, "from 0 to " + most, n);
        return n;
    }

    /** A component of a force or of an impulse. */
    static void push(String name, double value) {
        if (!isPush(value)) throw invalid(name, "finite and at most 1.0E50 in magnitude", value);
    }

    static boolean isPush(double value) {
        return Math.abs(value) <= MAX;
    }

    static double part(String name, double alpha) {
        if (!(alpha >= 0 && alpha <= 1)) throw invalid(name, "from 0 to 1", alpha);
        return alpha;
    }

    /** Throws if native code has set a floating-point mode for this thread that differs from Java's. */
    static void arithmetic() {
        boolean results = Double.doubleToRawLongBits(smallestNormal / 2) == 0;
        boolean operands = Double.doubleToRawLongBits(smallest * 0x1p100) == 0;
        if (results || operands) {
            throw new IllegalStateException("this thread flushes subnormal numbers to 0, as "
                    + (results ? operands ? "results and operands" : "results" : "operands")
                    + ": native code has set its floating-point mode (FTZ, DAZ)");
        }
    }

    static <T> T notNull(String name, T value) {
        if (value == null) throw new NullPointerException(name + " must not be null");
        return value;
    }

    static IllegalArgumentException invalid(String name, String rule, Object value) {
        return new IllegalArgumentException(name + " must be " + rule + ", was " + value);
    }
}
