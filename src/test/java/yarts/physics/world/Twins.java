package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.ForkJoinPool;
import java.util.function.Consumer;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import yarts.physics.Copies;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.StepListener;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * A world and a plain model of it: lists, and for each unit a twin that is never in a world. The model counts time in
 * integers and computes the impulse of a force by its definition. The forces of each step must equal those of the model
 * within rounding. The twin then uses the forces of the world, so that everything else must have the same bits.
 */
final class Twins {
    /** The unit of waiting time is a fraction of a nanosecond. Their number in a second is a multiple of every rate. */
    private static final BigInteger NANOSECOND = BigInteger.valueOf(9_000_000);

    private static final BigInteger SECOND = NANOSECOND.multiply(BigInteger.valueOf(1_000_000_000));
    private static final double[] ALPHAS = {0, 0.5, 1};

    private static final class Twin {
        final Unit unit;
        final Unit alone;
        /** The force in each step of the current frame; the force for only the next step; and the pending impulse. */
        final double[] frame = new double[2], once = new double[2], pending = new double[2];
        /** The magnitudes to which the rounding errors of the force and of the pending impulse are compared. */
        final double[] scale = new double[2], pendingScale = new double[2];

        double previousX, previousY;
        long id;

        Twin(Unit unit, Unit alone) {
            this.unit = unit;
            this.alone = alone;
        }

        /** A copy of this twin's state, for a unit of the world. */
        Twin copy(Unit unit) {
            Twin copy = new Twin(unit, Copies.of(alone));
            for (int k = 0; k < 2; k++) {
                copy.frame[k] = frame[k];
                copy.once[k] = once[k];
                copy.pending[k] = pending[k];
                copy.scale[k] = scale[k];
                copy.pendingScale[k] = pendingScale[k];
            }
            copy.previousX = previousX;
            copy.previousY = previousY;
            copy.id = id;
            return copy;
        }

        void settle() {
            previousX = alone.getX();
            previousY = alone.getY();
        }

        /**
         * A frame without a step, after which {@code after} seconds wait; the rounding error of time is relative to
         * them.
         */
        void hold(double elapsed, double after) {
            double[] f = {alone.getFx(), alone.getFy()};
            for (int k = 0; k < 2; k++) {
                pending[k] += f[k] * elapsed;
                pendingScale[k] += Math.abs(f[k]) * after;
            }
            alone.clearForces();
        }

        /**
         * A frame whose steps cover {@code now} of its seconds; the fraction {@code kept} of the pending impulse stays
         * pending.
         */
        void spread(double kept, double now, double later, double covered) {
            double[] f = {alone.getFx(), alone.getFy()};
            for (int k = 0; k < 2; k++) {
                if (covered < 1e-9) { // a variable step: the pending impulse continues to wait
                    frame[k] = f[k];
                    scale[k] += Math.abs(f[k]);
                    continue;
                }
                frame[k] = (pending[k] * (1 - kept) + f[k] * now) / covered;
                scale[k] += pendingScale[k] / covered + Math.abs(f[k]);
                pending[k] = pending[k] * kept + f[k] * later;
                pendingScale[k] = pendingScale[k] * kept + Math.abs(f[k]) * later;
            }
            alone.clearForces();
        }

        void applyOnce(double fx, double fy) {
            unit.applyForce(fx, fy);
            once[0] += fx;
            once[1] += fy;
            for (int k = 0; k < 2; k++) scale[k] += Math.abs(k == 0 ? fx : fy);
        }

        /** Steps with the forces of a call of step: those applied since the last step, and the waiting ones. */
        void step(double dt, Integrator integrator) {
            settle();
            alone.applyForce(once[0], once[1]);
            alone.integrate(dt, integrator);
            once[0] = once[1] = 0;
            scale[0] = scale[1] = 0;
        }

        void stepInFrame(double dt, Integrator integrator) {
            if (!unit.isFrozen()) {
                assertEquals(frame[0] + once[0], unit.getFx(), rounding(scale[0]));
                assertEquals(frame[1] + once[1], unit.getFy(), rounding(scale[1]));
            }
            once[0] = once[1] = 0;
            settle();
            alone.applyForce(unit.getFx(), unit.getFy());
            alone.integrate(dt, integrator);
        }

