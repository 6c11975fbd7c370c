package yarts.physics;

/**
 * A unit: a point with a mass that forces push, friction slows and a top speed limits. It does not turn.
 *
 * <pre>{@code
 * Unit tank = new Unit(40_000).setFriction(8_000).setMaxSpeed(15);
 * tank.applyForce(120_000, 0);
 * tank.integrate(1 / 60.0);
 * }</pre>
 *
 * <p>A unit works alone, as above, or in a {@link World}, which steps all of its units together. Extend it to add what
 * the game needs ({@code class Tank extends Unit}); the physics cannot be overridden.
 *
 * <p>SI measures throughout: metres, seconds, kilograms, newtons. The accepted range is in the package description; a
 * call that is refused changes nothing. Not safe for use by several threads at once.
 */
public class Unit {
    /** The table that holds this unit's state, and the row. */
    Columns columns;

    int row;

    /**
     * Creates a unit at rest at (0, 0), without friction and without a speed cap.
     *
     * @param mass in kg, not zero: from 1e-50 to 1e50
     * @throws IllegalArgumentException if the mass is out of range
     */
    @SuppressWarnings("this-escape") // to Columns.adopt, which only sets the two fields
    public Unit(double mass) {
        Check.mass(mass);
        Columns.adopt(this);
        columns.mass[row] = mass;
        columns.maxSpeed[row] = Double.POSITIVE_INFINITY;
        columns.update(row);
    }

    /** {@return the x coordinate, in m} */
    public final double getX() {
        return columns.x[row];
    }

    /** {@return the y coordinate, in m} */
    public final double getY() {
        return columns.y[row];
    }

    /** {@return the velocity along x, in m/s} */
    public final double getVx() {
        return columns.vx[row];
    }

    /** {@return the velocity along y, in m/s} */
    public final double getVy() {
        return columns.vy[row];
    }

    /** {@return the magnitude of the velocity, in m/s} */
    public final double getSpeed() {
        double vx = getVx(), vy = getVy();
        return Math.sqrt(vx * vx + vy * vy); // in the range of speeds, squares neither overflow nor vanish
    }

    /** {@return the force along x that the next step will use, as accumulated so far, in N} */
    public final double getFx() {
        return columns.fx[row];
    }

    /** {@return the force along y that the next step will use, as accumulated so far, in N} */
    public final double getFy() {
        return columns.fy[row];
    }

    /** {@return the mass, in kg} */
    public final double getMass() {
        return columns.mass[row];
    }

    /** {@return the friction (linear drag) f of the equation m dv/dt = F − f v, in N·s/m} */
    public final double getFriction() {
        return columns.friction[row];
    }

    /** {@return the top speed, in m/s; infinite if there is none} */
    public final double getMaxSpeed() {
        return columns.maxSpeed[row];
    }

    /**
     * {@return the number that its world gave this unit when it was added} The first unit that is added to a world gets
     * 1, the next 2; none is given twice. A unit that was removed keeps it until it is added again, to the same world or
     * another. It is 0 before.
     *
     * @see World#find
     */
    public final long getId() {
        return columns.id[row];
    }

    /** {@return the world this unit is in, or null} */
    public final World getWorld() {
        return columns.world;
    }

    /**
     * {@return the x coordinate to draw at, in m: between those before and after the world's last fixed step, as far as
     * {@link World#getAlpha()} says; the x coordinate itself where there is nothing to interpolate}
     */
    public final double getInterpolatedX() {
        World world = columns.world;
        return world == null ? getX() : world.interpolate(columns.previousX[row], getX());
    }

    /** {@return the y coordinate to draw at, in m; see {@link #getInterpolatedX()}} */
    public final double getInterpolatedY() {
        World world = columns.world;
        return world == null ? getY() : world.interpolate(columns.previousY[row], getY());
    }

    /**
     * Puts the unit somewhere else. Interpolation starts afresh from there: a teleport leaves no streak.
     *
     * @param x in m
     * @param y in m
     * @return this unit
     * @throws IllegalArgumentException if a coordinate is not finite
     */
    public final Unit setPosition(double x, double y) {
        x = Check.finite("x", x);
        y = Check.finite("y", y);
        columns.x[row] = x;
        columns.y[row] = y;
        columns.settle(row, row + 1);
        return this;
    }

    /**
     * Sets the velocity; one past the top speed is cut to it, in the same direction.
     *
     * @param vx in m/s
     * @param vy in m/s
     * @return this unit
     * @throws IllegalArgumentException if a component is not finite
     */
    public final Unit setVelocity(double vx, double vy) {
        accept(Check.finite("vx", vx), Check.finite("vy", vy));
        return this;
    }

