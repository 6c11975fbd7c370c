package yarts.physics;

import java.util.concurrent.ForkJoinPool;

/** The part of a {@link World} that knows no units, but a table of them: time, steps, and all units at once. */
abstract class Simulation {
    final State state;
    private final Stepper stepper = new Stepper();
    private boolean stepping;

    Simulation(Integrator integrator, Timestep timestep) {
        state = new State(Check.notNull("integrator", integrator), Check.notNull("timestep", timestep));
    }

    /** What is to be done before a step. */
    abstract void beforeStep(double dt);

    /** What is to be done after a step. */
    abstract void afterStep(double dt);

    /** {@return how steps are worked out} */
    public Integrator getIntegrator() {
        return state.integrator;
    }

    /**
     * Sets how steps are worked out from now on.
     *
     * @param integrator the integrator
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void setIntegrator(Integrator integrator) {
        refuseWhileStepping();
        state.integrator = Check.notNull("integrator", integrator);
    }

    /** {@return how {@link #advance} turns time into steps} */
    public Timestep getTimestep() {
        return state.clock.timestep();
    }

    /**
     * Sets how {@link #advance} turns time into steps from now on. {@link #getAlpha()} stays as it is: what waits becomes
     * the same part of a new step, and the forces' impulse with it. With variable steps nothing waits: it is dropped.
     *
     * @param timestep the timestep
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void setTimestep(Timestep timestep) {
        refuseWhileStepping();
        int was = getTimestep().rate, rate = Check.notNull("timestep", timestep).rate;
        state.clock.setTimestep(timestep);
        state.interpolating = state.interpolating && timestep.isFixed();
        if (rate != was) Impulses.scale(state.table, rate == 0 ? 0 : (double) was / rate);
    }

    /** Runs one step of the timestep's own length: 1/rate seconds, or the longest if steps are variable. */
    public void step() {
        step(getTimestep().maxStep);
    }

    /**
     * Runs one step of exactly dt. Forces applied before it act for dt.
     *
     * @param dt in seconds, from 0 to 1e9
     * @throws IllegalArgumentException if dt is out of range
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public void step(double dt) {
        dt = Check.time("dt", dt);
        begin();
        try {
            run(dt, false);
        } finally {
            stepping = false;
        }
    }

    /**
     * Advances by a frame's time, in steps as {@link Timestep} says. Forces applied before act for the elapsed time: their
     * impulse F·elapsed is spread evenly over the steps that the time turns into, and waits for those that are yet to come.
     * So a push applied once a frame moves a unit alike at any frame rate.
     *
     * @param elapsed in seconds, from 0 to 1e9
     * @return how many steps were run
     * @throws IllegalArgumentException if elapsed is out of range
     * @throws IllegalStateException if called from a {@link StepListener}
     */
    public int advance(double elapsed) {
        elapsed = Check.time("elapsed", elapsed);
        begin();
        try {
            return getTimestep().isFixed() ? advanceFixed(elapsed) : advanceVariable(elapsed);
        } finally {
            stepping = false;
        }
    }

    private int advanceFixed(double elapsed) {
        Clock clock = state.clock;
        Timestep timestep = clock.timestep();
        long before = clock.remainder(), due = clock.stepsDue(elapsed), after = clock.remainder();
        if (due == 0) {
            Impulses.hold(state.table, clock.seconds(after - before));
            return 0;
        }
        double covered = (double) due / timestep.rate;
        Impulses.spread(state.table, clock.seconds(before), clock.seconds(after), covered, due > 1);
        return runFrame(due, timestep.maxStep, true);
    }

    private int advanceVariable(double elapsed) {
        Timestep timestep = state.clock.timestep();
        double most = timestep.maxSteps * timestep.maxStep;
        if (elapsed > most) {
            state.clock.drop(elapsed - most);
            elapsed = most;
        }
        if (elapsed == 0) {
            Impulses.drop(state.table);
            return 0;
        }
        long steps = Math.max(1, (long) (elapsed / timestep.maxStep));
        if (elapsed / steps > timestep.maxStep && steps < timestep.maxSteps) steps++;
        Impulses.spread(state.table, 0, 0, elapsed, steps > 1);
        return runFrame(steps, Math.min(elapsed / steps, timestep.maxStep), false);
    }

    /** Runs the steps due, as far as the limit allows, with the frame's forces in each; drops those not run. */
    private int runFrame(long due, double dt, boolean interpolating) {
        long start = state.clock.tick();
        int n = (int) Math.min(due, state.clock.timestep().maxSteps);
        try {
            for (int i = 0; i < n; i++) {
                if (i > 0) Impulses.repeat(state.table);
                run(dt, interpolating);
            }
            return n;
        } finally {
            state.clock.drop(due - (state.clock.tick() - start), dt);
            Impulses.endFrame(state.table);
        }
    }

