package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleToIntFunction;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.StepListener;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** What docs/cookbook.md says of its recipes beyond what each prints: for all speeds, masses, steps and integrators. */
class CookbookPropertyTest {
    @Provide
    Arbitrary<Double> positive() {
        return Doubles.logUniform(1e-6, 1e6);
    }

    @Provide
    Arbitrary<Double> frictions() {
        return Arbitraries.oneOf(Doubles.logUniform(1e-6, 1e6), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> anySpeed() {
        return Doubles.signedLogUniform(1e-140, 1e140);
    }

    @Provide
    Arbitrary<Double> stiffness() {
        return Doubles.logUniform(0.05, 1e3);
    }

    /** A rule that slows a unit after a step. */
    private interface Damping {
        void slow(Unit unit, double dt);
    }

    private static Damping dry(double muG) {
        return (unit, dt) -> {
            double speed = unit.getSpeed();
            if (speed == 0) return;
            double factor = Math.max(0, 1 - muG * dt / speed);
            unit.setVelocity(factor * unit.getVx(), factor * unit.getVy());
        };
    }

    private static Damping grip(double heading, double rate) {
        return (unit, dt) -> {
            double hx = StrictMath.cos(heading), hy = StrictMath.sin(heading);
            double k = StrictMath.exp(-rate * dt);
            double along = (1 - k) * (unit.getVx() * hx + unit.getVy() * hy);
            unit.setVelocity(k * unit.getVx() + along * hx, k * unit.getVy() + along * hy);
        };
    }

    private static Damping quadratic(double c) {
        return (unit, dt) -> {
            double factor = 1 / (1 + c * unit.getSpeed() * dt / unit.getMass());
            unit.setVelocity(factor * unit.getVx(), factor * unit.getVy());
        };
    }

    private static World world(Unit unit, Integrator integrator, StepListener before, StepListener after) {
        World world = new World(integrator, Timestep.fixed(60));
        world.add(unit);
        world.addBeforeStep(before);
        world.addAfterStep(after);
        return world;
    }

    private static final StepListener NOTHING = (world, dt) -> {};

    private static World damped(Unit unit, Integrator integrator, Damping damping) {
        return world(unit, integrator, NOTHING, (w, dt) -> damping.slow(unit, dt));
    }

    // Other frictions

    @Property
    void dryFrictionAndQuadraticDragTurnNoUnitRoundAndMakeNoneFaster(
            @ForAll Integrator integrator,
            @ForAll boolean isDry,
            @ForAll("positive") double mass,
            @ForAll("frictions") double friction,
            @ForAll("positive") double strength,
            @ForAll("positive") double dt,
            @ForAll("anySpeed") double vx,
            @ForAll("anySpeed") double vy) {
        Unit unit = new Unit(mass).setFriction(friction).setVelocity(vx, vy);
        World world = damped(unit, integrator, isDry ? dry(strength) : quadratic(strength));
        for (int i = 0; i < 20; i++) {
            double x = unit.getVx(), y = unit.getVy();
            world.step(dt);
            assertTrue(unit.getVx() * x >= 0 && Math.abs(unit.getVx()) <= Math.abs(x), x + " to " + unit.getVx());
            assertTrue(unit.getVy() * y >= 0 && Math.abs(unit.getVy()) <= Math.abs(y), y + " to " + unit.getVy());
        }
    }

    /** v − n·µ·g·dt until it stands, after v/(µ·g) to within a step, and v²/(2·µ·g) + v·dt/2 away but for (µ·g·dt²)/8. */
    @Property
    void dryFrictionTakesTheSameFromTheSpeedInEachSecond(
            @ForAll Integrator integrator,
            @ForAll("positive") double muG,
            @ForAll("positive") double dt,
            @ForAll @DoubleRange(min = 0.1, max = 200) double steps) {
        double v = steps * muG * dt;
        Unit unit = new Unit(1).setVelocity(0.6 * v, 0.8 * v);
        World world = damped(unit, integrator, dry(muG));
        for (int n = 1; n <= Math.ceil(steps) + 1; n++) {
            world.step(dt);
            assertEquals(Math.max(0, v - n * muG * dt), unit.getSpeed(), 1e-12 * v);
        }
        assertEquals(0, unit.getSpeed());
        double way = Math.hypot(unit.getX(), unit.getY());
        assertEquals(v * v / (2 * muG) + v * dt / 2, way, muG * dt * dt / 8 + 1e-12 * way);
    }

    @Property
    void dryFrictionHoldsWhatStandsAgainstAWeakPushAndNotAgainstAStrongOne(
            @ForAll Integrator integrator,
            @ForAll("positive") double muG,
            @ForAll @DoubleRange(min = 0, max = 3) double share,
            @ForAll @IntRange(min = 20, max = 300) int framesPerSecond) {
        Assume.that(Math.abs(share - 1) > 1e-3);
        double mass = 40, force = share * muG * mass;
        Unit unit = new Unit(mass);
        StepListener hold = (w, dt) -> {
            double fx = unit.getFx(), fy = unit.getFy();
            boolean holds = Math.sqrt(fx * fx + fy * fy) <= muG * unit.getMass();
            if (holds && unit.getSpeed() == 0) unit.applyForce(-fx, -fy);
        };
        World world = world(unit, integrator, hold, (w, dt) -> dry(muG).slow(unit, dt));
        for (int frame = 0; frame < framesPerSecond; frame++) {
            unit.applyForce(0.6 * force, -0.8 * force);
            world.advance(1.0 / framesPerSecond);
        }
        if (share < 1) assertArrayEquals(new double[] {0, 0}, new double[] {unit.getX(), unit.getSpeed()});
        else assertTrue(unit.getSpeed() > 0.9 * (share - 1) * muG * (1 - 2 / 60.0 - 1.0 / framesPerSecond));
    }

    /** Along the heading it rolls on, across it slides for e^−rt; and the library's friction before or after is the same. */
    @Property
    void gripKeepsTheMotionAlongTheHeadingAndTheOrderOfFrictionsDoesNotMatter(
            @ForAll Integrator integrator,
            @ForAll @DoubleRange(min = -4, max = 4) double heading,
            @ForAll("frictions") double rate,
            @ForAll("frictions") double friction,
            @ForAll("positive") double dt,
            @ForAll @DoubleRange(min = -100, max = 100) double vx,
            @ForAll @DoubleRange(min = -100, max = 100) double vy) {
        double hx = StrictMath.cos(heading), hy = StrictMath.sin(heading), k = StrictMath.exp(-rate * dt);
        Unit gripped = new Unit(1).setVelocity(vx, vy);
        grip(heading, rate).slow(gripped, dt);
        double x = gripped.getVx(), y = gripped.getVy(), slack = 1e-13 * Math.hypot(vx, vy);
        assertEquals(vx * hx + vy * hy, x * hx + y * hy, slack);
        assertEquals(k * (vy * hx - vx * hy), y * hx - x * hy, slack);
        assertTrue(Math.hypot(x, y) <= Math.hypot(vx, vy) + slack);

        Unit before = new Unit(1).setFriction(friction).setVelocity(x, y);
        before.integrate(dt, integrator);
        Unit after = new Unit(1).setFriction(friction).setVelocity(vx, vy);
        after.integrate(dt, integrator);
        grip(heading, rate).slow(after, dt);
        assertEquals(before.getVx(), after.getVx(), slack);
        assertEquals(before.getVy(), after.getVy(), slack);
    }

    /** For dry friction and drag it does, but by no more than in proportion to dt: half of it in steps half as long. */
    @Property(tries = 100)
    void theOrderOfOtherFrictionsMattersInProportionToDt(
            @ForAll Integrator integrator,
            @ForAll boolean isDry,
            @ForAll @DoubleRange(min = 1, max = 3) double friction) {
        double coarse = difference(integrator, isDry, friction, 64),
                fine = difference(integrator, isDry, friction, 128);
        assertNotEquals(0, fine);
        assertEquals(2, coarse / fine, 0.2);
    }

    private static double difference(Integrator integrator, boolean isDry, double friction, int steps) {
        Damping damping = isDry ? dry(2) : quadratic(1);
        Unit before = new Unit(1).setFriction(friction).setVelocity(20, 0);
        Unit after = new Unit(1).setFriction(friction).setVelocity(20, 0);
        for (int i = 0; i < steps; i++) {
            damping.slow(before, 1.0 / steps);
            before.integrate(1.0 / steps, integrator);
            after.integrate(1.0 / steps, integrator);
            damping.slow(after, 1.0 / steps);
        }
        return before.getVx() - after.getVx();
    }

    @Property(tries = 300)
    void fromRestADampingBeforeTheStepLeadsAlongTheSamePathAsOneAfterIt(
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 0, max = 2) int which,
            @ForAll("positive") double strength,
            @ForAll("frictions") double friction,
            @ForAll @DoubleRange(min = -1000, max = 1000) double force) {
        Damping damping = which == 0 ? dry(strength) : which == 1 ? quadratic(strength) : grip(1, strength);
        Unit early = new Unit(3).setFriction(friction), late = new Unit(3).setFriction(friction);
        World before = world(
                early,
                integrator,
                (w, dt) -> {
                    damping.slow(early, dt);
                    early.applyForce(force, force * w.getTick());
                },
                NOTHING);
        World after = world(
                late,
                integrator,
                (w, dt) -> late.applyForce(force, force * w.getTick()),
                (w, dt) -> damping.slow(late, dt));
        for (int i = 0; i < 30; i++) {
            before.step();
            after.step();
            assertEquals(early.getX(), late.getX());
            assertEquals(early.getY(), late.getY());
        }
    }

    @Property
    void quadraticDragIsExactForAUnitThatCoasts(
            @ForAll Integrator integrator,
            @ForAll("positive") double mass,
            @ForAll("positive") double c,
            @ForAll("positive") double v,
            @ForAll("positive") double dt) {
        Unit unit = new Unit(mass).setVelocity(0, -v);
        World world = damped(unit, integrator, quadratic(c));
        for (int n = 1; n <= 100; n++) {
            world.step(dt);
            assertEquals(1, unit.getSpeed() / (v / (1 + c * v * n * dt / mass)), 1e-13 * n + 1e-13);
        }
    }

    @Property(tries = 300)
    void drivenAgainstQuadraticDragAUnitSettlesBelowTheRootOfForceOverDragAndNeverPassesIt(
            @ForAll Integrator integrator,
            @ForAll("positive") double mass,
            @ForAll("positive") double root,
            @ForAll("positive") double dt,
            @ForAll @DoubleRange(min = 0.05, max = 100) double push) {
        double force = push * root * mass / dt, c = force / (root * root); // a step's push is so many times the root
        Unit unit = new Unit(mass);
        World world = damped(unit, integrator, quadratic(c));
        for (int i = 0; i < 2000; i++) {
            unit.applyForce(force, 0);
            world.step(dt);
            assertTrue(unit.getVx() <= root * (1 + 1e-13), unit.getVx() + " past " + root);
        }
        double half = force * dt / (2 * mass);
        assertEquals(1, unit.getVx() / (force / c / (Math.sqrt(force / c + half * half) + half)), 1e-9);
        assertTrue(root - unit.getVx() <= half);
    }

    // Forces

    @Property
    void aShellFliesThePhysicsBooksParabolaAtEveryTickRate(
            @ForAll boolean exact,
            @ForAll @IntRange(min = 1, max = 500) int rate,
            @ForAll @DoubleRange(min = -100, max = 100) double vx,
            @ForAll @DoubleRange(min = -100, max = 100) double vy) {
        World world = new World(exact ? Integrator.EXACT : Integrator.MIDPOINT, Timestep.fixed(rate));
        Unit shell = world.add(new Unit(10).setVelocity(vx, vy));
        world.addBeforeStep((w, dt) -> shell.applyForce(0, -shell.getMass() * 9.81));
        for (int tick = 0; tick < 3 * rate; tick++) world.step();
        assertEquals(3 * vx, shell.getX(), 1e-9);
        assertEquals(3 * vy - 9.81 * 9 / 2, shell.getY(), 1e-9);
    }

    /** Of docs/physics.md: a spring in a listener calms down if f > lag(z)·k·dt, and its swings grow if f is less. */
    @Property(tries = 300)
    void aSpringCalmsDownIfFrictionIsAboveLagTimesStiffnessTimesDt(
            @ForAll Integrator integrator,
            @ForAll("stiffness") double z,
            @ForAll("positive") double mass,
            @ForAll @DoubleRange(min = 0.1, max = 3) double share) {
        Assume.that(Math.abs(share - 1) > 0.05);
        double dt = 1 / 64.0, friction = z * mass / dt, lag = lag(integrator, z), most = 4 * mass + 2 * friction * dt;
        double k = lag > 0 ? share * friction / (lag * dt) : share / 3 * 0.99 * most / (dt * dt);
        boolean calms = lag == 0 || share < 1;
        Assume.that(!calms || k * dt * dt < 0.99 * most);
        Unit bob = new Unit(mass).setFriction(friction).setPosition(1, 0);
        World world = world(bob, integrator, (w, h) -> bob.applyForce(-k * bob.getX(), 0), NOTHING);
        double farthest = 0;
        for (int tick = 0; tick < 8_000; tick++) {
            world.step(dt);
            if (!calms && Math.abs(bob.getX()) > 100) return;
            if (tick >= 7_900) farthest = Math.max(farthest, Math.abs(bob.getX()));
        }
        assertTrue(calms && farthest < 1e-3, farthest + " m");
    }

    private static double lag(Integrator integrator, double z) {
        switch (integrator) {
            case EULER:
                return 1;
            case SEMI_IMPLICIT:
                return 0;
            case MIDPOINT:
                return 0.5;
            default:
                return 1 / z - 1 / Math.expm1(z);
        }
    }

    /** No swing is longer than 1/√(1 − k·dt²/(4·m)) times the first one. */
    @Property(tries = 300)
    void withoutFrictionSemiImplicitAddsNoEnergyToASpring(
            @ForAll("positive") double mass, @ForAll @DoubleRange(min = 0.01, max = 3.99) double stiffness) {
        double dt = 1 / 64.0, k = stiffness * mass / (dt * dt);
        Unit bob = new Unit(mass).setPosition(1, 0);
        World world = world(bob, Integrator.SEMI_IMPLICIT, (w, h) -> bob.applyForce(-k * bob.getX(), 0), NOTHING);
        for (int tick = 0; tick < 5_000; tick++) {
            world.step(dt);
            assertTrue(Math.abs(bob.getX()) <= (1 + 1e-9) / Math.sqrt(1 - stiffness / 4), bob.toString());
        }
    }

    @Property(tries = 300)
    void onABeltAUnitTendsToForceOverFrictionPlusTheBeltsSpeed(
            @ForAll Integrator integrator,
            @ForAll("stiffness") double z,
            @ForAll("positive") double friction,
            @ForAll @DoubleRange(min = -50, max = 50) double belt,
            @ForAll @DoubleRange(min = -50, max = 50) double alone) {
        Unit unit = new Unit(friction / z).setFriction(friction); // of a step of 1 s
        for (int i = 0; i < 2000; i++) {
            unit.applyForce(friction * alone + unit.getFriction() * belt, 0);
            unit.integrate(1, integrator);
        }
        assertEquals(alone + belt, unit.getVx(), 1e-10);
    }

    @Property
    void aBlastThrowsOutwardsByAtMostItsImpulseAndNothingInItsCentreBreaksIt(
            @ForAll("offsets") double dx, @ForAll("offsets") double dy, @ForAll("positive") double j) {
        double radius = 10, mass = 3;
        Unit unit = new Unit(mass);
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance > 0 && distance < radius) {
            double impulse = j * (1 - distance / radius) / distance;
            unit.applyImpulse(impulse * dx, impulse * dy);
            assertEquals(j / mass * (1 - distance / radius), unit.getSpeed(), 1e-12 * j / mass);
            assertTrue(unit.getVx() * dx >= 0 && unit.getVy() * dy >= 0, unit.toString());
        }
        assertTrue(unit.getSpeed() <= j / mass * (1 + 1e-15));
    }

