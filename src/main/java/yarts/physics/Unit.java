package yarts.physics;

import java.io.NotSerializableException;

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
 * call that is refused changes nothing. Not safe for use by several threads at once. Not {@link java.io.Serializable}:
 * save a {@link Snapshot}.
 */
public class Unit extends Row {
    World world;

    /**
     * Creates a unit at rest at (0, 0), without friction and without a speed cap.
     *
     * @param mass in kg, not zero: from 1e-50 to 1e50
     * @throws IllegalArgumentException if the mass is out of range
     */
    public Unit(double mass) {
        Check.mass(mass);
        columns.mass[row] = mass;
        columns.maxSpeed[row] = Double.POSITIVE_INFINITY;
    }

    @Override
    void leave(Columns room) {
        super.leave(room);
        world = null;
    }

    @Override
    final boolean isMember() {
        return world != null;
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

    /**
     * {@return the magnitude of the velocity, in m/s} Never above {@link #getMaxSpeed()}, and equal to it for a unit at its
     * top speed: what is less than a relative 4e-15 below, as the rounding of two components leaves it, is told as that.
     */
    public final double getSpeed() {
        return Kernel.speed(columns, row);
    }

    /**
     * {@return the force along x that was applied and has not acted yet, in N} In {@link StepListener#beforeStep} it is that
     * of the step to come. After {@code World.advance} it is 0, but a part of its impulse may be pending.
     *
     * @see #getPendingImpulseX()
     */
    public final double getFx() {
        return columns.fx[row];
    }

    /** {@return the force along y that was applied and has not acted yet, in N; see {@link #getFx()}} */
    public final double getFy() {
        return columns.fy[row];
    }

    /** {@return the impulse along x, in N·s, of forces during time that an advance took in and no step covers yet} */
    public final double getPendingImpulseX() {
        return columns.pendingX[row];
    }

    /** {@return the pending impulse along y, in N·s; see {@link #getPendingImpulseX()}} */
    public final double getPendingImpulseY() {
        return columns.pendingY[row];
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

    /** {@return whether the unit is frozen; see {@link #setFrozen}} */
    public final boolean isFrozen() {
        return columns.frozen[row] != 0;
    }

    /**
     * {@return the id that its world gave this unit when it was added} The first unit of a world gets 1, the next 2; none is
     * given twice. A removed unit keeps it until it is added again. It is 0 before.
     *
     * @see World#find
     */
    public final long getId() {
        return columns.id[row];
    }

    /** {@return the world this unit is in, or null} */
    public final World getWorld() {
        return world;
    }

    /**
     * {@return the x coordinate to draw at, in m: as far between those before and after the world's last fixed step as
     * {@link World#getAlpha()} says; x itself where there is nothing to interpolate}
     */
    public final double getInterpolatedX() {
        return world == null ? getX() : getInterpolatedX(world.drawn());
    }

    /** {@return the y coordinate to draw at, in m; see {@link #getInterpolatedX()}} */
    public final double getInterpolatedY() {
        return world == null ? getY() : getInterpolatedY(world.drawn());
    }

    /**
     * {@return the x coordinate between those before and after the last step, in m, for a game that keeps the time itself}
     *
     * @param alpha from the former, 0, to the latter, 1
     * @throws IllegalArgumentException if alpha is out of range
     */
    public final double getInterpolatedX(double alpha) {
        return Bulk.between(columns.previousX[row], getX(), Check.part("alpha", alpha));
    }

    /**
     * {@return the y coordinate; see {@link #getInterpolatedX(double)}}
     *
     * @param alpha from 0 to 1
     * @throws IllegalArgumentException if alpha is out of range
     */
    public final double getInterpolatedY(double alpha) {
        return Bulk.between(columns.previousY[row], getY(), Check.part("alpha", alpha));
    }

    /**
     * Puts the unit somewhere else. It is a teleport: it is drawn there at once, without a streak. Only in {@link
     * StepListener#afterStep} it corrects where the step has led, and what is drawn runs there.
     *
     * @param x in m
     * @param y in m
     * @return this unit
     * @throws IllegalArgumentException if a coordinate is not finite
     */
    public final Unit setPosition(double x, double y) {
        x = Check.finite("x", x);
        y = Check.finite("y", y);
        Columns c = columns;
        c.x[row] = x;
        c.y[row] = y;
        c.wake(row);
        boolean far = Double.isInfinite(x - c.previousX[row]) || Double.isInfinite(y - c.previousY[row]);
        if (far || world == null || !world.corrects(this)) c.settle(row);
        return this;
    }

    /**
     * Sets the velocity; one past the top speed is cut to it, keeping the direction.
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

    private void accept(double vx, double vy) {
        Kernel.accept(columns, row, vx, vy);
        columns.wake(row);
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
        columns.renew();
        return this;
    }

    /**
     * Sets the friction, a linear drag f·v: under a constant force F the unit tends to the speed F/f.
     *
     * @param friction f in N·s/m, from 0 to 1e50
     * @return this unit
     * @throws IllegalArgumentException if the friction is out of range
     */
    public final Unit setFriction(double friction) {
        columns.friction[row] = Check.friction(friction);
        columns.renew();
        return this;
    }

    /**
     * Sets the top speed; what is faster is cut to it at once, keeping the direction. 0 pins: nothing moves the unit, and its
     * velocity is gone. To keep that, {@linkplain #setFrozen freeze} it.
     *
     * @param maxSpeed in m/s, at least 0; infinite for no cap
     * @return this unit
     * @throws IllegalArgumentException if maxSpeed is negative or NaN
     */
    public final Unit setMaxSpeed(double maxSpeed) {
        maxSpeed = Check.maxSpeed(maxSpeed);
        columns.maxSpeed[row] = maxSpeed;
        if (maxSpeed < Kernel.REST) columns.still = true;
        columns.renew();
        accept(getVx(), getVy());
        return this;
    }

    /**
     * Freezes the unit, such as a tank in a transport, or lets it go. A frozen unit keeps its id, index, position and
     * velocity, but does not move; forces and impulses leave no trace on it, now or later.
     *
     * @param frozen whether it is frozen
     * @return this unit
     */
    public final Unit setFrozen(boolean frozen) {
        if (frozen == isFrozen()) return this;
        columns.frozen[row] = frozen ? 1 : 0;
        if (frozen) columns.still = true;
        columns.renew();
        accept(getVx(), getVy()); // what is all but at rest is so: it would get there only beside others that move
        clearForces();
        return this;
    }

    /**
     * Adds a force, which acts for the time by which the unit is advanced next: the dt of {@link #integrate(double)} and
     * {@code World.step(dt)}, the elapsed time of {@code World.advance}, or the one step that a {@link StepListener} is
     * called before. Forces add up until then.
     *
     * @param fx in N, at most 1e50 in magnitude
     * @param fy likewise
     * @throws IllegalArgumentException if a component is out of range
     */
    public final void applyForce(double fx, double fy) {
        Check.push("fx", fx);
        Check.push("fy", fy);
        if (columns.still && isFrozen()) return;
        columns.fx[row] += fx;
        columns.fy[row] += fy;
        columns.push(row);
    }

    /**
     * Changes the velocity at once by j/m, as a kick or a collision does; past the top speed it is cut to it.
     *
     * @param jx in N·s, at most 1e50 in magnitude
     * @param jy likewise
     * @throws IllegalArgumentException if a component is out of range
     */
    public final void applyImpulse(double jx, double jy) {
        Check.push("jx", jx);
        Check.push("jy", jy);
        if (!isFrozen()) accept(getVx() + jx / getMass(), getVy() + jy / getMass());
    }

    /** Forgets every force that has not acted yet, and the impulse that is pending. */
    public final void clearForces() {
        columns.clearForces(row);
    }

    /**
     * Steps this unit alone by {@link Integrator#EULER}, as the source does.
     *
     * @param dt in seconds, from 0 to 1e9
     * @throws IllegalArgumentException if dt is out of range
     */
    public final void integrate(double dt) {
        integrate(dt, Integrator.EULER);
    }

    /**
     * Steps this unit alone, and clears the forces: as {@code World.step(dt)}, to the bit.
     *
     * @param dt in seconds, from 0 to 1e9
     * @param integrator the integrator
     * @throws IllegalArgumentException if dt is out of range
     */
    public final void integrate(double dt, Integrator integrator) {
        Check.notNull("integrator", integrator);
        Coefficients.renew(columns, row, Check.time("dt", dt), integrator);
        Kernel.step(columns, row);
        columns.settle(row);
    }

    /**
     * Refuses to be serialised, as what came back would have lost its physics.
     *
     * @return nothing
     * @throws NotSerializableException always; it says what to save instead
     */
    protected final Object writeReplace() throws NotSerializableException {
        throw new NotSerializableException(
                getClass().getName() + " is a Unit: save a Snapshot, and its own fields by id");
    }

    /** Says where the unit is and how it moves, for logs. */
    @Override
    public String toString() {
        return getClass().getSimpleName() + "[x=" + getX() + ", y=" + getY() + ", vx=" + getVx() + ", vy=" + getVy()
                + ", mass=" + getMass() + "]";
    }
}
