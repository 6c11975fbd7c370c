package yarts.physics;

import java.io.NotSerializableException;

/**
 * A unit: a point with a mass, which forces accelerate, friction slows and a top speed limits. It does not turn.
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
 * <p>All quantities are in SI units: metres, seconds, kilograms, newtons. The package description gives their ranges.
 * An invalid argument throws an {@link IllegalArgumentException} and changes nothing. Not safe for use by several threads
 * at once; units outside a world may be used by one thread each. Not {@link java.io.Serializable}: save a
 * {@link Snapshot}.
 *
 * <p>A unit is a handle to a row of arrays. After {@link World#clear} and after a restore by which several units leave,
 * these units share one set of arrays (208 bytes for each), which any one of them keeps in memory until it joins a world
 * or is collected. A unit that is removed by itself has arrays of its own, of 1 kB.
 */
public class Unit {
    /** The table that contains the state of this unit, and its row there. */
    Table table;

    int row;

    /**
     * Creates a unit at rest at (0, 0), without friction and without a speed cap.
     *
     * @param mass in kg, not zero: from 1e-50 to 1e50
     * @throws IllegalArgumentException if the mass is out of range
     */
    public Unit(double mass) {
        Check.mass(mass);
        table = new Table(1);
        table.mass[0] = mass;
        Kernel.setMaxSpeed(table, 0, Double.POSITIVE_INFINITY);
    }

    /** {@return the x coordinate, in m} */
    public final double getX() {
        return table.x[row];
    }

    /** {@return the y coordinate, in m} */
    public final double getY() {
        return table.y[row];
    }

    /** {@return the velocity along x, in m/s} */
    public final double getVx() {
        return table.vx[row];
    }

    /** {@return the velocity along y, in m/s} */
    public final double getVy() {
        return table.vy[row];
    }

    /**
     * {@return the magnitude of the velocity, in m/s} It never exceeds {@link #getMaxSpeed()}, and equals it for a unit at
     * its top speed: differences below a relative 4e-15, which are rounding errors of the two components, are ignored.
     */
    public final double getSpeed() {
        return Kernel.speed(table, row);
    }

    /**
     * {@return the force along x that was applied and has not acted yet, in N} In a before-step listener this is the force
     * of the step that is about to run. After {@code World.advance} it is 0, unless an after-step listener has applied a
     * force for the next step; a part of the impulse may be pending.
     *
     * @see #getPendingImpulseX()
     */
    public final double getFx() {
        return table.fx[row] + table.waitingX[row];
    }

    /** {@return the force along y that was applied and has not acted yet, in N; see {@link #getFx()}} */
    public final double getFy() {
        return table.fy[row] + table.waitingY[row];
    }

    /** {@return the impulse along x, in N·s, of forces that acted during elapsed time not yet covered by a step} */
    public final double getPendingImpulseX() {
        return table.pendingX[row];
    }

    /** {@return the pending impulse along y, in N·s; see {@link #getPendingImpulseX()}} */
    public final double getPendingImpulseY() {
        return table.pendingY[row];
    }

    /** {@return the mass, in kg} */
    public final double getMass() {
        return table.mass[row];
    }

    /** {@return the friction (linear drag) f of the equation m dv/dt = F − f v, in N·s/m} */
    public final double getFriction() {
        return table.friction[row];
    }

    /** {@return the top speed, in m/s; infinite if there is no cap} */
    public final double getMaxSpeed() {
        return table.maxSpeed[row];
    }

    /** {@return the velocity along x that the motor tries to reach, in m/s; see {@link #setMotor}} */
    public final double getMotorVx() {
        return table.motorVx[row];
    }

    /** {@return the velocity along y that the motor tries to reach, in m/s; see {@link #setMotor}} */
    public final double getMotorVy() {
        return table.motorVy[row];
    }

    /** {@return the greatest force of the motor, in N; 0 if it is off} */
    public final double getMotorForce() {
        return table.motorForce[row];
    }