    /** As close as numbers go whose squares are still normal ones; and the centre itself. */
    @Provide
    Arbitrary<Double> offsets() {
        return Arbitraries.oneOf(Doubles.signedLogUniform(1e-150, 20), Arbitraries.just(0.0));
    }

    @Property(tries = 300)
    void aThrownUnitComesBackToItsTopSpeedHoweverStrongItsEngine(
            @ForAll Integrator integrator,
            @ForAll("frictions") double friction,
            @ForAll("positive") double force,
            @ForAll @DoubleRange(min = 0, max = 100) double thrown) {
        double top = 15, sink = 20;
        Unit tank = new Unit(50).setFriction(friction).setMaxSpeed(top);
        World world = world(tank, integrator, (w, dt) -> tank.applyForce(force, -force), (w, dt) -> {
            if (tank.getMaxSpeed() > top) tank.setMaxSpeed(Math.max(top, tank.getMaxSpeed() - sink * dt));
        });
        tank.setMaxSpeed(Double.POSITIVE_INFINITY).applyImpulse(50 * thrown, 0);
        tank.setMaxSpeed(Math.max(top, tank.getSpeed()));
        assertEquals(thrown, tank.getSpeed(), 1e-12);
        for (int tick = 1; tick <= 6 * 60; tick++) {
            world.step();
            assertTrue(tank.getSpeed() <= Math.max(top, thrown - sink * tick / 60.0) + 1e-9, tank.toString());
        }
        assertEquals(top, tank.getMaxSpeed());
    }