        /** The allowed rounding error; that of subnormal numbers is not relative. */
        private static double rounding(double scale) {
            return 1e-14 * scale + 1e-300;
        }

        void frameDone() {
            for (int k = 0; k < 2; k++) scale[k] = Math.abs(once[k]);
        }

        void comparePending() {
            if (unit.isFrozen()) return;
            assertEquals(pending[0], unit.getPendingImpulseX(), rounding(pendingScale[0]));
            assertEquals(pending[1], unit.getPendingImpulseY(), rounding(pendingScale[1]));
        }

        void forget() {
            alone.clearForces();
            for (int k = 0; k < 2; k++) frame[k] = once[k] = pending[k] = scale[k] = pendingScale[k] = 0;
        }
    }

    /** The state of the model that belongs to a snapshot. */
    private record Save(
            Snapshot snapshot,
            long hash,
            List<Twin> inside,
            Integrator integrator,
            Pace pace,
            Time time,
            long lastId,
            long lastSteppedId) {}

    private record Time(long tick, BigInteger waiting, double time, double dropped, boolean interpolating) {}

    /** A listener that is called exactly when it is due. */
    private final class Spy implements StepListener {
        private final boolean once;

        Spy(boolean once) {
            this.once = once;
        }

        @Override
        public void onStep(World w, double dt) {
            assertSame(world, w);
            assertSame(due.poll(), this);
            if (once) removeListener(this);
        }
    }

    private World world;
    /** The listeners in the order of their calls. The first of each list gives the orders of a frame. */
    private final List<StepListener> before = new ArrayList<>(), after = new ArrayList<>();
    /** The listeners that the present step has not called yet. */
    private final Deque<StepListener> due = new ArrayDeque<>();
    /** The work of the first listeners, which differs in each frame. */
    private StepListener firstBefore = (w, dt) -> {}, firstAfter = firstBefore;

    private Integrator integrator;
    private Pace pace;
    private final List<Twin> inside = new ArrayList<>();
    private final List<Twin> outside = new ArrayList<>();
    /** The snapshots of this world. */
    private final List<Save> saves = new ArrayList<>();

    private long tick, lastId, lastSteppedId;
    private BigInteger waiting = BigInteger.ZERO;
    private double time, dropped;
    private boolean interpolating;

    Twins() {
        move(Integrator.EULER, Pace.fixed(60, 15));
    }

    /** Moves all units to a new world. They lose the forces that have not acted. */
    void move(Integrator integrator, Pace pace) {
        this.integrator = integrator;
        this.pace = pace;
        if (world != null) world.clear();
        world = new World(integrator, pace.timestep());
        before.clear();
        after.clear();
        addListener(true, (w, dt) -> {
            call(before);
            firstBefore.onStep(w, dt);
        });
        addListener(false, (w, dt) -> {
            call(after);
            firstAfter.onStep(w, dt);
        });
        waiting = BigInteger.ZERO;
        tick = lastId = lastSteppedId = 0;
        time = dropped = 0;
        interpolating = false;
        saves.clear();
        for (Twin twin : inside) {
            world.add(twin.unit);
            twin.id = ++lastId;
            twin.forget();
            twin.settle();
        }
    }

    /** At the first of these listeners: the others are due, even if a listener changes the list. */
    private void call(List<StepListener> listeners) {
        assertTrue(due.isEmpty());
        due.addAll(listeners.subList(1, listeners.size()));
    }

    private void addListener(boolean beforeStep, StepListener listener) {
        if (beforeStep) world.addBeforeStep(listener);
        else world.addAfterStep(listener);
        (beforeStep ? before : after).add(listener);
    }

    private void removeListener(StepListener listener) {
        boolean wasBefore = before.removeIf(other -> other == listener);
        boolean wasAfter = after.removeIf(other -> other == listener);
        assertEquals(wasBefore || wasAfter, world.removeStepListener(listener));
        assertFalse(world.removeStepListener(listener));
    }