    /** {@return whether the unit is frozen; see {@link #setFrozen}} */
    public final boolean isFrozen() {
        return table.frozen[row] != 0;
    }

    /**
     * {@return the id that its world gave this unit when it was added} The first unit of a world gets 1, the next one 2; no
     * id is given twice, except after a restore to an earlier state. A removed unit keeps its id until it is added again. Before, it is 0.
     *
     * @see World#find
     */
    public final long getId() {
        return table.id[row];
    }

    /**
     * {@return the index of this unit in its world, from 0 to size − 1, or −1 outside a world} The removal of another unit
     * may change it.
     *
     * @see World#get
     */
    public final int getIndex() {
        return table.owner == null ? -1 : row;
    }

    /** {@return the world that this unit is in, or null} */
    public final World getWorld() {
        return (World) table.owner;
    }

    /**
     * {@return the x coordinate to draw at, in m} It lies between the positions before and after the last step of {@code
     * World.advance} with fixed steps, at the fraction {@link World#getAlpha()}. Otherwise, such as after {@code World.step()}
     * and with variable steps, it is {@link #getX()}.
     */
    public final double getInterpolatedX() {
        World world = getWorld();
        return world == null ? getX() : getInterpolatedX(world.drawnAlpha());
    }

    /** {@return the y coordinate to draw at, in m; see {@link #getInterpolatedX()}} */
    public final double getInterpolatedY() {
        World world = getWorld();
        return world == null ? getY() : getInterpolatedY(world.drawnAlpha());
    }

    /**
     * {@return the x coordinate between the positions before and after the last step, in m, for a game that keeps the time
     * itself}
     *
     * @param alpha the fraction, from 0 (before) to 1 (after)
     * @throws IllegalArgumentException if alpha is out of range
     */
    public final double getInterpolatedX(double alpha) {
        return Bulk.between(table.previousX[row], getX(), Check.part("alpha", alpha));
    }

    /**
     * {@return the y coordinate; see {@link #getInterpolatedX(double)}}
     *
     * @param alpha the fraction, from 0 to 1
     * @throws IllegalArgumentException if alpha is out of range
     */
    public final double getInterpolatedY(double alpha) {
        return Bulk.between(table.previousY[row], getY(), Check.part("alpha", alpha));
    }

    /**
     * Places the unit at another position. This is a teleport: it is drawn there at once. To let it be drawn on its way,
     * use {@link #moveTo}.
     *
     * @param x in m
     * @param y in m
     * @return this unit
     * @throws IllegalArgumentException if a coordinate is not finite
     */
    public final Unit setPosition(double x, double y) {
        x = Check.finite("x", x);
        y = Check.finite("y", y);
        table.x[row] = x;
        table.y[row] = y;
        table.settle(row);
        return this;
    }

    /**
     * Moves the unit to another position. It is drawn moving there, from its position before the last step: use it to keep
     * units out of walls, and for lifts and trains. Where there is no such position (outside a world, or if the unit was
     * added since that step, or if it is infinitely far away), this is {@link #setPosition}.
     *
     * @param x in m
     * @param y in m
     * @return this unit
     * @throws IllegalArgumentException if a coordinate is not finite
     */
    public final Unit moveTo(double x, double y) {
        x = Check.finite("x", x);
        y = Check.finite("y", y);
        World world = getWorld();
        boolean stepped = world != null && world.hasStepped(this);
        boolean near = Math.abs(x - table.previousX[row]) <= Double.MAX_VALUE
                && Math.abs(y - table.previousY[row]) <= Double.MAX_VALUE;
        if (!stepped || !near) return setPosition(x, y);
        table.x[row] = x;
        table.y[row] = y;
        wake();
        return this;
    }

    /** Follows a change by which the next step would change the row even without forces. */
    private void wake() {
        table.asleep[Table.tile(row)] = false;
    }

