package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.Combinators;
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

/** The claims of docs/cookbook.md that its code blocks do not show: all speeds, masses, steps and integrators. */
class CookbookPropertyTest {
    @Provide
    Arbitrary<Double> positive() {
        return Doubles.logUniform(1e-6, 1e6);
    }

    @Provide
    Arbitrary<Double> stiffness() {
        return Doubles.logUniform(0.05, 1e3);
    }

    private static World world(Unit unit, Integrator integrator, StepListener before, StepListener after) {
        World world = new World(integrator, Timestep.fixed(60));
        world.add(unit);
        world.addBeforeStep(before);
        world.addAfterStep(after);
        return world;
    }

    private static final StepListener NOTHING = (world, dt) -> {};

    // Motors

    @Provide
    Arbitrary<Double> accelerations() {
        return Doubles.logUniform(0.5, 20);
    }

    private static boolean brakes(Unit unit, double ux, double uy) {
        double vx = unit.getVx(), vy = unit.getVy();
        return (ux - vx) * vx + (uy - vy) * vy < 0;
    }

    /** By a·dt or b·dt in each step, in any direction; then the velocity stays exactly the ordered one. */
    @Property
    void theEngineChangesTheSpeedByAPerSecondAndTheBrakeByBUntilItIsTheOrderedSpeed(
            @ForAll Integrator integrator,
            @ForAll("positive") double mass,
            @ForAll("accelerations") double a,
            @ForAll("accelerations") double b,
            @ForAll @IntRange(min = 1, max = 1000) int rate,
            @ForAll @DoubleRange(min = 0, max = 50) double from,
            @ForAll @DoubleRange(min = 0, max = 50) double to,
            @ForAll @DoubleRange(min = -4, max = 4) double bearing) {
        double hx = Math.cos(bearing), hy = Math.sin(bearing), ux = to * hx, uy = to * hy, dt = 1.0 / rate;
        Unit tank = new Unit(mass).setVelocity(from * hx, from * hy);
        World world = world(
                tank,
                integrator,
                (w, h) -> tank.setMotor(ux, uy, tank.getMass() * (brakes(tank, ux, uy) ? b : a)),
                NOTHING);
        double change = (to > from ? a : -b) * dt, steps = Math.ceil((to - from) / change);
        for (int n = 1; n < steps; n++) {
            world.step(dt);
            assertEquals(from + n * change, tank.getSpeed(), 1e-11 * (from + to), "after step " + n);
        }
        for (int i = 0; i < 10; i++) {
            world.step(dt);
            if (i > 0) assertArrayEquals(new double[] {ux + 0.0, uy + 0.0}, new double[] {tank.getVx(), tank.getVy()});
        }
    }

    /** A drive to a goal. Slowing is f/m in 1/s; a and b are the accelerations by engine and brake in m/s². */
    private record Trip(
            Integrator integrator,
            int rate,
            double slowing,
            double top,
            double a,
            double b,
            double distance,
            double bearing) {
        Unit tank(double speed, double heading) {
            return new Unit(40)
                    .setFriction(40 * slowing)
                    .setVelocity(speed * Math.cos(heading), speed * Math.sin(heading));
        }

        double lag() {
            return CookbookPropertyTest.lag(integrator, slowing / rate);
        }

        /** The stopping distance of a unit that brakes by b·dt in each step, from the next step on. */
        double stopping(double speed) {
            double way = lag() * speed;
            for (double v = speed - b / rate; v > 0; v -= b / rate) way += v;
            return way / rate;
        }

        /** Drives until the unit has been at rest for ten steps. Returns how often it passed the goal. */
        int passes(Unit tank) {
            double hx = Math.cos(bearing), hy = Math.sin(bearing), goalX = distance * hx, goalY = distance * hy;
            World world = new World(integrator, Timestep.fixed(rate));
            world.add(tank);
            world.addBeforeStep((w, dt) -> arrive(tank, goalX, goalY, top, a, b, lag(), dt));
            double limit = 3 * rate * (200 + distance / top + top / a + top / b), side = -1;
            int passes = 0;
            for (int rests = 0; rests < 10; ) {
                double x = tank.getX(), y = tank.getY();
                world.step();
                double past = tank.getX() * hx + tank.getY() * hy - distance;
                if (past * side < -1e-9) {
                    side = -side;
                    passes++;
                }
                rests = tank.getSpeed() == 0 && tank.getX() == x && tank.getY() == y ? rests + 1 : 0;
                assertTrue(world.getTick() < limit, () -> "no rest: " + tank);
            }
            assertEquals(goalX, tank.getX(), 5e-10);
            assertEquals(goalY, tank.getY(), 5e-10);
            return passes;
        }
    }

