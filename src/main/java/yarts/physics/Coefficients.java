package yarts.physics;

/** The coefficients of a step: decay(z), gain(z) dt/m and lag = 1 − weight(z), as in {@link Integrator}. */
final class Coefficients {
    /** Below this z, series are as good as exp. They can be vectorised. */
    private static final double SMALL = 0.5;

    private Coefficients() {}

    /** Works out those of some rows. */
    static void of(Columns c, int from, int to, double dt, Integrator how) {
        if (to - from < Kernel.FEW) {
            for (int i = from; i < to; i++) ofRow(c, i, dt, how);
            return;
        }
        double[] mass = c.mass, friction = c.friction, decay = c.decay, gain = c.gain, lag = c.lag;
        switch (how) {
            case EULER:
                for (int i = from; i < to; i++) euler(mass, friction, decay, gain, i, dt);
                break;
            case MIDPOINT:
                for (int i = from; i < to; i++) midpoint(mass, friction, decay, gain, i, dt);
                break;
            case EXACT:
                for (int i = from; i < to; i++) stiffness(mass, friction, gain, lag, i, dt);
                if (allSmall(lag, from, to)) {
                    for (int i = from; i < to; i++) small(decay, gain, lag, i);
                    for (int i = from; i < to; i++) lag[i] = lag(lag[i]);
                } else {
                    for (int i = from; i < to; i++) exact(decay, gain, lag, i);
                }
                break;
        }
    }

    private static void ofRow(Columns c, int i, double dt, Integrator how) {
        switch (how) {
            case EULER:
                euler(c.mass, c.friction, c.decay, c.gain, i, dt);
                break;
            case MIDPOINT:
                midpoint(c.mass, c.friction, c.decay, c.gain, i, dt);
                break;
            case EXACT:
                stiffness(c.mass, c.friction, c.gain, c.lag, i, dt);
                exact(c.decay, c.gain, c.lag, i);
                break;
        }
    }

    private static void euler(double[] mass, double[] friction, double[] decay, double[] gain, int i, double dt) {
        double h = dt / mass[i], z = friction[i] * h;
        decay[i] = Math.max(0, 1 - z);
        gain[i] = h / Math.max(1, z);
    }

    private static void midpoint(double[] mass, double[] friction, double[] decay, double[] gain, int i, double dt) {
        double h = dt / mass[i], half = friction[i] * h / 2;
        decay[i] = Math.max(0, (1 - half) / (1 + half));
        gain[i] = h / Math.max(1 + half, 2 * half);
    }

    /** The first part of EXACT: dt/m, and z in place of lag. */
    private static void stiffness(double[] mass, double[] friction, double[] gain, double[] z, int i, double dt) {
        gain[i] = dt / mass[i];
        z[i] = friction[i] * gain[i];
    }

    private static boolean allSmall(double[] z, int from, int to) {
        for (int i = from; i < to; i++) if (z[i] >= SMALL) return false;
        return true;
    }

    private static void small(double[] decay, double[] gain, double[] z, int i) {
        double g = gain(z[i]);
        decay[i] = 1 - z[i] * g;
        gain[i] *= g;
    }

    /** The second part of EXACT: by the same arithmetic as of small rows, or for larger z by exp. */
    private static void exact(double[] decay, double[] gain, double[] lag, int i) {
        double z = lag[i];
        if (z < SMALL) {
            small(decay, gain, lag, i);
            lag[i] = lag(z);
        } else {
            double left = StrictMath.exp(-z), gone = 1 - left;
            decay[i] = left;
            gain[i] *= gone / z;
            lag[i] = z < 1 ? lag(z) : 1 / z - left / gone;
        }
    }

    /** (1 − e^−z)/z = Σ (−z)^k / (k + 1)!; below SMALL, the terms left out come to less than 2e-18. */
    private static double gain(double z) {
        double sum = 1 / 1307674368000.0;
        sum = 1 / 87178291200.0 - z * sum;
        sum = 1 / 6227020800.0 - z * sum;
        sum = 1 / 479001600.0 - z * sum;
        sum = 1 / 39916800.0 - z * sum;
        sum = 1 / 3628800.0 - z * sum;
        sum = 1 / 362880.0 - z * sum;
        sum = 1 / 40320.0 - z * sum;
        sum = 1 / 5040.0 - z * sum;
        sum = 1 / 720.0 - z * sum;
        sum = 1 / 120.0 - z * sum;
        sum = 1 / 24.0 - z * sum;
        sum = 1 / 6.0 - z * sum;
        sum = 1 / 2.0 - z * sum;
        return 1 - z * sum;
    }

    /**
     * 1 − weight(z) = 1/z − 1/(e^z − 1): 1/2 at 0, and close to 1/z for large z. Below 1, where the difference would
     * cancel, its series 1/2 − Σ B(2k) z^(2k−1) / (2k)!, with the Bernoulli numbers B; the terms left out come to less
     * than 6e-18.
     */
    private static double lag(double z) {
        double s = z * z;
        double sum = -174611 / 802857662698291200000.0;
        sum = sum * s + 43867 / 5109094217170944000.0;
        sum = sum * s - 3617 / 10670622842880000.0;
        sum = sum * s + 1 / 74724249600.0;
        sum = sum * s - 691 / 1307674368000.0;
        sum = sum * s + 1 / 47900160.0;
        sum = sum * s - 1 / 1209600.0;
        sum = sum * s + 1 / 30240.0;
        sum = sum * s - 1 / 720.0;
        sum = sum * s + 1 / 12.0;
        return 0.5 - z * sum;
    }
}