    /** Adds a listener, adds one once more, or removes one; also during a step. */
    void changeListeners(int pick) {
        List<StepListener> spies = new ArrayList<>(before.subList(1, before.size()));
        spies.addAll(after.subList(1, after.size()));
        if (spies.size() < 2 || pick % 4 == 0) addListener(pick % 3 == 0, new Spy(pick % 5 == 0));
        else if (pick % 4 == 1) addListener(pick % 3 == 0, spies.get(pick % spies.size()));
        else removeListener(spies.get(pick % spies.size()));
    }

    void setIntegrator(Integrator integrator) {
        this.integrator = integrator;
        world.setIntegrator(integrator);
    }

    /** Preserves waiting time and pending impulses. */
    void setPace(Pace next) {
        world.setTimestep(next.timestep());
        pace = next;
    }

    /** Creates a unit twice and adds one of the two. */
    void addNew(double mass, double friction) {
        Twin twin = new Twin(new Unit(mass).setFriction(friction), new Unit(mass).setFriction(friction));
        outside.add(twin);
        add(outside.size() - 1);
    }

    void add(int pick) {
        if (outside.isEmpty()) return;
        Twin twin = outside.remove(pick % outside.size());
        assertSame(twin.unit, world.add(twin.unit));
        twin.id = ++lastId;
        twin.forget();
        twin.settle();
        inside.add(twin);
    }

    void remove(int pick) {
        if (inside.isEmpty()) return;
        Twin twin = inside.get(pick % inside.size());
        assertTrue(world.remove(twin.unit));
        removed(pick % inside.size());
    }

    private void removed(int i) {
        Twin twin = inside.get(i);
        twin.forget();
        outside.add(twin);
        Twin last = inside.remove(inside.size() - 1);
        if (i < inside.size()) inside.set(i, last);
    }

    /** Removes those whose mass is above a limit, through the iterator. */
    void removeHeavierThan(double limit) {
        for (Iterator<Unit> i = world.iterator(); i.hasNext(); ) {
            if (i.next().getMass() > limit) i.remove();
        }
        removedHeavierThan(limit);
    }

    void removeIfHeavierThan(double limit) {
        boolean any = inside.stream().anyMatch(twin -> twin.alone.getMass() > limit);
        assertEquals(any, world.removeIf(unit -> unit.getMass() > limit));
        removedHeavierThan(limit);
    }

    private void removedHeavierThan(double limit) {
        for (int i = 0; i < inside.size(); ) {
            if (inside.get(i).alone.getMass() > limit) removed(i);
            else i++;
        }
    }

    void clear() {
        world.clear();
        while (!inside.isEmpty()) removed(inside.size() - 1);
    }

    void save() {
        Snapshot snapshot = saves.size() < 3 ? new Snapshot() : saves.remove(0).snapshot;
        world.save(snapshot);
        List<Twin> copies = inside.stream().map(twin -> twin.copy(twin.unit)).collect(Collectors.toList());
        Time now = new Time(tick, waiting, time, dropped, interpolating);
        saves.add(new Save(snapshot, world.stateHash(), copies, integrator, pace, now, lastId, lastSteppedId));
    }

    /** Restores a snapshot with the same unit objects. */
    void restore(int pick) {
        if (saves.isEmpty()) return;
        Save save = saves.get(pick % saves.size());
        world.restore(save.snapshot);
        restored(save, save.inside.stream().map(twin -> twin.unit).collect(Collectors.toList()));
    }

    /** Restores a snapshot from bytes: units that are in the world stay, and a factory creates the others. */
    void load(int pick) {
        if (saves.isEmpty()) return;
        Save save = saves.get(pick % saves.size());
        Map<Long, Unit> here = new HashMap<>();
        for (Twin twin : inside) here.put(twin.id, twin.unit);
        List<Unit> units = new ArrayList<>(), made = new ArrayList<>();
        for (Twin twin : save.inside) {
            Unit unit = here.get(twin.id);
            if (unit == null) {
                unit = new Unit(3);
                made.add(unit);
            }
            units.add(unit);
        }
        Iterator<Unit> factory = made.iterator();
        world.restore(Snapshot.fromBytes(save.snapshot.toBytes()), id -> factory.next());
        assertFalse(factory.hasNext());
        restored(save, units);
    }