    // Groups

    private static void arrive(Unit tank, double goalX, double goalY, double cruise, double dt) {
        double dx = goalX - tank.getX(), dy = goalY - tank.getY(), distance = Math.sqrt(dx * dx + dy * dy);
        double perMetre = 1 / (4 * (tank.getMass() / tank.getFriction() + dt));
        double push = tank.getFriction() * Math.min(perMetre, cruise / distance);
        tank.applyForce(push * dx, push * dy);
    }

    @Property(tries = 300)
    void arrivalGetsToTheGoalAndNeverPastItNorBack(
            @ForAll Integrator integrator,
            @ForAll("stiffness") double z,
            @ForAll("positive") double mass,
            @ForAll("positive") double cruise,
            @ForAll @DoubleRange(min = 0.01, max = 100) double far,
            @ForAll @DoubleRange(min = -4, max = 4) double bearing) {
        double dt = 1 / 64.0, friction = z * mass / dt, start = far * cruise * (mass / friction + dt);
        Unit tank = new Unit(mass).setFriction(friction);
        World world = world(
                tank,
                integrator,
                (w, h) -> arrive(tank, start * Math.cos(bearing), start * Math.sin(bearing), cruise, h),
                NOTHING);
        double gone = 0;
        for (int tick = 0; tick < 4_000; tick++) {
            world.step(dt);
            double next = tank.getX() * Math.cos(bearing) + tank.getY() * Math.sin(bearing);
            assertTrue(next >= gone - 1e-12 * start, "back from " + gone + " to " + next);
            assertTrue(next <= start * (1 + 1e-12), "past " + start + " at " + next);
            assertTrue(tank.getSpeed() <= cruise * (1 + 1e-12), "no faster than it cruises");
            gone = next;
        }
        assertEquals(start, gone, 1e-9 * start);
        assertEquals(0, tank.getX() * Math.sin(bearing) - tank.getY() * Math.cos(bearing), 1e-9 * start);
    }

