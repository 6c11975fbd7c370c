package yarts.physics;

import java.io.NotSerializableException;

/**
 * A point with a mass that forces accelerate, friction slows and a top speed limits. It does not turn.
 *
 * <pre>{@code
 * Unit tank = new Unit(40_000).setFriction(8_000).setMaxSpeed(15);
 * tank.applyForce(120_000, 0);           // N
 * tank.integrate(1 / 60.0);              // s
 * }</pre>
 *
 * <p>A unit is used alone, as above, or in a {@link World}, which steps all of its units together. Extend this class
 * with the fields and methods of the game ({@code class Tank extends Unit}); the physics cannot be overridden.
 *
 * <p>All quantities are in SI units: metres, seconds, kilograms, newtons. The package description gives their ranges.
 * An invalid argument throws an {@link IllegalArgumentException} and changes nothing.
 *
 * <p>Not thread-safe, but different threads may use different units outside a world. Not {@link java.io.Serializable}:
 * save a {@link Snapshot} instead.
 *
 * <p>Memory: a unit refers to a row of arrays. A unit that is created or removed alone has its own arrays (1 kB). The
 * units that leave by {@link World#clear} or by a restore share arrays, of 208 bytes per unit. These arrays stay in
 * memory until each of these units has joined a world or is garbage-collected.
 */