    private static void arrive(
            Unit tank, double goalX, double goalY, double top, double a, double b, double lag, double dt) {
        double vx = tank.getVx(), vy = tank.getVy();
        double dx = goalX - tank.getX() - lag * dt * vx, dy = goalY - tank.getY() - lag * dt * vy;
        double left = Math.sqrt(dx * dx + dy * dy), ux = 0, uy = 0;
        if (left > 1e-10) {
            double n = Math.ceil((Math.sqrt(1 + 8 * left / (b * dt * dt)) - 1) / 2 - 1e-12);
            double u = Math.min(2 * left / ((1 + Math.max(1, n)) * dt), top);
            ux = u * dx / left;
            uy = u * dy / left;
        }
        boolean brakes = brakes(tank, ux, uy) || (ux == 0 && uy == 0);
        double friction = tank.getFriction() * Math.max(tank.getSpeed(), Math.sqrt(ux * ux + uy * uy));
        tank.setMotor(ux, uy, tank.getMass() * (brakes ? b : a) + friction);
    }

    @Provide
    Arbitrary<Trip> trips() {
        Arbitrary<Double> slowing = Arbitraries.oneOf(Arbitraries.just(0.0), Doubles.logUniform(0.05, 5));
        Arbitrary<Integer> rates = Arbitraries.integers().between(1, 240);
        return Combinators.combine(
                        Arbitraries.of(Integrator.class),
                        rates,
                        slowing,
                        Doubles.logUniform(1, 40),
                        accelerations(),
                        accelerations(),
                        Doubles.logUniform(0.1, 300),
                        Arbitraries.doubles().between(-4, 4))
                .as(Trip::new);
    }

    @Property
    void arrivalFromRestStopsOnTheGoalAndNeverPassesIt(@ForAll("trips") Trip trip) {
        assertEquals(0, trip.passes(trip.tank(0, 0)));
    }

    /** It passes the goal never if it can stop in whole steps; otherwise once, or never because of linear friction. */
    @Property
    void arrivalOfADrivingUnitStopsOnTheGoalAndPassesItOnlyIfItCannotStop(
            @ForAll("trips") Trip trip, @ForAll @DoubleRange(min = 0, max = 1) double share) {
        double speed = share * trip.top(), stopping = trip.stopping(speed);
        Assume.that(Math.abs(stopping - trip.distance()) > 1e-8);
        int passes = trip.passes(trip.tank(speed, trip.bearing()));
        if (stopping < trip.distance()) assertEquals(0, passes);
        else assertTrue(passes == 1 || (passes == 0 && trip.slowing() > 0), passes + " times");
    }

    @Property
    void arrivalStopsOnTheGoalFromAnyVelocity(
            @ForAll("trips") Trip trip,
            @ForAll @DoubleRange(min = 0, max = 3) double share,
            @ForAll @DoubleRange(min = -4, max = 4) double heading) {
        assertTrue(trip.passes(trip.tank(share * trip.top(), heading)) >= 0);
    }