    private void restored(Save save, List<Unit> units) {
        Set<Unit> back = Collections.newSetFromMap(new IdentityHashMap<>());
        back.addAll(units);
        outside.removeIf(twin -> back.contains(twin.unit));
        for (Twin twin : inside) {
            if (back.contains(twin.unit)) continue;
            twin.forget();
            outside.add(twin);
        }
        inside.clear();
        for (int i = 0; i < units.size(); i++) inside.add(save.inside.get(i).copy(units.get(i)));
        integrator = save.integrator;
        pace = save.pace;
        lastId = save.lastId;
        lastSteppedId = save.lastSteppedId;
        tick = save.time.tick;
        waiting = save.time.waiting;
        time = save.time.time;
        dropped = save.time.dropped;
        interpolating = save.time.interpolating;
        assertEquals(save.hash, world.stateHash());
    }

    /** Checks that find returns exactly the units of the world. */
    void find(int pick) {
        for (Twin twin : inside) assertSame(twin.unit, world.find(twin.id));
        boolean there = inside.stream().anyMatch(twin -> twin.id == pick);
        assertEquals(there, world.find(pick) != null);
    }

    void setPool(boolean common) {
        world.setPool(common ? ForkJoinPool.commonPool() : null);
    }

    /** Makes invalid calls, which must throw. {@link #compare} checks that they changed nothing. */
    void makeInvalidCalls(int pick) {
        Twin twin = pick(pick);
        Unit unit = twin == null ? new Unit(1) : twin.unit;
        double bad = new double[] {Double.NaN, -1e60, Double.NEGATIVE_INFINITY}[pick % 3];
        List<Runnable> calls = List.of(
                () -> unit.setMass(bad),
                () -> unit.setFriction(bad),
                () -> unit.setMaxSpeed(bad),
                () -> unit.setPosition(1, Double.NaN),
                () -> unit.setVelocity(Double.NaN, 1),
                () -> unit.setMotor(1, 1, bad),
                () -> unit.setMotor(1, Double.NaN, 1),
                () -> unit.applyForce(1, bad),
                () -> unit.applyImpulse(bad, 1),
                () -> unit.integrate(bad),
                () -> unit.getInterpolatedX(bad),
                () -> world.step(bad),
                () -> world.advance(bad),
                () -> world.get(-1),
                () -> world.get(inside.size()),
                () -> world.applyForces(new double[2 * inside.size() + 1], 2),
                () -> world.copyPositions(new float[2 * inside.size() + 1], -1),
                () -> world.restore(new Snapshot()),
                () -> world.add(inside.isEmpty() ? null : inside.get(pick % inside.size()).unit),
                () -> world.units().remove(0),
                () -> world.setIntegrator(null),
                () -> world.setTimestep(null));
        for (Runnable call : calls) assertThrows(RuntimeException.class, call::run);
        if (inside.isEmpty()) return;
        double[] xy = new double[2 * inside.size()];
        xy[xy.length - 1] = bad;
        assertThrows(IllegalArgumentException.class, () -> world.applyForces(xy, 0));
    }

    /** Makes the same change to one of the units, in the world or not, and to its twin. */
    void change(int pick, Consumer<Unit> change) {
        Twin twin = pick(pick);
        if (twin == null) return;
        change.accept(twin.unit);
        change.accept(twin.alone);
    }

    void teleport(int pick, double x, double y) {
        change(pick, u -> u.setPosition(x, y));
        if (pick(pick) != null) pick(pick).settle();
    }

    /** The move is interpolated if the unit took part in the last step and the distance is finite. */
    void moveTo(int pick, double x, double y) {
        Twin twin = pick(pick);
        if (twin == null) return;
        change(pick, u -> u.moveTo(x, y));
        boolean tookPart = inside.contains(twin) && twin.id <= lastSteppedId;
        boolean far = Double.isInfinite(x - twin.previousX) || Double.isInfinite(y - twin.previousY);
        if (far || !tookPart) twin.settle();
    }

    void integrateOne(int pick, double dt, Integrator integrator) {
        Twin twin = pick(pick);
        if (twin == null) return;
        twin.unit.integrate(dt, integrator);
        twin.alone.applyForce(twin.once[0], twin.once[1]);
        twin.once[0] = twin.once[1] = 0;
        twin.alone.integrate(dt, integrator);
        twin.settle();
    }

