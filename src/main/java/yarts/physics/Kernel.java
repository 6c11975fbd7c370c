package yarts.physics;

/**
 * The physics: a step of one row. {@link Passes} computes the same for many rows. {@link Coefficients} computes the
 * decay, gain and lag of a row from dt, the integrator, the mass and the friction. The cap is the top speed of the row:
 *
 * <pre>{@code
 * v' = decay v + gain F                     decay(z), gain(z) dt/m of Integrator
 * v' = (1 − k) v' + k u                     the motor: k = reach / max(|u − v'|, reach), reach = gain R
 * v' = v' min(1, cap/|v'|)                  the speed cap, which keeps the direction
 * x' = x + dt (lag v + (1 − lag) v')        lag(z) of Integrator
 * F  = 0
 * }</pre>
 *
 * <p>The formulas use only + − * /, sqrt, abs, min and max, which give the same bits everywhere. Branches would prevent
 * vectorisation, so max(0, a) is written as (a + |a|)/2, which is exact, and cheaper than Math.max, which also handles
 * NaN and −0.0. If one operand of a sum is itself a sum, it comes first, because TeaVM omits the parentheses of
 * a + (b + c) in JavaScript; likewise for products.
 */
final strictfp class Kernel {
    /** The highest possible speed; in m/s. Its square, and the square of the change in a step, do not overflow. */
    static final double FASTEST = 0x1p500;

    /** The threshold below which velocity components become 0; in m/s. Its square is a normal number. */
    static final double REST = 0x1p-500;

    /** The cap of a unit with a top speed of 0; in m/s. It is so far below REST that the velocity becomes exactly 0. */
    private static final double PINNED = 0x1p-1000;

    /**
     * A speed above the cap is reduced to the cap minus this fraction of it; a speed at the cap does not change. The
     * rounding errors of the reduction and of {@link #speed} are smaller than this fraction, so a reduced speed does
     * not exceed the cap and is not reduced again.
     */
    static final double MARGIN = 0x1p-49;

    /** Scales even the smallest excess (2^-53 of the cap) beyond MARGIN. */
    private static final double STEEP = 0x1p60;

    /** {@link Unit#getSpeed} returns the top speed if the speed is at least this fraction of it. */
    private static final double AT_CAP = 1 - 2 * MARGIN;

    private static final double HALF_OVER_REST = 0.5 / REST;

    private Kernel() {}

    /** Steps row i: forces and friction, motor, speed cap, position. Then clears its forces. */
    static void step(Table t, int i, double dt) {
        double vx = t.vx[i], vy = t.vy[i], decay = t.decay[i], gain = t.gain[i], lag = t.lag[i];
        double nextX = velocity(decay, vx, gain, t.fx[i]);
        double nextY = velocity(decay, vy, gain, t.fy[i]);
        double k = share(nextX, nextY, t.motorVx[i], t.motorVy[i], reach(gain, t.motorForce[i]));
        nextX = blend(nextX, t.motorVx[i], k);
        nextY = blend(nextY, t.motorVy[i], k);
        double left = left(nextX, nextY, t.cap[i]);
        nextX = rest(nextX * left);
        nextY = rest(nextY * left);
        t.vx[i] = nextX;
        t.vy[i] = nextY;
        if (t.frozen[i] == 0) {
            t.x[i] = position(t.x[i], dt, lag, vx, nextX);
            t.y[i] = position(t.y[i], dt, lag, vy, nextY);
        }
        t.fx[i] = t.fy[i] = 0;
    }

    /** v' before the motor and the speed cap, on one axis. */
    static double velocity(double decay, double v, double gain, double force) {
        return decay * v + gain * force;
    }

    /** The maximum change of the velocity by the motor in a step; in m/s. */
    static double reach(double gain, double force) {
        return gain * force;
    }

    /**
     * The share k of the motor's velocity in v', with which the motor changes v' by at most its reach. It is exactly 1
     * if u is within reach. The smallest normal number prevents 0/0 for a unit without a motor; its addition does not
     * change a reach of REST or more.
     */
    static double share(double vx, double vy, double ux, double uy, double reach) {
        return reach / (Math.max(speed(ux - vx, uy - vy), reach) + Double.MIN_NORMAL);
    }

    /** v' after the motor, on one axis: exactly u if k is 1, exactly v' if k is 0. */
    static double blend(double v, double u, double k) {
        return (1 - k) * v + k * u;
    }

    /** The speed cap: the factor min(1, cap/|v'|), which is exactly 1 up to the cap. */
    static double left(double vx, double vy, double cap) {
        double speed = speed(vx, vy), over = speed - cap;
        over = 0.5 * (over + Math.abs(over)); // max(0, over)
        return cap / (over + Math.min(over * STEEP, speed * MARGIN) + cap);
    }

    /**
     * v, multiplied by |v|/REST if |v| is below REST, so that it becomes exactly 0 within a few steps, even if it
     * decays slowly. The result is never −0.0. Without this, velocities would end as subnormal numbers, whose
     * arithmetic is tens of times slower and rounds 0.9 v to v.
     */
    static double rest(double v) {
        double a = 0.5 - Math.abs(v) * HALF_OVER_REST;
        return v - v * (a + Math.abs(a)); // a + |a| = max(0, 1 − |v|/REST)
    }

    /** x', on one axis. */
    static double position(double x, double dt, double lag, double v, double next) {
        return (lag * v + (1 - lag) * next) * dt + x;
    }

    /** |v|. In the range of velocities, the squares neither overflow nor underflow. */
    static double speed(double vx, double vy) {
        return Math.sqrt(vx * vx + vy * vy);
    }

    /** The speed of a row, or its top speed if the rounding errors of the cap can explain the difference. */
    static double speed(Table t, int i) {
        double speed = speed(t.vx[i], t.vy[i]), most = t.maxSpeed[i];
        return speed >= most * AT_CAP ? most : speed;
    }

    /** Sets the top speed of a row, and the cap: the top speed, limited to the valid range of {@link #left}. */
    static void setMaxSpeed(Table t, int i, double maxSpeed) {
        t.maxSpeed[i] = zeroBelowRest(maxSpeed);
        t.cap[i] = Math.max(Math.min(t.maxSpeed[i], FASTEST), PINNED);
    }

    /** Sets the velocity of a row. Any finite velocity is valid; it is capped, and components below REST become 0. */
    static void accept(Table t, int i, double vx, double vy) {
        double scale = scale(vx, vy);
        vx *= scale;
        vy *= scale;
        double left = left(vx, vy, t.cap[i]);
        t.vx[i] = zeroBelowRest(vx * left);
        t.vy[i] = zeroBelowRest(vy * left);
    }

    /** Sets the ordered velocity of a motor. Any finite velocity is valid; components below REST become 0. */
    static void setMotorVelocity(Table t, int i, double vx, double vy) {
        double scale = scale(vx, vy);
        t.motorVx[i] = zeroBelowRest(vx * scale);
        t.motorVy[i] = zeroBelowRest(vy * scale);
    }

    /**
     * The factor that reduces the components of a velocity to at most FASTEST, so that their squares do not overflow.
     */
    private static double scale(double vx, double vy) {
        double most = Math.max(Math.abs(vx), Math.abs(vy));
        return most > FASTEST ? FASTEST / most : 1;
    }

    static double zeroBelowRest(double v) {
        return Math.abs(v) < REST ? 0 : v;
    }
}