    /** Takes a velocity of any finite magnitude. */
    private void accept(double vx, double vy) {
        double most = Math.max(Math.abs(vx), Math.abs(vy));
        double scale = most > Kernel.FASTEST ? Kernel.FASTEST / most : 1; // so that squares do not overflow
        columns.vx[row] = vx * scale;
        columns.vy[row] = vy * scale;
        cap();
    }

    private void cap() {
        columns.disturb(row);
        if (getSpeed() > Math.min(getMaxSpeed(), Columns.TOP)) {
            Kernel.cap(columns.vx, columns.vy, columns.cap, row);
        }
        boolean pinned = getMaxSpeed() < Kernel.REST;
        if (pinned || Math.abs(getVx()) < Kernel.REST) columns.vx[row] = 0;
        if (pinned || Math.abs(getVy()) < Kernel.REST) columns.vy[row] = 0;
    }

    /**
     * Sets the mass. The velocity stays as it is.
     *
     * @param mass in kg, not zero: from 1e-50 to 1e50
     * @return this unit
     * @throws IllegalArgumentException if the mass is out of range
     */
    public final Unit setMass(double mass) {
        columns.mass[row] = Check.mass(mass);
        columns.update(row);
        return this;
    }

    /**
     * Sets the friction, a linear drag: the unit is slowed by f·v, and under a constant force F tends to the speed F/f.
     *
     * @param friction f in N·s/m, from 0 to 1e50
     * @return this unit
     * @throws IllegalArgumentException if the friction is out of range
     */
    public final Unit setFriction(double friction) {
        columns.friction[row] = Check.friction(friction);
        columns.update(row);
        return this;
    }

    /**
     * Sets the top speed. A unit that is faster is slowed at once, keeping its direction.
     *
     * @param maxSpeed in m/s, at least 0; infinite for no cap
     * @return this unit
     * @throws IllegalArgumentException if maxSpeed is negative or NaN
     */
    public final Unit setMaxSpeed(double maxSpeed) {
        maxSpeed = Check.maxSpeed(maxSpeed);
        columns.maxSpeed[row] = maxSpeed;
        columns.update(row);
        cap();
        return this;
    }

    /**
     * Adds a force, which acts for the time by which the unit is advanced next: the dt of {@link #integrate(double)}
     * and {@link World#step}, the elapsed time of {@link World#advance}, or the one step that is about to run if called
     * from a {@link StepListener}. Forces add up until then.
     *
     * @param fx in N, at most 1e50 in magnitude
     * @param fy in N, at most 1e50 in magnitude
     * @throws IllegalArgumentException if a component is out of range
     */
    public final void applyForce(double fx, double fy) {
        Check.push("fx", fx);
        Check.push("fy", fy);
        columns.fx[row] += fx;
        columns.fy[row] += fy;
        columns.forced = true;
    }

    /**
     * Changes the velocity at once by j/m, as a kick or a collision does; past the top speed it is cut to it.
     *
     * @param jx in N·s, at most 1e50 in magnitude
     * @param jy in N·s, at most 1e50 in magnitude
     * @throws IllegalArgumentException if a component is out of range
     */
    public final void applyImpulse(double jx, double jy) {
        Check.push("jx", jx);
        Check.push("jy", jy);
        accept(getVx() + jx / getMass(), getVy() + jy / getMass());
    }

    /** Forgets every force that has not acted yet. */
    public final void clearForces() {
        columns.clearForces(row);
    }

    /**
     * Steps this unit alone by {@link Integrator#EULER}, as the source does, and clears the forces.
     *
     * @param dt in seconds, from 0 to 1e9
     * @throws IllegalArgumentException if dt is out of range
     */
    public final void integrate(double dt) {
        integrate(dt, Integrator.EULER);
    }

    /**
     * Steps this unit alone, and clears the forces: the same arithmetic as {@link World#step}, to the bit.
     *
     * @param dt in seconds, from 0 to 1e9
     * @param how the integrator
     * @throws IllegalArgumentException if dt is out of range
     */
    public final void integrate(double dt, Integrator how) {
        Check.notNull("how", how);
        columns.stepOne(row, Check.time("dt", dt), how);
    }

    /** Says where the unit is and how it moves, for logs. */
    @Override
    public String toString() {
        return getClass().getSimpleName() + "[x=" + getX() + ", y=" + getY() + ", vx=" + getVx() + ", vy=" + getVy()
                + ", mass=" + getMass() + "]";
    }
}
