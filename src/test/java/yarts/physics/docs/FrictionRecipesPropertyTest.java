package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.StepListener;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** The claims of docs/cookbook.md on sideways grip, quadratic drag and turning, for all speeds and integrators. */
class FrictionRecipesPropertyTest {
    @Provide
    Arbitrary<Double> positive() {
        return Doubles.logUniform(1e-6, 1e6);
    }

    @Provide
    Arbitrary<Double> frictions() {
        return Arbitraries.oneOf(Doubles.logUniform(1e-6, 1e6), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> grips() {
        return Arbitraries.oneOf(Doubles.logUniform(1e-6, 1e100), Doubles.logUniform(0.1, 100), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> anySpeed() {
        return Doubles.signedLogUniform(1e-140, 1e140);
    }

    // Sideways grip

    /** The car of the recipe. */
    private static final class Car extends Unit {
        double heading, last;

        Car() {
            super(1_200);
        }

        void grip(double r, double dt) {
            double turn = Math.IEEEremainder(heading - last, 2 * Math.PI);
            double hx = StrictMath.cos(last), hy = StrictMath.sin(last);
            double along = getVx() * hx + getVy() * hy, across = getVy() * hx - getVx() * hy;
            double s = r * dt / 2, q = s * s - turn * turn, w = Math.sqrt(Math.abs(q)), c, n;
            if (q > 0) {
                double slow = StrictMath.exp(w - s), fast = StrictMath.exp(-w - s);
                c = (slow + fast) / 2;
                n = (slow - fast) / (2 * w);
            } else {
                c = StrictMath.exp(-s) * StrictMath.cos(w);
                n = StrictMath.exp(-s) * (w > 0 ? StrictMath.sin(w) / w : 1);
            }
            double a = (c + s * n) * along + turn * n * across, b = (c - s * n) * across - turn * n * along;
            last = heading;
            hx = StrictMath.cos(last);
            hy = StrictMath.sin(last);
            setVelocity(a * hx - b * hy, a * hy + b * hx);
        }

        double across() {
            return getVy() * StrictMath.cos(heading) - getVx() * StrictMath.sin(heading);
        }

        double along() {
            return getVx() * StrictMath.cos(heading) + getVy() * StrictMath.sin(heading);
        }
    }

    /** A car with the speed 20 m/s that turns by 2 rad/s for 10 s. */
    private static Car turned(Integrator how, double r, double turnRate, int rate, int seconds) {
        Car car = new Car();
        car.setVelocity(20, 0);
        World world = new World(how, Timestep.fixed(rate));
        world.add(car);
        world.addBeforeStep((w, dt) -> car.heading += turnRate * dt);
        world.addAfterStep((w, dt) -> car.grip(r, dt));
        for (int tick = 0; tick < seconds * rate; tick++) world.step();
        return car;
    }

    /** If a rule only removes the part across the heading, 7.3 m/s remain at 20 steps/s, and 18.4 m/s at 240. */
    @Example
    void onRailsACarKeepsItsSpeedInATurnButTheCommonRuleReducesItDependingOnTheTickRate() {
        double[][] common = {{20, 7.345}, {240, 18.401}};
        for (double[] known : common) {
            int rate = (int) known[0];
            double vx = 20, vy = 0;
            for (int tick = 1; tick <= 10 * rate; tick++) {
                double hx = StrictMath.cos(2.0 * tick / rate), hy = StrictMath.sin(2.0 * tick / rate);
                double along = vx * hx + vy * hy;
                vx = along * hx;
                vy = along * hy;
            }
            assertEquals(known[1], Math.hypot(vx, vy), 1e-3);
            for (Integrator how : Integrator.values()) {
                Car car = turned(how, 1e9, 2, rate, 10);
                assertEquals(20, car.getSpeed(), 1e-4);
                assertEquals(car.getSpeed(), car.along(), 1e-6);
            }
        }
    }

    @Property
    void aTurnReducesTheSpeedEquallyAtEveryTickRate(
            @ForAll Integrator how,
            @ForAll("grips") double r,
            @ForAll @DoubleRange(min = -5, max = 5) double turnRate,
            @ForAll @IntRange(min = 10, max = 500) int rate) {
        Car car = turned(how, r, turnRate, rate, 2), fine = turned(how, r, turnRate, 1000, 2);
        assertEquals(fine.getVx(), car.getVx(), 1e-5);
        assertEquals(fine.getVy(), car.getVy(), 1e-5);
    }

    /** Compared with a solution of the equation by Heun's method in steps of 50 microseconds. */
    @Property(tries = 30)
    void gripSolvesTheEquationOfASlideThatDecaysAtTheRateOfTheGrip(
            @ForAll @DoubleRange(min = 0, max = 50) double r, @ForAll @DoubleRange(min = -5, max = 5) double turnRate) {
        Car car = turned(Integrator.EXACT, r, turnRate, 20, 1);
        double vx = 20, vy = 0, h = 5e-5;
        for (int i = 0; i < 20_000; i++) {
            double x = -Math.sin(turnRate * h * i), y = Math.cos(turnRate * h * i), slide = r * (vx * x + vy * y);
            double ax = -slide * x, ay = -slide * y;
            x = -Math.sin(turnRate * h * (i + 1));
            y = Math.cos(turnRate * h * (i + 1));
            slide = r * ((vx + h * ax) * x + (vy + h * ay) * y);
            vx += h / 2 * (ax - slide * x);
            vy += h / 2 * (ay - slide * y);
        }
        assertEquals(vx, car.getVx(), 1e-3);
        assertEquals(vy, car.getVy(), 1e-3);
    }

    /** To within 3 % if r is at least ten times the turn rate. */
    @Property(tries = 100)
    void aTurningCarLosesTheFractionTurnRateSquaredOverGripOfItsSpeedPerSecond(
            @ForAll @DoubleRange(min = 0.5, max = 3) double turnRate,
            @ForAll @DoubleRange(min = 10, max = 100) double ratio,
            @ForAll @IntRange(min = 10, max = 240) int rate) {
        double r = ratio * turnRate, loss = turnRate * turnRate / r;
        Car two = turned(Integrator.EXACT, r, turnRate, rate, 2), four = turned(Integrator.EXACT, r, turnRate, rate, 4);
        assertEquals(1, Math.log(two.getSpeed() / four.getSpeed()) / (2 * loss), 0.03);
    }

    @Property
    void onAStraightCourseTheSlideDecaysAtTheRateOfTheGripAndTheVelocityAlongTheHeadingStays(
            @ForAll("grips") double r,
            @ForAll("positive") double dt,
            @ForAll @DoubleRange(min = -4, max = 4) double heading,
            @ForAll @DoubleRange(min = -100, max = 100) double vx,
            @ForAll @DoubleRange(min = -100, max = 100) double vy) {
        Car car = new Car();
        car.setVelocity(vx, vy);
        car.heading = car.last = heading;
        double along = car.along(), across = car.across(), slack = 1e-13 * Math.hypot(vx, vy);
        car.grip(r, dt);
        assertEquals(along, car.along(), slack);
        assertEquals(StrictMath.exp(-r * dt) * across, car.across(), slack);
    }

    /** A jump of the heading by 2π, as in games that keep it in a range of 2π, is not a turn. */
    @Property
    void gripMakesNoCarFasterAndWithoutGripTheHeadingHasNoEffect(
            @ForAll("grips") double r,
            @ForAll("positive") double dt,
            @ForAll @DoubleRange(min = -20, max = 20) double from,
            @ForAll @DoubleRange(min = -20, max = 20) double to,
            @ForAll @DoubleRange(min = -100, max = 100) double vx,
            @ForAll @DoubleRange(min = -100, max = 100) double vy) {
        double speed = Math.hypot(vx, vy), slack = 1e-13 * speed;
        Car[] cars = {new Car(), new Car(), new Car()};
        for (Car car : cars) {
            car.setVelocity(vx, vy);
            car.last = from;
            car.heading = to;
        }
        cars[1].heading = to + 2 * Math.PI;
        cars[0].grip(r, dt);
        cars[1].grip(r, dt);
        cars[2].grip(0, dt);
        assertTrue(cars[0].getSpeed() <= speed + slack, () -> cars[0].getSpeed() + " from " + speed);
        if (Math.abs(Math.abs(Math.IEEEremainder(to - from, 2 * Math.PI)) - Math.PI) > 1e-6) {
            assertEquals(cars[0].getVx(), cars[1].getVx(), 1e-10 * (1 + speed));
            assertEquals(cars[0].getVy(), cars[1].getVy(), 1e-10 * (1 + speed));
        }
        assertEquals(vx, cars[2].getVx(), slack);
        assertEquals(vy, cars[2].getVy(), slack);
    }

    // Quadratic drag

    /** The listener of the recipe, for half a step. */
    private static StepListener half(Unit unit, double c) {
        return (world, dt) -> {
            double factor = 1 / (1 + c * unit.getSpeed() * (dt / 2) / unit.getMass());
            unit.setVelocity(factor * unit.getVx(), factor * unit.getVy());
        };
    }

    private static World dragged(Unit unit, Integrator how, double c) {
        World world = new World(how, Timestep.fixed(60));
        world.add(unit);
        world.addBeforeStep(half(unit, c));
        world.addAfterStep(half(unit, c));
        return world;
    }

    @Property
    void quadraticDragNeverReversesOrAcceleratesAUnit(
            @ForAll Integrator how,
            @ForAll("positive") double mass,
            @ForAll("frictions") double friction,
            @ForAll("positive") double c,
            @ForAll("positive") double dt,
            @ForAll("anySpeed") double vx,
            @ForAll("anySpeed") double vy) {
        Unit unit = new Unit(mass).setFriction(friction).setVelocity(vx, vy);
        World world = dragged(unit, how, c);
        for (int i = 0; i < 20; i++) {
            double x = unit.getVx(), y = unit.getVy();
            world.step(dt);
            assertTrue(unit.getVx() * x >= 0 && Math.abs(unit.getVx()) <= Math.abs(x), x + " to " + unit.getVx());
            assertTrue(unit.getVy() * y >= 0 && Math.abs(unit.getVy()) <= Math.abs(y), y + " to " + unit.getVy());
        }
    }

    @Property
    void quadraticDragIsExactWithoutOtherForces(
            @ForAll Integrator how,
            @ForAll("positive") double mass,
            @ForAll("positive") double c,
            @ForAll("positive") double v,
            @ForAll("positive") double dt) {
        Unit unit = new Unit(mass).setVelocity(0, -v);
        World world = dragged(unit, how, c);
        for (int n = 1; n <= 100; n++) {
            world.step(dt);
            assertEquals(1, unit.getSpeed() / (v / (1 + c * v * n * dt / mass)), 1e-13 * n + 1e-13);
        }
    }

    /** The final speed is √(F/c) / √(1 + c·F·dt²/(4·m²)). */
    @Property(tries = 300)
    void underAForceAndQuadraticDragTheSpeedNeverExceedsTheRootOfForceOverDrag(
            @ForAll Integrator how,
            @ForAll("positive") double mass,
            @ForAll("positive") double root,
            @ForAll("positive") double dt,
            @ForAll @DoubleRange(min = 0.05, max = 100) double push) {
        double force = push * root * mass / dt, c = force / (root * root); // push: F·dt/m in multiples of the root
        Unit unit = new Unit(mass);
        World world = dragged(unit, how, c);
        for (int i = 0; i < 2000; i++) {
            unit.applyForce(force, 0);
            world.step(dt);
            assertTrue(unit.getVx() <= root * (1 + 1e-13), unit.getVx() + " past " + root);
        }
        assertEquals(1, unit.getVx() / (root / Math.sqrt(1 + c * force * dt * dt / (4 * mass * mass))), 1e-9);
    }

    /** The range of the shell in the recipe from (v, v), with halves of the drag, or with all drag after the step. */
    private static double range(Integrator how, double v, int rate, boolean halves) {
        Unit shell = new Unit(4).setVelocity(v, v);
        World world = new World(how, Timestep.fixed(rate));
        world.add(shell);
        StepListener half = half(shell, 0.008);
        if (halves) world.addBeforeStep(half);
        world.addBeforeStep((w, dt) -> shell.applyForce(0, -10 * shell.getMass()));
        world.addAfterStep(halves ? half : (w, dt) -> half.onStep(w, 2 * dt));
        while (true) {
            double x = shell.getX(), y = shell.getY();
            world.step();
            if (shell.getY() < 0) return x + (shell.getX() - x) * y / (y - shell.getY());
        }
    }

    @Example
    void halfOfTheDragBeforeAndAfterTheStepReducesTheErrorOfTheRangeFromTwelveMetresToSevenCentimetres() {
        double ideal = range(Integrator.EXACT, 200, 5000, true);
        assertEquals(902.46, ideal, 0.01);
        assertEquals(12.5, range(Integrator.EXACT, 200, 10, false) - ideal, 0.05);
        assertEquals(-0.074, range(Integrator.EXACT, 200, 10, true) - ideal, 0.003);
        assertEquals(-0.074 / 36, range(Integrator.EXACT, 200, 60, true) - ideal, 0.001);
    }

    @Property(tries = 30)
    void theErrorOfTheRangeIsProportionalToDtSquaredAndWithAllDragAfterTheStepToDt(
            @ForAll boolean exact, @ForAll @DoubleRange(min = 100, max = 250) double v) {
        Integrator how = exact ? Integrator.EXACT : Integrator.MIDPOINT;
        double ideal = range(how, v, 4000, true);
        double coarse = Math.abs(range(how, v, 10, true) - ideal), fine = Math.abs(range(how, v, 80, true) - ideal);
        assertTrue(coarse < 0.15 && fine < coarse / 25, coarse + " and " + fine);
        assertEquals(8, (range(how, v, 10, false) - ideal) / (range(how, v, 80, false) - ideal), 0.4);
    }

    // The order of frictions

    /** The difference of the velocities after 1 s with the drag before linear friction and after it. */
    private static double difference(Integrator how, double friction, int steps) {
        Unit before = new Unit(1).setFriction(friction).setVelocity(20, 0);
        Unit after = new Unit(1).setFriction(friction).setVelocity(20, 0);
        double dt = 1.0 / steps;
        World nowhere = new World();
        for (int i = 0; i < steps; i++) {
            half(before, 1).onStep(nowhere, 2 * dt);
            before.integrate(dt, how);
            after.integrate(dt, how);
            half(after, 1).onStep(nowhere, 2 * dt);
        }
        return before.getVx() - after.getVx();
    }

    @Property(tries = 100)
    void theEffectOfTheOrderOfLinearFrictionAndDragIsProportionalToDt(
            @ForAll Integrator how, @ForAll @DoubleRange(min = 1, max = 3) double friction) {
        double coarse = difference(how, friction, 64), fine = difference(how, friction, 128);
        assertNotEquals(0, fine);
        assertEquals(2, coarse / fine, 0.2);
    }

    // Turning

    /** From 10 m/s to 73.8 m/s in 60 s, at 2 rad/s and 60 steps/s. */
    @Example
    void aForcePerpendicularToTheMotionIncreasesTheSpeed() {
        for (Integrator how : Integrator.values()) {
            Unit unit = new Unit(1).setVelocity(10, 0);
            for (int tick = 0; tick < 3600; tick++) {
                unit.applyForce(-2 * unit.getVy(), 2 * unit.getVx());
                unit.integrate(1 / 60.0, how);
            }
            assertEquals(73.8, unit.getSpeed(), 0.05);
        }
    }

    @Property(tries = 200)
    void rotatingTheVelocityKeepsTheSpeedAndTurnsAtTheSameRateAtEveryTickRate(
            @ForAll Integrator how,
            @ForAll @IntRange(min = 1, max = 240) int rate,
            @ForAll @DoubleRange(min = -6, max = 6) double turnRate,
            @ForAll @DoubleRange(min = 0.1, max = 100) double v) {
        World world = new World(how, Timestep.fixed(rate));
        Unit unit = world.add(new Unit(1).setVelocity(v, 0));
        world.addBeforeStep((w, dt) -> {
            double cos = StrictMath.cos(turnRate * dt), sin = StrictMath.sin(turnRate * dt);
            unit.setVelocity(cos * unit.getVx() - sin * unit.getVy(), sin * unit.getVx() + cos * unit.getVy());
        });
        for (int tick = 0; tick < 60 * rate; tick++) world.step();
        assertEquals(v * Math.cos(60 * turnRate), unit.getVx(), 1e-10 * v);
        assertEquals(v * Math.sin(60 * turnRate), unit.getVy(), 1e-10 * v);
        assertEquals(v, unit.getSpeed(), 1e-11 * v);
        double radius = turnRate * 60 < 1e-3 && turnRate * 60 > -1e-3 ? 0 : Math.abs(v / turnRate);
        if (radius > 0) assertTrue(Math.hypot(unit.getX(), unit.getY()) <= 2 * radius + 7 * v / rate);
    }

    // Terrain

    /** The mud of the recipe: 3 m/s, µ = 0.5; a tank with an engine of 2 m/s² arrives with 3.5 to 60 m/s. */
    @Property(tries = 200)
    void mudSlowsAUnitWithAndWithoutATopSpeed(
            @ForAll Integrator how,
            @ForAll @IntRange(min = 1, max = 240) int rate,
            @ForAll @DoubleRange(min = 3.5, max = 60) double from,
            @ForAll boolean hasTopSpeed,
            @ForAll boolean hasFriction) {
        double m = 40_000, friction = hasFriction ? 2_000 : 0;
        World world = new World(how, Timestep.fixed(rate));
        Unit tank = world.add(new Unit(m).setFriction(friction).setVelocity(from, 0));
        if (hasTopSpeed) tank.setMaxSpeed(80);
        else assertEquals(Double.POSITIVE_INFINITY, tank.getMaxSpeed());
        world.addBeforeStep((w, dt) -> {
            for (Unit unit : w) unit.setMotor(3, 0, Math.min(80_000, 0.5 * unit.getMass() * 10));
        });
        double last = from;
        for (int n = 1; n <= Math.ceil((from - 3) / 2 * rate) + 1; n++) {
            world.step();
            double v = tank.getVx();
            assertTrue(v >= 3 && (v < last || v == 3), v + " m/s");
            if (!hasFriction) assertEquals(Math.max(3, from - 2.0 * n / rate), v, 1e-10);
            last = v;
        }
        assertEquals(3, tank.getVx());
    }
}