    void clearForces(int pick) {
        change(pick, Unit::clearForces);
        if (pick(pick) != null) pick(pick).forget();
    }

    void setFrozen(int pick, boolean frozen) {
        Twin twin = pick(pick);
        if (twin == null) return;
        setFrozen(twin, frozen);
    }

    private static void setFrozen(Twin twin, boolean frozen) {
        if (twin.unit.isFrozen() != frozen) twin.forget();
        twin.unit.setFrozen(frozen);
        twin.alone.setFrozen(frozen);
    }

    /** Applies forces to all units in one call, each greater than the one before. */
    void applyForces(double fx, double fy) {
        int offset = inside.size() % 3;
        double[] xy = new double[offset + 2 * inside.size() + 1];
        for (int i = 0; i < inside.size(); i++) {
            xy[offset + 2 * i] = fx * (i + 1);
            xy[offset + 2 * i + 1] = fy * (i % 7);
            inside.get(i).alone.applyForce(xy[offset + 2 * i], xy[offset + 2 * i + 1]);
        }
        world.applyForces(xy, offset);
    }

    private Twin pick(int pick) {
        int n = inside.size() + outside.size();
        if (n == 0) return null;
        int i = pick % n;
        return i < inside.size() ? inside.get(i) : outside.get(i - inside.size());
    }

    void step() {
        world.step();
        stepped(pace.maxStep());
    }

    void step(double dt) {
        world.step(dt);
        stepped(dt);
    }

    private void stepped(double dt) {
        for (Twin twin : inside) twin.step(dt, integrator);
        lastSteppedId = lastId;
        tick++;
        time += dt;
        interpolating = false;
    }

    void advance(long ns) {
        advance(ns, null);
    }

    /** Advances, with random orders before and after each step. */
    void advanceWithOrders(long ns, long seed) {
        advance(ns, new SplittableRandom(seed));
    }

    private void advance(long ns, SplittableRandom orders) {
        double elapsed = ns / 1e9, waited = takes() ? seconds(waiting) : 0;
        if (ns == 0) for (Twin twin : inside) twin.alone.clearForces();
        int steps = pace.isFixed() ? fixedFrame(ns) : variableFrame(elapsed);
        double[] stepped = {0, 0};
        firstBefore = (w, dt) -> {
            assertTrue(dt <= pace.maxStep());
            if (orders != null) orderBefore(orders);
            for (Twin twin : inside) twin.stepInFrame(dt, integrator);
            lastSteppedId = lastId;
            stepped[0]++;
            stepped[1] += dt;
        };
        firstAfter = (w, dt) -> {
            if (orders != null) orderAfter(orders);
        };
        assertEquals(steps, world.advance(elapsed));
        firstBefore = firstAfter = (w, dt) -> {};
        assertEquals(steps, stepped[0]);
        if (!pace.isFixed()) {
            double all = Math.min(waited + elapsed, pace.maxSteps() * pace.maxStep());
            assertEquals(all, stepped[1], 1e-14 * steps * all);
        }
        if (steps > 0) for (Twin twin : inside) twin.frameDone();
        tick += steps;
        time += stepped[1];
        if (steps > 0) interpolating = pace.isFixed();
    }

    private void orderBefore(SplittableRandom random) {
        int pick = random.nextInt(1 << 20);
        order(random.nextInt(10), pick, random);
        if (inside.isEmpty()) return;
        Twin twin = inside.get(pick % inside.size());
        if (random.nextInt(3) == 0) twin.applyOnce(coordinate(random), coordinate(random));
        if (random.nextInt(3) == 0) teleport(pick % inside.size(), coordinate(random), coordinate(random));
    }

    private void orderAfter(SplittableRandom random) {
        int pick = random.nextInt(1 << 20);
        order(random.nextInt(10), pick, random);
        if (inside.isEmpty()) return;
        int i = pick % inside.size();
        if (random.nextInt(2) == 0) moveTo(i, coordinate(random), coordinate(random));
        if (random.nextInt(3) != 0) return;
        double fx = coordinate(random), fy = coordinate(random);
        inside.get(i).applyOnce(fx, fy); // also after the last step of the frame
    }