    /**
     * Sets the velocity. One above the top speed is reduced to it; the direction stays.
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
        Kernel.accept(table, row, vx, vy);
        wake();
    }

    /**
     * Sets the mass. The velocity stays as it is.
     *
     * @param mass in kg, not zero: from 1e-50 to 1e50
     * @return this unit
     * @throws IllegalArgumentException if the mass is out of range
     */
    public final Unit setMass(double mass) {
        table.mass[row] = Check.mass(mass);
        Coefficients.renewRow(table, row);
        return this;
    }

    /**
     * Sets the friction, a linear drag f·v: under a constant force F the unit approaches the speed F/f.
     *
     * @param friction f in N·s/m, from 0 to 1e50
     * @return this unit
     * @throws IllegalArgumentException if the friction is out of range
     */
    public final Unit setFriction(double friction) {
        table.friction[row] = Check.friction(friction);
        Coefficients.renewRow(table, row);
        return this;
    }

    /**
     * Sets the top speed. A higher speed is reduced to it at once; the direction stays. A unit with a top speed of 0 is
     * pinned: nothing moves it, and its velocity is 0. To keep the velocity, {@linkplain #setFrozen freeze} the unit.
     *
     * @param maxSpeed in m/s, at least 0; infinite for no cap; below 2<sup>-500</sup> it becomes 0
     * @return this unit
     * @throws IllegalArgumentException if maxSpeed is negative or NaN
     */
    public final Unit setMaxSpeed(double maxSpeed) {
        Kernel.setMaxSpeed(table, row, Check.maxSpeed(maxSpeed));
        if (getMaxSpeed() == 0) table.still[Table.tile(row)] = true;
        Coefficients.renewRow(table, row);
        accept(getVx(), getVy());
        return this;
    }

    /**
     * Freezes the unit, such as a tank in a transport, or releases it. A frozen unit keeps its id, index, position and
     * velocity, but does not move. Impulses have no effect on it. Forces do not move it either, and are discarded when it is
     * released.
     *
     * @param frozen whether it is frozen
     * @return this unit
     */
    public final Unit setFrozen(boolean frozen) {
        if (frozen == isFrozen()) return this;
        table.frozen[row] = frozen ? 1 : 0;
        if (frozen) table.still[Table.tile(row)] = true;
        Coefficients.renewRow(table, row);
        accept(getVx(), getVy()); // a velocity below the threshold would become 0 only in steps of its tile
        clearForces();
        return this;
    }

    /**
     * Adds a force. It acts for the time by which the unit is advanced next: the dt of {@link #integrate(double)} or
     * {@code World.step(dt)}, or the elapsed time of {@code World.advance}. In a {@link StepListener} of its world it acts
     * for exactly one step: the one that is about to run, or after a step the next one. Forces add up until then.
     *
     * @param fx in N, at most 1e50 in magnitude
     * @param fy in N, at most 1e50 in magnitude
     * @throws IllegalArgumentException if a component is out of range
     */
    public final void applyForce(double fx, double fy) {
        Check.push("fx", fx);
        Check.push("fy", fy);
        Table t = table;
        int i = row;
        t.fx[i] += fx;
        t.fy[i] += fy;
        t.pushed[Table.tile(i)] = true;
    }