    @Property
    void theGridFindsEachPairThatIsNearOnceOnTheMapAndOffIt(
            @ForAll long seed,
            @ForAll @IntRange(min = 0, max = 300) int n,
            @ForAll @IntRange(min = 1, max = 40) int cells) {
        double reach = 4;
        Random random = new Random(seed);
        double[] x = new double[n], y = new double[n];
        for (int i = 0; i < n; i++) {
            x[i] = reach * cells * (1.5 * random.nextDouble() - 0.25);
            y[i] = reach * cells * (1.5 * random.nextDouble() - 0.25);
            if (random.nextInt(4) == 0) y[i] = reach * Math.rint(y[i] / reach); // on the edge of a cell
        }
        Set<Long> found = new TreeSet<>(), near = new TreeSet<>();
        int side = cells + 2;
        int[] around = {-side - 1, -side, -side + 1, -1, 0, 1, side - 1, side, side + 1};
        DoubleToIntFunction cell = v -> (int) Math.max(1, Math.min(side - 2, 1 + v / reach));
        int[] head = new int[side * side], next = new int[n];
        Arrays.fill(head, -1);
        for (int i = 0; i < n; i++) {
            int home = side * cell.applyAsInt(y[i]) + cell.applyAsInt(x[i]);
            for (int step : around) {
                for (int j = head[home + step]; j >= 0; j = next[j]) {
                    if (Math.hypot(x[i] - x[j], y[i] - y[j]) < reach) assertTrue(found.add(1000L * i + j), "twice");
                }
            }
            next[i] = head[home];
            head[home] = i;
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) if (Math.hypot(x[i] - x[j], y[i] - y[j]) < reach) near.add(1000L * i + j);
        }
        assertEquals(near, found);
    }

    @Property
    void theShorterWayRoundAMapIsAtMostHalfOfItsWidth(
            @ForAll @DoubleRange(min = 1, max = 1e4) double width,
            @ForAll @DoubleRange(min = 0, max = 1) double from,
            @ForAll @DoubleRange(min = 0, max = 1) double to) {
        double d = width * to - width * from, shortest = d - width * Math.rint(d / width);
        assertTrue(Math.abs(shortest) <= width / 2 + 1e-9);
        assertEquals(0, Math.abs(Math.IEEEremainder(from * width + shortest - to * width, width)), 1e-9);
    }

    // Moving units about, of docs/limits.md and docs/guide.md

    /** By moveTo after the step: drawn from the start of the step to the wall, never beyond it, and sliding along it. */
    @Property
    void aUnitIsNeverDrawnBeyondAWall(
            @ForAll Integrator integrator,
            @ForAll @DoubleRange(min = 1, max = 1000) double vx,
            @ForAll @DoubleRange(min = -1000, max = 1000) double vy,
            @ForAll @IntRange(min = 10, max = 500) int framesPerSecond) {
        Unit unit = new Unit(1).setVelocity(vx, vy);
        double[] start = {0};
        World world = world(unit, integrator, (w, dt) -> start[0] = unit.getX(), (w, dt) -> {
            if (unit.getX() > 10) unit.moveTo(10, unit.getY()).setVelocity(0, unit.getVy());
        });
        double drawn = 0;
        while (world.getTick() < 600 / vx + 4) {
            world.advance(1.0 / framesPerSecond);
            double x = unit.getInterpolatedX();
            assertTrue(x >= drawn && x <= 10, "drawn at " + x + " after " + drawn);
            assertEquals(start[0] + world.getAlpha() * (unit.getX() - start[0]), x, 1e-12);
            drawn = x;
        }
        assertEquals(10, drawn);
        assertEquals(vy * world.getTime(), unit.getY(), 1e-9 * Math.abs(vy) * world.getTime());
    }

    /** By setPosition before the step: between two frames, a unit is drawn as far on as it has gone, on the way round. */
    @Property
    void acrossTheEdgeOfAMapAUnitIsDrawnWithoutAStreakOrAJump(
            @ForAll @DoubleRange(min = -300, max = 300) double v,
            @ForAll @IntRange(min = 10, max = 500) int framesPerSecond) {
        double width = 100;
        Unit ship = new Unit(1).setPosition(50, 0).setVelocity(v, 0);
        World world = world(
                ship,
                Integrator.EXACT,
                (w, dt) -> {
                    if (ship.getX() >= width) ship.setPosition(ship.getX() - width, ship.getY());
                    if (ship.getX() < 0) ship.setPosition(ship.getX() + width, ship.getY());
                },
                NOTHING);
        double drawn = Double.NaN;
        for (int frame = 0; frame < 3 * framesPerSecond; frame++) {
            world.advance(1.0 / framesPerSecond);
            if (world.getTick() == 0) continue; // there is no step yet that could be drawn
            double x = ship.getInterpolatedX(), gone = Math.IEEEremainder(x - drawn, width);
            if (!Double.isNaN(drawn)) assertEquals(0, Math.IEEEremainder(gone - v / framesPerSecond, width), 1e-6);
            assertTrue(x > -Math.abs(v) / 60 - 1e-9 && x < width + Math.abs(v) / 60 + 1e-9, "far off: " + x);
            drawn = x;
        }
    }

    /** The waiting time stays the same, in seconds; alpha is the part of a new step, and so the picture may jump. */
    @Property
    void onAChangeOfTheTimestepThePictureJumpsByLessThanAStep(
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 1, max = 240) int from,
            @ForAll @IntRange(min = 1, max = 240) int to,
            @ForAll @DoubleRange(min = 0, max = 0.99) double alpha) {
        Unit unit = new Unit(1).setVelocity(10, 0);
        World world = world(unit, integrator, NOTHING, NOTHING);
        world.setTimestep(Timestep.fixed(from));
        world.advance((1 + alpha) / from);
        double old = world.getAlpha(), drawn = unit.getInterpolatedX(), step = 10.0 / from;
        world.setTimestep(Timestep.fixed(to));
        assertEquals(Math.min(1, old * to / from), world.getAlpha(), 1e-6);
        double jump = unit.getInterpolatedX() - drawn;
        assertEquals(step * (world.getAlpha() - old), jump, 1e-9 * step);
        assertTrue(Math.abs(jump) < step && (to >= from ? jump >= -1e-9 * step : jump <= 1e-9 * step), jump + " m");
    }

    // Time

    @Property(tries = 200)
    void aGameThatRunsFasterOrSlowerGoesTheSameWaysToTheBit(
            @ForAll Integrator integrator, @ForAll @DoubleRange(min = 0.05, max = 20) double speed) {
        World normal = played(integrator), other = played(integrator);
        while (other.getTick() < 600) other.advance(speed / 60);
        while (normal.getTick() < other.getTick()) normal.step();
        assertEquals(0, other.getDroppedTime());
        for (int i = 0; i < normal.size(); i++) {
            assertEquals(normal.get(i).getX(), other.get(i).getX());
            assertEquals(normal.get(i).getVy(), other.get(i).getVy());
        }
        double x = other.get(0).getInterpolatedX();
        other.get(0).applyForce(1e6, 1e6);
        assertEquals(0, other.advance(0), "a pause");
        assertEquals(x, other.get(0).getInterpolatedX());
        assertEquals(0, other.get(0).getFx());
    }

    private static World played(Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(60).withMaxSteps(100));
        for (int i = 1; i < 5; i++) world.add(new Unit(i).setFriction(3).setPosition(i, -i));
        world.addBeforeStep((w, dt) -> {
            for (Unit unit : w) unit.applyForce(9 - unit.getX(), unit.getVx());
        });
        return world;
    }

    @Property(tries = 200)
    void aWorldThatWasEmptiedByItsSnapshotPlaysAsANewOne(
            @ForAll long seed, @ForAll @IntRange(min = 0, max = 99) int old) {
        World used = new World(Integrator.EXACT, Timestep.fixed(60)),
                fresh = new World(Integrator.EXACT, Timestep.fixed(60));
        Snapshot empty = used.save();
        play(used, new Random(old), old);
        used.restore(empty);
        assertEquals(0, used.size());
        play(used, new Random(seed), 60);
        play(fresh, new Random(seed), 60);
        assertEquals(fresh.stateHash(), used.stateHash(), () -> fresh.save().difference(used.save()));
    }

    private static void play(World world, Random random, int frames) {
        for (int frame = 0; frame < frames; frame++) {
            world.add(new Unit(1 + random.nextDouble())).applyForce(random.nextDouble(), 1);
            if (random.nextInt(3) == 0) world.remove(world.get(random.nextInt(world.size())));
            world.advance(random.nextDouble() / 2);
        }
    }

    // Threads

    /** Ten thousand frames on their way to another thread. All units of a frame have been copied in the same tick. */
    @Property(tries = 5)
    void theThreadThatDrawsSeesWholeFramesInOrder(@ForAll @IntRange(min = 1, max = 2000) int units)
            throws InterruptedException {
        int ticks = 10_000;
        World world = new World(Integrator.EXACT, Timestep.fixed(64));
        for (int i = 0; i < units; i++) world.add(new Unit(1).setVelocity(64, 64));
        float[][] buffers = new float[3][2 * world.size()];
        AtomicInteger between = new AtomicInteger(2);
        int fresh = 4;
        Thread simulation = new Thread(() -> {
            int mine = 0;
            for (int tick = 0; tick < ticks; tick++) {
                world.step();
                world.copyPositions(buffers[mine], 0);
                mine = between.getAndSet(mine | fresh) & 3;
            }
        });
        simulation.start();
        int drawn = 1;
        float last = 0;
        while (last < ticks) {
            boolean over = !simulation.isAlive();
            if ((between.get() & fresh) != 0) drawn = between.getAndSet(drawn) & 3;
            float x = buffers[drawn][0];
            for (float other : buffers[drawn]) assertEquals(x, other, "a frame of two ticks");
            assertTrue(x >= last, () -> "back");
            assertTrue(x == ticks || !over, "the last frame is there");
            last = x;
        }
        simulation.join();
    }
}