    private void order(int order, int pick, SplittableRandom random) {
        if (order < 2) remove(pick);
        if (order == 2) add(pick);
        if (order == 3) addNew(1 + random.nextInt(4), random.nextInt(3));
        if (order == 4) setFrozen(pick, random.nextInt(3) == 0);
        if (order == 5) clearForces(pick);
        if (order == 6) {
            double vx = coordinate(random), most = Math.max(0, coordinate(random));
            change(pick, unit -> unit.setMotor(vx, unit.getMotorVx(), most));
        }
        if (order == 7) changeListeners(pick);
    }

    private static double coordinate(SplittableRandom random) {
        return random.nextInt(-1000, 1000) / 8.0;
    }

    private int fixedFrame(long ns) {
        BigInteger before = rounded(waiting), step = SECOND.divide(BigInteger.valueOf(pace.rate()));
        BigInteger all = waiting.add(parts(ns)), due = rounded(all).divide(step), cover = due.multiply(step);
        waiting = all.subtract(cover);
        BigInteger old = before.subtract(cover).max(BigInteger.ZERO), after = rounded(waiting);
        double kept = before.signum() > 0 ? seconds(old) / seconds(before) : 0;
        for (Twin twin : inside) {
            if (due.signum() == 0) twin.hold(ns / 1e9, seconds(after));
            else {
                double now = seconds(cover.subtract(before).add(old)), later = seconds(after.subtract(old));
                twin.spread(kept, now, later, seconds(cover));
            }
        }
        int steps = due.min(BigInteger.valueOf(pace.maxSteps())).intValue();
        dropped += (due.doubleValue() - steps) / pace.rate();
        return steps;
    }

    /** Whether the time that waits becomes part of the next variable frame. Less than a nanosecond waits longer. */
    private boolean takes() {
        return waiting.compareTo(NANOSECOND) >= 0;
    }

    private int variableFrame(double elapsed) {
        boolean taken = takes();
        double before = taken ? seconds(waiting) : 0, covered = before + elapsed;
        double time = Math.min(covered, pace.maxSteps() * pace.maxStep());
        if (taken) waiting = BigInteger.ZERO;
        dropped += covered - time;
        for (Twin twin : inside) {
            if (covered > 0) twin.spread(0, elapsed, 0, covered);
        }
        return (int) Math.min(Math.ceil(time / pace.maxStep()), pace.maxSteps());
    }

    private static BigInteger parts(long ns) {
        return BigInteger.valueOf(ns).multiply(NANOSECOND);
    }

    private static double seconds(BigInteger parts) {
        return new BigDecimal(parts)
                .divide(new BigDecimal(SECOND), MathContext.DECIMAL64)
                .doubleValue();
    }

    /** Fixed steps count time in 1e-9 of a step; this rounds to it. */
    private BigInteger rounded(BigInteger time) {
        BigInteger part = NANOSECOND.divide(BigInteger.valueOf(pace.rate()));
        BigInteger more = time.add(part.divide(BigInteger.TWO));
        return more.subtract(more.mod(part));
    }

    private double alpha() {
        return pace.isFixed() ? Math.min(seconds(rounded(waiting)) * pace.rate(), Math.nextDown(1f)) : 0;
    }

    /** Compares every getter of every unit with the model, to the bit. */
    void compare() {
        assertTrue(due.isEmpty());
        assertEquals(tick, world.getTick());
        assertEquals(time, world.getTime(), 1e-12 * time);
        assertEquals(dropped, world.getDroppedTime(), 1e-12 * dropped);
        assertSame(integrator, world.getIntegrator());
        assertEquals(pace.timestep().toString(), world.getTimestep().toString());
        assertEquals(inside.size(), world.size());
        List<Unit> expected = inside.stream().map(t -> t.unit).collect(Collectors.toList());
        assertEquals(expected, world.units());
        double alpha = world.getAlpha(), drawn = interpolating && pace.isFixed() ? alpha : 1;
        assertEquals(alpha(), alpha, 1.1e-9, "within 1e-9 of a step");
        for (Twin twin : inside) {
            assertSame(world, twin.unit.getWorld());
            assertEquals(twin.id, twin.unit.getId());
            compare(twin);
            same("interpolated x", between(twin.previousX, twin.alone.getX(), drawn), twin.unit.getInterpolatedX());
            same("interpolated y", between(twin.previousY, twin.alone.getY(), drawn), twin.unit.getInterpolatedY());
        }
        comparePositions(drawn);
        compareVelocities();
        for (Twin twin : outside) {
            assertSame(null, twin.unit.getWorld());
            compare(twin);
            same("interpolated x", twin.alone.getX(), twin.unit.getInterpolatedX());
            same("interpolated y", twin.alone.getY(), twin.unit.getInterpolatedY());
        }
    }