    /** A step, and what is before and after it. What stops it before does not let it happen. */
    private void run(double dt, boolean interpolating) {
        try {
            beforeStep(dt);
        } catch (Throwable e) {
            Impulses.drop(state.table);
            throw e;
        }
        stepper.step(state.table, dt, state.integrator);
        state.clock.ran(dt);
        state.interpolating = interpolating;
        afterStep(dt);
    }

    private void begin() {
        refuseWhileStepping();
        stepping = true;
    }

    void refuseWhileStepping() {
        if (!stepping) return;
        throw new IllegalStateException(
                "a step is running: a StepListener must not step, save, restore or set its world");
    }

    /** {@return how far time is on its way from one fixed step to the next: at least 0, and below 1 even as a float} */
    public double getAlpha() {
        return state.clock.alpha();
    }

    /** How far from the last step's start to its end units are drawn. */
    double drawn() {
        return state.interpolating ? getAlpha() : 1;
    }

    /** {@return the number of steps run so far} */
    public long getTick() {
        return state.clock.tick();
    }

    /** {@return the simulated time in seconds: that of the steps run so far} */
    public double getTime() {
        return state.clock.time();
    }

    /** {@return the seconds that {@link #advance} dropped so far, since they were beyond the catch-up limit} */
    public double getDroppedTime() {
        return state.clock.droppedTime();
    }

    /**
     * Sets a pool whose threads share the work of large worlds' steps, from some 30,000 units on, with the thread that
     * calls: as many as make up its parallelism with the caller; of {@link ForkJoinPool#commonPool}, all. The results are
     * the same to the bit, and a step has ended when the call that runs it returns.
     *
     * @param pool the pool, which remains the caller's to shut down, or null for none
     */
    public void setPool(ForkJoinPool pool) {
        stepper.crew = pool == null ? null : new Team(pool, Stepper.LEAST);
    }

    /**
     * Applies a force to every unit, as {@link Unit#applyForce} does: fx0, fy0, fx1, fy1, … in order.
     *
     * @param xy in N, each at most 1e50 in magnitude
     * @param offset where fx0 is
     * @throws IllegalArgumentException if one is out of range; none is applied then
     * @throws IndexOutOfBoundsException if there are not 2·size of them from offset; none is applied then
     */
    public void applyForces(double[] xy, int offset) {
        Bulk.applyForces(state.table, xy, offset);
    }

    /**
     * Copies where to draw all units ({@link Unit#getInterpolatedX()}), in order, as x0, y0, x1, y1, …
     *
     * @param xy where to; values beyond the range of float become the largest float
     * @param offset where x0 goes
     * @throws IndexOutOfBoundsException if there is no room for 2·size floats from offset; nothing is copied then
     */
    public void copyPositions(float[] xy, int offset) {
        Bulk.copyPositions(state.table, xy, offset, drawn());
    }

    /**
     * As {@link #copyPositions(float[], int)}, for a game that keeps the time itself.
     *
     * @param xy where to
     * @param offset where x0 goes
     * @param alpha how far from before the last step, 0, to after it, 1
     * @throws IllegalArgumentException if alpha is out of range
     */
    public void copyPositions(float[] xy, int offset, double alpha) {
        Bulk.copyPositions(state.table, xy, offset, Check.part("alpha", alpha));
    }

    /**
     * As {@link #copyPositions(float[], int, double)}, in full precision. With an alpha of 1 it is {@link Unit#getX()}.
     *
     * @param xy where to
     * @param offset where x0 goes
     * @param alpha how far from before the last step, 0, to after it, 1
     * @throws IllegalArgumentException if alpha is out of range
     */
    public void copyPositions(double[] xy, int offset, double alpha) {
        Bulk.copyPositions(state.table, xy, offset, Check.part("alpha", alpha));
    }

    /**
     * Copies the velocities of all units, in order, as vx0, vy0, vx1, vy1, …
     *
     * @param xy where to
     * @param offset where vx0 goes
     * @throws IndexOutOfBoundsException if there is no room for 2·size doubles from offset; nothing is copied then
     */
    public void copyVelocities(double[] xy, int offset) {
        Bulk.copyVelocities(state.table, xy, offset);
    }

    /**
     * {@return a hash of what a {@link Snapshot} holds} Worlds that were treated alike have the same hash, on any JVM and
     * machine; those that differ in one bit have not, and those that differ in more all but never.
     */
    public long stateHash() {
        return state.hash();
    }
}