    /**
     * Sets the motor: in every step, it changes the velocity towards the ordered one by a force of at most maxForce. It stays
     * on until it is set again, so that a game can set it once per order or per frame; {@link #clearForces} leaves it on, and
     * a unit keeps it when it joins or leaves a world.
     *
     * <pre>{@code
     * tank.setMotor(10, 0, 80_000);           // drive at 10 m/s, with an engine of 80 kN
     * tank.setMotor(0, 0, 200_000);           // brake, and stay there
     * crate.setMotor(0, 0, 0.6 * 9.81 * m);   // dry friction on the ground, with the coefficient 0.6
     * crate.setMotor(2, 0, 0.6 * 9.81 * m);   // the same on a conveyor of 2 m/s
     * }</pre>
     *
     * <p>In a step, after forces and friction have led to v', with the {@link Integrator}'s gain(z):
     *
     * <pre>{@code
     * reach = gain(z) (dt/m) maxForce
     * v' = (1 − k) v' + k u,   k = reach / max(|u − v'|, reach)
     * }</pre>
     *
     * <p>So the velocity never passes the ordered one, u. A unit reaches exactly u if maxForce exceeds the friction f·|u|;
     * otherwise it approaches the speed maxForce/f. With u = 0 it stops exactly, and pushes below maxForce do not move it. The
     * speed cap comes after the motor. The motor of a frozen unit has no effect.
     *
     * <p>It is the friction of "Y*A*R*T*S (Yet Another Real Time Strategy game)" again, which is limited so that it does not
     * reverse a unit; here the limit is that it does not pass u.
     *
     * @param vx the ordered velocity u along x, in m/s; any finite number, as for {@link #setVelocity}, but not capped
     * @param vy the ordered velocity u along y, in m/s
     * @param maxForce the greatest force of the motor, in N, from 0 (off) to 1e50
     * @return this unit
     * @throws IllegalArgumentException if an argument is out of range
     */
    public final Unit setMotor(double vx, double vy, double maxForce) {
        vx = Check.finite("vx", vx);
        vy = Check.finite("vy", vy);
        table.motorForce[row] = Check.motorForce("maxForce", maxForce);
        Kernel.order(table, row, vx, vy);
        table.motored[Table.tile(row)] = true;
        wake();
        return this;
    }

    /**
     * Changes the velocity at once by j/m, as a kick or a collision does. One above the top speed is reduced to it.
     *
     * @param jx in N·s, at most 1e50 in magnitude
     * @param jy in N·s, at most 1e50 in magnitude
     * @throws IllegalArgumentException if a component is out of range
     */
    public final void applyImpulse(double jx, double jy) {
        Check.push("jx", jx);
        Check.push("jy", jy);
        if (!isFrozen()) accept(getVx() + jx / getMass(), getVy() + jy / getMass());
    }

    /** Discards all forces that have not acted yet, and the pending impulse. The motor stays on. */
    public final void clearForces() {
        table.clearForces(row);
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
     * Steps this unit alone, and clears the forces: the same bits as {@code World.step(dt)}. A unit in a world is drawn at the
     * new place at once, and its pending impulse stays pending.
     *
     * @param dt in seconds, from 0 to 1e9
     * @param integrator the integrator
     * @throws IllegalArgumentException if dt is out of range
     */
    public final void integrate(double dt, Integrator integrator) {
        dt = Check.time("dt", dt);
        Check.notNull("integrator", integrator);
        Table t = table;
        int i = row;
        t.fx[i] += t.waitingX[i];
        t.fy[i] += t.waitingY[i];
        t.waitingX[i] = t.waitingY[i] = 0;
        Coefficients.setRow(t, i, dt, integrator);
        Kernel.step(t, i, dt);
        Coefficients.renewRow(t, i); // those of its world's steps again
        t.settle(i);
        wake();
    }

    /**
     * Prevents the serialization of a subclass that is {@link java.io.Serializable}: the object that is read back would
     * have no physics.
     *
     * @return nothing
     * @throws NotSerializableException always; the message says what to save instead
     */
    protected final Object writeReplace() throws NotSerializableException {
        throw new NotSerializableException(
                getClass().getName() + " is a Unit: save a Snapshot, and its own fields by id");
    }

    /** {@return a description for logs: class, id, position, velocity, mass, friction, top speed, and whether it is frozen} */
    @Override
    public String toString() {
        return getClass().getSimpleName() + "#" + getId() + "[x=" + getX() + ", y=" + getY() + ", vx=" + getVx()
                + ", vy="
                + getVy() + ", mass=" + getMass() + ", friction=" + getFriction() + ", maxSpeed=" + getMaxSpeed()
                + (isFrozen() ? ", frozen]" : "]");
    }
}