    /** With u = √(2·b·distance), a unit passes the goal repeatedly, by up to 3·b·dt². */
    @Property(tries = 200)
    void theCommonRuleWithASquareRootOscillatesAroundTheGoal(
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 10, max = 240) int rate,
            @ForAll("accelerations") double b,
            @ForAll @DoubleRange(min = 1, max = 50) double goal) {
        Unit tank = new Unit(40);
        World world = world(
                tank,
                integrator,
                (w, dt) -> {
                    double left = goal - tank.getX(), u = Math.signum(left) * Math.sqrt(2 * b * Math.abs(left));
                    tank.setMotor(Math.max(-10, Math.min(10, u)), 0, 40 * b);
                },
                NOTHING);
        world.setTimestep(Timestep.fixed(rate));
        while (world.getTime() < 90) world.step();
        double farthest = 0;
        for (int i = 0; i < 200; i++) {
            world.step();
            farthest = Math.max(farthest, Math.abs(tank.getX() - goal));
        }
        assertEquals(1.6, farthest * rate * rate / b, 1.5);
    }

    /** The speed is v − n·µ·g·dt until rest, in any direction. The distance depends on the lag of the integrator. */
    @Property
    void dryFrictionReducesTheSpeedAtAConstantRateAndStopsTheUnit(
            @ForAll Integrator integrator,
            @ForAll("positive") double muG,
            @ForAll("positive") double dt,
            @ForAll @DoubleRange(min = 0.1, max = 200) double steps,
            @ForAll @DoubleRange(min = -4, max = 4) double bearing) {
        double v = steps * muG * dt;
        Unit crate = new Unit(40).setVelocity(v * Math.cos(bearing), v * Math.sin(bearing));
        crate.setMotor(0, 0, 40 * muG);
        for (int n = 1; n <= Math.ceil(steps) + 1; n++) {
            crate.integrate(dt, integrator);
            assertEquals(Math.max(0, v - n * muG * dt), crate.getSpeed(), 1e-12 * v);
        }
        assertEquals(0, crate.getSpeed());
        double way = Math.hypot(crate.getX(), crate.getY()), ideal = v * v / (2 * muG), lag = lag(integrator, 0);
        double last = muG * dt * dt / 8 + 1e-12 * (way + v * dt);
        assertEquals(ideal + (lag - 0.5) * v * dt, way, last);
        assertEquals(ideal, way, lag == 0.5 ? last : v * dt);
    }

    @Property
    void dryFrictionHoldsAUnitAtRestAgainstAWeakPushAndIsSubtractedFromAStrongPush(
            @ForAll Integrator integrator,
            @ForAll("positive") double muG,
            @ForAll @DoubleRange(min = 0, max = 3) double share,
            @ForAll @DoubleRange(min = -4, max = 4) double bearing,
            @ForAll @IntRange(min = 20, max = 300) int framesPerSecond) {
        Assume.that(Math.abs(share - 1) > 1e-9);
        double mass = 40, force = share * muG * mass;
        Unit crate = new Unit(mass).setPosition(3, 4).setMotor(0, 0, muG * mass);
        World world = world(crate, integrator, NOTHING, NOTHING);
        for (int frame = 0; frame < framesPerSecond; frame++) {
            crate.applyForce(force * Math.cos(bearing), force * Math.sin(bearing));
            world.advance(1.0 / framesPerSecond);
        }
        if (share < 1) {
            assertArrayEquals(new double[] {3, 4, 0}, new double[] {crate.getX(), crate.getY(), crate.getSpeed()});
        } else assertEquals((share - 1) * muG * world.getTime(), crate.getSpeed(), 1e-6 * muG);
    }

    @Property
    void aCrateReachesExactlyTheVelocityOfTheBeltAndSlidesAfterItsEnd(
            @ForAll Integrator integrator,
            @ForAll @IntRange(min = 10, max = 500) int rate,
            @ForAll("accelerations") double muG,
            @ForAll @DoubleRange(min = 0.1, max = 10) double belt) {
        double dt = 1.0 / rate, slide = belt * belt / (2 * muG), end = slide + 5 * belt * dt;
        Unit crate = new Unit(40);
        World world = world(
                crate,
                integrator,
                (w, h) -> crate.setMotor(crate.getX() >= 0 && crate.getX() < end ? belt : 0, 0, 40 * muG),
                NOTHING);
        while (crate.getX() < end) world.step(dt);
        assertEquals(belt, crate.getVx());
        double left = crate.getX();
        while (crate.getVx() != 0) world.step(dt);
        assertEquals(left + slide, crate.getX(), belt * dt);
        for (int i = 0; i < 3; i++) world.step(dt);
        assertEquals(left + slide, crate.getX(), belt * dt);
    }

    /** R is the smaller of the force of the engine and the force of the grip, µ·m·g. */
    @Property
    void onIceAndAfterAnImpulseTheDifferenceToTheOrderedVelocityDecreasesByForceOverMassPerSecond(
            @ForAll Integrator integrator,
            @ForAll("accelerations") double engine,
            @ForAll @DoubleRange(min = 0.02, max = 1) double grip,
            @ForAll @IntRange(min = 1, max = 500) int rate,
            @ForAll @DoubleRange(min = -30, max = 30) double vx,
            @ForAll @DoubleRange(min = -30, max = 30) double vy,
            @ForAll @DoubleRange(min = 0, max = 30) double order) {
        double gap = Math.hypot(order - vx, vy), change = Math.min(engine, grip * 9.81) / rate;
        Unit car = new Unit(1200).setVelocity(vx, vy);
        car.setMotor(order, 0, Math.min(1200 * engine, grip * car.getMass() * 9.81));
        for (int n = 1; n <= Math.ceil(gap / change) + 1; n++) {
            car.integrate(1.0 / rate, integrator);
            double now = Math.hypot(order - car.getVx(), car.getVy());
            assertEquals(Math.max(0, gap - n * change), now, 1e-11 * (1 + gap));
        }
        assertArrayEquals(new double[] {order, 0}, new double[] {car.getVx(), car.getVy()});
    }

    /** By J²/(2·m·R), relative to its place without the impulse, to within the distance of one step. */
    @Property
    void anImpulseMovesAUnitByItsSquareOverTwiceMassTimesForceInItsDirection(
            @ForAll Integrator integrator,
            @ForAll("accelerations") double decay,
            @ForAll @IntRange(min = 1, max = 500) int rate,
            @ForAll @DoubleRange(min = 1, max = 60) double blow,
            @ForAll @DoubleRange(min = -4, max = 4) double bearing) {
        Unit hit = new Unit(50).setVelocity(10, 0).setMotor(10, 0, 50 * decay);
        Unit other = new Unit(50).setVelocity(10, 0).setMotor(10, 0, 50 * decay);
        double jx = 50 * blow * Math.cos(bearing), jy = 50 * blow * Math.sin(bearing), dt = 1.0 / rate;
        hit.applyImpulse(jx, jy);
        assertEquals(blow, Math.hypot(hit.getVx() - 10, hit.getVy()), 1e-12);
        do {
            hit.integrate(dt, integrator);
            other.integrate(dt, integrator);
        } while (hit.getVx() != 10 || hit.getVy() != 0);
        double way = (50 * blow) * (50 * blow) / (2 * 50 * 50 * decay) + (lag(integrator, 0) - 0.5) * blow * dt;
        double slack = decay * dt * dt / 8 + 1e-9;
        assertEquals(way * Math.cos(bearing), hit.getX() - other.getX(), slack);
        assertEquals(way * Math.sin(bearing), hit.getY() - other.getY(), slack);
    }

    // Forces

    @Property
    void aShellFollowsTheExactParabolaAtEveryTickRate(
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

    /** The rule of docs/physics.md: oscillations on a spring decay if f > lag(z)·k·dt, and grow if f is less. */
    @Property(tries = 300)
    void oscillationsDecayIfFrictionIsAboveLagTimesStiffnessTimesDtAndGrowIfItIsBelow(
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

    /** For EXACT, to within 1e-11, because its formula loses digits for small z. */
    private static double lag(Integrator integrator, double z) {
        switch (integrator) {
            case EULER:
                return 1;
            case SEMI_IMPLICIT:
                return 0;
            case MIDPOINT:
                return 0.5;
            default:
                return z < 1e-3 ? 0.5 - z / 12 : 1 / z - 1 / Math.expm1(z);
        }
    }

    /** No oscillation exceeds 1/√(1 − k·dt²/(4·m)) times the first one. */
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
    void inWindAUnitApproachesForceOverFrictionPlusTheSpeedOfTheWind(
            @ForAll Integrator integrator,
            @ForAll("stiffness") double z,
            @ForAll("positive") double friction,
            @ForAll @DoubleRange(min = -50, max = 50) double wind,
            @ForAll @DoubleRange(min = -50, max = 50) double alone) {
        Unit unit = new Unit(friction / z).setFriction(friction); // z for a step of 1 s
        for (int i = 0; i < 2000; i++) {
            unit.applyForce(friction * alone + unit.getFriction() * wind, 0);
            unit.integrate(1, integrator);
        }
        assertEquals(alone + wind, unit.getVx(), 1e-10);
    }

    @Property
    void aBlastThrowsUnitsOutwardsByAtMostItsImpulseAndDoesNotMoveAUnitInItsCentre(
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

    /** From the smallest numbers with squares that are not subnormal; and 0, the centre. */
    @Provide
    Arbitrary<Double> offsets() {
        return Arbitraries.oneOf(Doubles.signedLogUniform(1e-150, 20), Arbitraries.just(0.0));
    }

    // Timesteps (docs/guide.md)

    /** The waiting time in seconds does not change, but alpha becomes its fraction of a new step. */
    @Property
    void aChangeOfTheTimestepMakesThePictureJumpByLessThanAStep(
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
    void unitsFollowTheSamePathsToTheBitAtEveryGameSpeed(
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
    void aWorldRestoredFromItsEmptySnapshotPlaysLikeANewWorld(
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
}