public strictfp class Unit {
    /** The table that contains the state of this unit. */
    Table table;

    /** The row of this unit in the table. */
    int row;

    /**
     * Creates a unit at rest at (0, 0), without friction and without a top speed.
     *
     * @param mass in kg, not zero: from 1e-50 to 1e50
     * @throws IllegalArgumentException if the mass is NaN or out of range
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
     * {@return the magnitude of the velocity, in m/s} It never exceeds {@link #getMaxSpeed()}. For a unit at its top
     * speed, it equals {@link #getMaxSpeed()}: a relative difference below 4e-15, a rounding error of the components,
     * is ignored.
     */
    public final double getSpeed() {
        return Kernel.speed(table, row);
    }

    /**
     * {@return the force along x that was applied and has not acted yet, in N} In a before-step listener, it is the
     * force for the step that is about to run. After {@code World.advance}, it is 0 unless an after-step listener has
     * applied a force for the next step; a part of the impulse may be pending.
     *
     * @see #getPendingImpulseX()
     */
    public final double getFx() {
        return table.fx[row] + table.waitingX[row];
    }

    /** {@return the force along y that was applied and has not acted yet, in N} See {@link #getFx()}. */
    public final double getFy() {
        return table.fy[row] + table.waitingY[row];
    }

    /** {@return the impulse along x, in N·s, of forces during elapsed time that no step has covered yet} */
    public final double getPendingImpulseX() {
        return table.pendingX[row];
    }

    /** {@return the impulse along y, in N·s, of forces during elapsed time that no step has covered yet} */
    public final double getPendingImpulseY() {
        return table.pendingY[row];
    }

    /** {@return the mass, in kg} */
    public final double getMass() {
        return table.mass[row];
    }

    /** {@return the friction (linear drag) f in m dv/dt = F − f v, in N·s/m} */
    public final double getFriction() {
        return table.friction[row];
    }

    /** {@return the top speed, in m/s; infinite if there is none} */
    public final double getMaxSpeed() {
        return table.maxSpeed[row];
    }

    /** {@return the ordered velocity of the motor along x, in m/s} See {@link #setMotor}. */
    public final double getMotorVx() {
        return table.motorVx[row];
    }

    /** {@return the ordered velocity of the motor along y, in m/s} See {@link #setMotor}. */
    public final double getMotorVy() {
        return table.motorVy[row];
    }

    /** {@return the maximum force of the motor, in N; 0 if it is off} See {@link #setMotor}. */
    public final double getMotorForce() {
        return table.motorForce[row];
    }

    /** {@return whether the unit is frozen} See {@link #setFrozen}. */
    public final boolean isFrozen() {
        return table.frozen[row] != 0;
    }

    /**
     * {@return the id that this unit received when it was added to a world; 0 if it was never in a world} The first
     * unit of a world gets 1, the second 2, and so on. No id is given twice, except after a restore to an earlier
     * state. A removed unit keeps its id until it is added again.
     *
     * @see World#find
     */
    public final long getId() {
        return table.id[row];
    }

    /**
     * {@return the index of this unit in its world, from 0 to size − 1; −1 outside a world} The removal of another unit
     * may change it.
     *
     * @see World#get
     */
    public final int getIndex() {
        return table.owner == null ? -1 : row;
    }

    /** {@return the world that contains this unit, or null} */
    public final World getWorld() {
        return (World) table.owner;
    }

    /**
     * {@return the x coordinate at which to draw the unit, in m} If {@code World.advance} with fixed steps has run the
     * last step, it lies between the positions before and after this step, at the fraction {@link World#getAlpha()}.
     * Otherwise, such as after {@code World.step()} and with variable steps, it is {@link #getX()}.
     */
    public final double getInterpolatedX() {
        World world = getWorld();
        return world == null ? getX() : getInterpolatedX(world.drawnAlpha());
    }

    /** {@return the y coordinate at which to draw the unit, in m} See {@link #getInterpolatedX()}. */
    public final double getInterpolatedY() {
        World world = getWorld();
        return world == null ? getY() : getInterpolatedY(world.drawnAlpha());
    }

    /**
     * {@return the x coordinate between the positions before and after the last step, in m} It is for a game that keeps
     * the time itself.
     *
     * @param alpha the fraction of the step, from 0 (the position before it) to 1 (the position after it)
     * @throws IllegalArgumentException if alpha is NaN or out of range
     */
    public final double getInterpolatedX(double alpha) {
        return Bulk.between(table.previousX[row], getX(), Check.part("alpha", alpha));
    }

    /**
     * {@return the y coordinate between the positions before and after the last step, in m} It is for a game that keeps
     * the time itself.
     *
     * @param alpha the fraction of the step, from 0 (the position before it) to 1 (the position after it)
     * @throws IllegalArgumentException if alpha is NaN or out of range
     */
    public final double getInterpolatedY(double alpha) {
        return Bulk.between(table.previousY[row], getY(), Check.part("alpha", alpha));
    }

    /**
     * Teleports the unit: it is drawn at the new position at once. {@link #moveTo} draws its movement instead.
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
     * Moves the unit to another position, and interpolation draws this movement from the position before the last step.
     * Use it to keep units out of walls, and for lifts and trains. If there is no such position (the unit is outside a
     * world, it was added after that step, or the distance overflows), this method does the same as {@link
     * #setPosition}.
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

    /** Wakes the tile, after any change that makes the next step change the row even without forces. */
    private void wake() {
        table.asleep[Table.tile(row)] = false;
    }

    /**
     * Sets the velocity. A speed above the top speed is reduced to it, and the direction is kept.
     *
     * @param vx in m/s
     * @param vy in m/s
     * @return this unit
     * @throws IllegalArgumentException if a component is not finite
     */
    public final Unit setVelocity(double vx, double vy) {
        changeVelocity(Check.finite("vx", vx), Check.finite("vy", vy));
        return this;
    }

    private void changeVelocity(double vx, double vy) {
        Kernel.accept(table, row, vx, vy);
        wake();
    }

    /**
     * Sets the mass. The velocity stays the same.
     *
     * @param mass in kg, not zero: from 1e-50 to 1e50
     * @return this unit
     * @throws IllegalArgumentException if the mass is NaN or out of range
     */
    public final Unit setMass(double mass) {
        table.mass[row] = Check.mass(mass);
        Coefficients.renewRow(table, row);
        return this;
    }

    /**
     * Sets the friction f, a linear drag −f·v: under a constant force F, the unit approaches the speed F/f.
     *
     * @param friction f in N·s/m, from 0 to 1e50
     * @return this unit
     * @throws IllegalArgumentException if the friction is NaN or out of range
     */
    public final Unit setFriction(double friction) {
        table.friction[row] = Check.friction(friction);
        Coefficients.renewRow(table, row);
        return this;
    }

    /**
     * Sets the top speed. A higher speed is reduced to it at once, and the direction is kept. With a top speed of 0,
     * the velocity is 0 and no force moves the unit. To stop a unit and keep its velocity, {@linkplain #setFrozen
     * freeze} it.
     *
     * @param maxSpeed in m/s, at least 0; infinite for none; a value below 2<sup>-500</sup> becomes 0
     * @return this unit
     * @throws IllegalArgumentException if maxSpeed is negative or NaN
     */
    public final Unit setMaxSpeed(double maxSpeed) {
        Kernel.setMaxSpeed(table, row, Check.maxSpeed(maxSpeed));
        if (getMaxSpeed() == 0) table.still[Table.tile(row)] = true;
        Coefficients.renewRow(table, row);
        changeVelocity(getVx(), getVy());
        return this;
    }

    /**
     * Freezes the unit, such as a tank in a transport, or releases it. A frozen unit keeps its id, index, position and
     * velocity, but does not move. Impulses, forces and the motor have no effect on it. When it is frozen or released,
     * forces that have not acted and the pending impulse are discarded.
     *
     * @param frozen true to freeze it, false to release it
     * @return this unit
     */
    public final Unit setFrozen(boolean frozen) {
        if (frozen == isFrozen()) return this;
        table.frozen[row] = frozen ? 1 : 0;
        if (frozen) table.still[Table.tile(row)] = true;
        Coefficients.renewRow(table, row);
        changeVelocity(getVx(), getVy()); // a velocity below REST becomes 0 now, not in the next steps
        clearForces();
        return this;
    }

    /**
     * Adds a force, which acts for the time of the next step or advance: the dt of {@link #integrate(double)} or {@code
     * World.step(dt)}, or the elapsed time of {@code World.advance}. In a {@link StepListener} of its world, a force
     * acts for exactly one step: before a step for this step, after a step for the next one. Forces that have not acted
     * add up.
     *
     * @param fx in N, at most 1e50 in magnitude
     * @param fy in N, at most 1e50 in magnitude
     * @throws IllegalArgumentException if a component is NaN or out of range
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
     * Sets the motor: in every step, it changes the velocity towards an ordered velocity, with a force of at most
     * maxForce. It stays on until it is set again, so a game can set it once per order or once per frame. {@link
     * #clearForces} does not switch it off, and a unit keeps it when it joins or leaves a world.
     *
     * <pre>{@code
     * tank.setMotor(10, 0, 80_000);           // drive at 10 m/s, with an engine of 80 kN
     * tank.setMotor(0, 0, 200_000);           // brake, and stand still
     * crate.setMotor(0, 0, 0.6 * 9.81 * m);   // dry friction on the ground, with the coefficient 0.6
     * crate.setMotor(2, 0, 0.6 * 9.81 * m);   // the same on a conveyor belt of 2 m/s
     * }</pre>
     *
     * <p>In a step, the motor changes the velocity v' that follows from forces and friction. With gain(z) of the {@link
     * Integrator} and u for the ordered velocity:
     *
     * <pre>{@code
     * reach = gain(z) (dt/m) maxForce
     * v' = (1 − k) v' + k u,   k = reach / max(|u − v'|, reach)
     * }</pre>
     *
     * <p>So the velocity never passes u. A unit reaches exactly u if maxForce exceeds the friction f·|u|; otherwise it
     * approaches the speed maxForce/f. With u = 0 it stops exactly, and forces below maxForce do not move it. The top
     * speed applies after the motor. The motor of a frozen unit has no effect.
     *
     * <p>The formula is that of friction in "Y*A*R*T*S (Yet Another Real Time Strategy game)", limited in the same way:
     * friction does not reverse a unit, and the motor does not pass u.
     *
     * @param vx the ordered velocity u along x, in m/s; any finite number; the top speed does not limit it
     * @param vy the ordered velocity u along y, in m/s, likewise
     * @param maxForce the maximum force of the motor, in N, from 0 (off) to 1e50
     * @return this unit
     * @throws IllegalArgumentException if a component is not finite, or if maxForce is NaN or out of range
     */
    public final Unit setMotor(double vx, double vy, double maxForce) {
        vx = Check.finite("vx", vx);
        vy = Check.finite("vy", vy);
        table.motorForce[row] = Check.motorForce("maxForce", maxForce);
        Kernel.setMotorVelocity(table, row, vx, vy);
        table.motored[Table.tile(row)] = true;
        wake();
        return this;
    }

    /**
     * Changes the velocity by j/m at once, as explosions, recoil and collisions do. A speed above the top speed is
     * reduced to it.
     *
     * @param jx in N·s, at most 1e50 in magnitude
     * @param jy in N·s, at most 1e50 in magnitude
     * @throws IllegalArgumentException if a component is NaN or out of range
     */
    public final void applyImpulse(double jx, double jy) {
        Check.push("jx", jx);
        Check.push("jy", jy);
        if (!isFrozen()) changeVelocity(getVx() + jx / getMass(), getVy() + jy / getMass());
    }

    /** Discards all forces that have not acted yet, and the pending impulse. The motor stays on. */
    public final void clearForces() {
        table.clearForces(row);
    }

    /**
     * Steps this unit alone by {@link Integrator#EULER}, the rule of "Y*A*R*T*S", and clears its forces.
     *
     * @param dt in seconds, from 0 to 1e9
     * @throws IllegalArgumentException if dt is NaN or out of range
     */
    public final void integrate(double dt) {
        integrate(dt, Integrator.EULER);
    }

    /**
     * Steps this unit alone and clears its forces, with the same result as {@code World.step(dt)}, to the bit. A unit
     * in a world is drawn at its new position at once, and its pending impulse stays pending.
     *
     * @param dt in seconds, from 0 to 1e9
     * @param integrator the method that computes the step
     * @throws IllegalArgumentException if dt is NaN or out of range
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
        Coefficients.renewRow(t, i); // for the steps of its world
        t.settle(i);
        wake();
    }

    /**
     * Prevents the serialization of a subclass that is {@link java.io.Serializable}: a deserialized unit would have no
     * physical state.
     *
     * @return nothing
     * @throws NotSerializableException always; the message names the alternative, a {@link Snapshot}
     */
    protected final Object writeReplace() throws NotSerializableException {
        throw new NotSerializableException(
                getClass().getName() + " is a Unit: save a Snapshot, and its own fields by id");
    }

    /**
     * {@return a description for logs: class, id, position, velocity, mass, friction, top speed, and whether it is
     * frozen}
     */
    @Override
    public String toString() {
        return getClass().getSimpleName() + "#" + getId() + "[x=" + getX() + ", y=" + getY() + ", vx=" + getVx()
                + ", vy="
                + getVy() + ", mass=" + getMass() + ", friction=" + getFriction() + ", maxSpeed=" + getMaxSpeed()
                + (isFrozen() ? ", frozen]" : "]");
    }
}
