package yarts.physics.source;

/**
 * The unit of "Y*A*R*T*S (Yet Another Real Time Strategy game)" before its correction: the rules of the physics chapter
 * in their order, in our own code. Friction is one more force, −f·v, computed from the velocity at the start of the
 * step. This causes the jitters: in a step with f·dt/m > 1, friction is larger than the force that would stop the unit,
 * and reverses it.
 */
public final class ArticleUnit {
    public double x, y, vx, vy, fx, fy;
    public double mass;
    public double friction;
    public double maxSpeed = Double.POSITIVE_INFINITY;

    public ArticleUnit(double mass) {
        this.mass = mass;
    }

    public void applyForce(double fx, double fy) {
        this.fx += fx;
        this.fy += fy;
    }

    /**
     * The first rule: the velocity at the start of the step changes the position; then the force changes the velocity.
     */
    public void integrate(double dt) {
        x += vx * dt;
        y += vy * dt;
        accelerate(dt);
    }

    /** The better rule: the average of the velocities before and after the step changes the position. */
    public void integrateMidpoint(double dt) {
        double vx0 = vx;
        double vy0 = vy;
        accelerate(dt);
        x += (vx0 + vx) / 2 * dt;
        y += (vy0 + vy) / 2 * dt;
    }

    private void accelerate(double dt) {
        applyForce(-friction * vx, -friction * vy);
        double ax = fx / mass;
        double ay = fy / mass;
        vx += ax * dt;
        vy += ay * dt;
        double squared = vx * vx + vy * vy;
        if (squared > maxSpeed * maxSpeed) {
            double scale = maxSpeed / Math.sqrt(squared);
            vx *= scale;
            vy *= scale;
        }
        fx = 0;
        fy = 0;
    }
}