    private void comparePositions(double drawn) {
        int size = inside.size();
        float[] floats = new float[2 * size + 1];
        double[] doubles = new double[2 * size + 1];
        world.copyPositions(floats, 1);
        comparePositions(drawn, i -> floats[(int) i], Twins::narrow);
        for (double alpha : ALPHAS) {
            world.copyPositions(floats, 1, alpha);
            comparePositions(alpha, i -> floats[(int) i], Twins::narrow);
            world.copyPositions(doubles, 1, alpha);
            comparePositions(alpha, i -> doubles[(int) i], v -> v);
        }
    }

    private void comparePositions(double alpha, DoubleUnaryOperator copied, DoubleUnaryOperator as) {
        for (int i = 0; i < inside.size(); i++) {
            Twin t = inside.get(i);
            double x = between(t.previousX, t.alone.getX(), alpha), y = between(t.previousY, t.alone.getY(), alpha);
            same("copied x", as.applyAsDouble(x), copied.applyAsDouble(2 * i + 1));
            same("copied y", as.applyAsDouble(y), copied.applyAsDouble(2 * i + 2));
        }
    }

    private void compareVelocities() {
        double[] xy = new double[2 * inside.size() + 1];
        world.copyVelocities(xy, 1);
        for (int i = 0; i < inside.size(); i++) {
            same("copied vx", inside.get(i).alone.getVx(), xy[2 * i + 1]);
            same("copied vy", inside.get(i).alone.getVy(), xy[2 * i + 2]);
        }
    }

    private static void compare(Twin twin) {
        Unit a = twin.alone, u = twin.unit;
        same("x", a.getX(), u.getX());
        same("y", a.getY(), u.getY());
        same("vx", a.getVx(), u.getVx());
        same("vy", a.getVy(), u.getVy());
        same("speed", a.getSpeed(), u.getSpeed());
        same("fx", a.getFx() + twin.once[0], u.getFx());
        same("fy", a.getFy() + twin.once[1], u.getFy());
        same("mass", a.getMass(), u.getMass());
        same("friction", a.getFriction(), u.getFriction());
        same("maxSpeed", a.getMaxSpeed(), u.getMaxSpeed());
        same("motorVx", a.getMotorVx(), u.getMotorVx());
        same("motorVy", a.getMotorVy(), u.getMotorVy());
        same("motorForce", a.getMotorForce(), u.getMotorForce());
        assertEquals(a.isFrozen(), u.isFrozen());
        twin.comparePending();
        for (double alpha : ALPHAS) {
            same("x at an alpha", between(twin.previousX, a.getX(), alpha), u.getInterpolatedX(alpha));
            same("y at an alpha", between(twin.previousY, a.getY(), alpha), u.getInterpolatedY(alpha));
        }
    }

    private static double between(double previous, double next, double alpha) {
        return alpha == 1 ? next : previous + (next - previous) * alpha;
    }

    private static double narrow(double v) {
        float f = (float) v;
        return Float.isInfinite(f) ? Math.copySign(Float.MAX_VALUE, v) : f;
    }

    private static void same(String what, double expected, double actual) {
        if (Double.doubleToRawLongBits(expected) != Double.doubleToRawLongBits(actual)) {
            throw new AssertionError(what + ": alone " + expected + ", in the world " + actual);
        }
    }

    @Override
    public String toString() {
        return inside.size() + " units in a world, " + outside.size() + " outside, tick " + tick;
    }
}
