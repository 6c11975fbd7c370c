package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** The map recipes of docs/cookbook.md, with random numbers. */
class MapsPropertyTest {
    @Provide
    Arbitrary<Double> finite() {
        return Doubles.finite();
    }

    @Provide
    Arbitrary<Double> widths() {
        return Doubles.logUniform(1e-6, 1e9);
    }

    @Provide
    Arbitrary<Double> anySpeed() {
        return Doubles.signedLogUniform(1e-20, 1e150);
    }

    // Wrapping maps

    private static double wrap(double x, double width) {
        double rest = x % width;
        if (rest < 0) rest += width;
        return rest < width ? rest : 0;
    }

    private static World wrapping(Integrator integrator, double width) {
        World world = new World(integrator, Timestep.fixed(60));
        world.addBeforeStep((w, dt) -> {
            for (Unit unit : w) {
                double x = wrap(unit.getX(), width), y = wrap(unit.getY(), width);
                if (x != unit.getX() || y != unit.getY()) unit.setPosition(x, y);
            }
        });
        return world;
    }

    @Example
    void aTinyNegativePositionWrapsToLessThanTheWidth() {
        assertEquals(100, -1e-17 % 100 + 100, "the trap");
        for (double x : new double[] {-1e-17, -Double.MIN_VALUE, -0.0, 100, -100, 200, -1e300 * 100}) {
            assertEquals(0, wrap(x, 100) + 0.0, 60, () -> "of " + x);
            assertTrue(wrap(x, 100) >= 0 && wrap(x, 100) < 100, () -> "of " + x);
        }
        assertEquals(0, wrap(-1e-17, 100));
        assertEquals(0, wrap(-Double.MIN_VALUE, 100));
        assertEquals(Math.nextDown(100.0), wrap(-1.5e-14, 100));
        assertEquals(Math.nextDown(100.0), wrap(Math.nextDown(100.0), 100));
    }

    /** Exact to the bit for positions that are not negative; to within half an ulp of the width for others. */
    @Property
    void aWrappedPositionIsTheExactRemainderInTheRange(@ForAll("finite") double x, @ForAll("widths") double width) {
        double wrapped = wrap(x, width);
        assertTrue(wrapped >= 0 && wrapped < width, () -> x + " wraps to " + wrapped);
        BigDecimal exact = new BigDecimal(x).remainder(new BigDecimal(width));
        if (exact.signum() < 0) exact = exact.add(new BigDecimal(width));
        double error = exact.subtract(new BigDecimal(wrapped)).doubleValue();
        if (x >= 0) assertEquals(0, error);
        else
            assertTrue(Math.min(Math.abs(error), Math.abs(error - width)) <= Math.ulp(width) / 2, () -> "off " + error);
    }

    /** Also for units that cross the map many times per step. */
    @Property
    void everyStepStartsOnTheMap(
            @ForAll Integrator integrator,
            @ForAll("widths") double width,
            @ForAll("finite") double start,
            @ForAll("anySpeed") double vx,
            @ForAll("anySpeed") double vy) {
        World world = wrapping(integrator, width);
        Unit ship = world.add(new Unit(1).setPosition(start, start / 3).setVelocity(vx, vy));
        world.addBeforeStep((w, dt) -> {
            assertTrue(ship.getX() >= 0 && ship.getX() < width, () -> width + " m: " + ship);
            assertTrue(ship.getY() >= 0 && ship.getY() < width, () -> width + " m: " + ship);
        });
        for (int tick = 0; tick < 60; tick++) world.step();
    }

    /** The drawn position moves by v times the time between two frames. At 20,000 m/s, a step crosses three maps. */
    @Property
    void aUnitIsDrawnWithoutAJumpAcrossTheEdgeOfAMap(
            @ForAll @DoubleRange(min = -20_000, max = 20_000) double v,
            @ForAll @IntRange(min = 10, max = 500) int framesPerSecond) {
        double width = 100;
        World world = wrapping(Integrator.EXACT, width);
        Unit ship = world.add(new Unit(1).setPosition(50, 0).setVelocity(v, 0));
        double drawn = Double.NaN;
        for (int frame = 0; frame < 3 * framesPerSecond; frame++) {
            world.advance(1.0 / framesPerSecond);
            if (world.getTick() == 0) continue; // there is no step to draw yet
            double x = wrap(ship.getInterpolatedX(), width), gone = x - drawn;
            if (!Double.isNaN(drawn)) assertEquals(0, Math.IEEEremainder(gone - v / framesPerSecond, width), 1e-5);
            drawn = x;
        }
    }

    @Property
    void theShorterWayRoundAMapIsAtMostHalfOfItsWidth(
            @ForAll @DoubleRange(min = 1, max = 1e4) double width,
            @ForAll @DoubleRange(min = 0, max = 1) double from,
            @ForAll @DoubleRange(min = -5, max = 5) double to) {
        double d = width * to - width * from, shortest = d - width * Math.rint(d / width);
        assertTrue(Math.abs(shortest) <= width / 2 + 1e-9);
        assertEquals(0, Math.abs(Math.IEEEremainder(from * width + shortest - to * width, width)), 1e-9);
    }

    // Moving the origin

    /** In all directions, also at many times 1,024 m per step. The other unit keeps its distance. */
    @Property
    void aMoveOfTheOriginIsNotVisible(
            @ForAll @DoubleRange(min = -1e6, max = 1e6) double vx,
            @ForAll @DoubleRange(min = -3_000, max = 3_000) double vy,
            @ForAll @IntRange(min = 10, max = 300) int framesPerSecond) {
        World world = new World();
        Unit ship = world.add(new Unit(1).setVelocity(vx, vy));
        Unit wingman = world.add(new Unit(1).setPosition(30, 40).setVelocity(vx, vy));
        double[] origin = {0, 0};
        world.addBeforeStep((w, dt) -> {
            if (Math.abs(ship.getX()) <= 1024 && Math.abs(ship.getY()) <= 1024) return;
            double dx = 1024 * Math.rint(ship.getX() / 1024), dy = 1024 * Math.rint(ship.getY() / 1024);
            for (Unit unit : w) unit.setPosition(unit.getX() - dx, unit.getY() - dy);
            origin[0] += dx;
            origin[1] += dy;
        });
        world.addBeforeStep((w, dt) -> {
            assertTrue(Math.abs(ship.getX()) <= 1024 && Math.abs(ship.getY()) <= 1024, ship::toString);
            assertEquals(30, wingman.getX() - ship.getX(), 1e-6);
            assertEquals(40, wingman.getY() - ship.getY(), 1e-6);
        });
        for (int frame = 0; frame < 2 * framesPerSecond; frame++) {
            world.advance(1.0 / framesPerSecond);
            if (world.getTick() == 0) continue;
            double drawnTime = world.getTime() - (1 - world.getAlpha()) / 60;
            assertEquals(vx * drawnTime, origin[0] + ship.getInterpolatedX(), 1e-3);
            assertEquals(vy * drawnTime, origin[1] + ship.getInterpolatedY(), 1e-5);
        }
    }

    // Lifts and other scripted units

    @Property
    void aLiftIsDrawnOnItsPathUnderAnyForceAndImpulse(
            @ForAll Integrator integrator,
            @ForAll @DoubleRange(min = -50, max = 50) double speed,
            @ForAll @IntRange(min = 10, max = 300) int framesPerSecond) {
        World world = new World(integrator, Timestep.fixed(60));
        Unit lift = world.add(new Unit(1_000).setFrozen(true));
        world.addAfterStep((w, dt) -> lift.moveTo(0, speed * w.getTime()));
        for (int frame = 0; frame < framesPerSecond; frame++) {
            lift.applyForce(1e9, 1e9);
            lift.applyImpulse(1e9, 1e9);
            world.advance(1.0 / framesPerSecond);
            if (world.getTick() == 0) continue;
            double drawnTime = world.getTime() - (1 - world.getAlpha()) / 60;
            assertEquals(speed * drawnTime, lift.getInterpolatedY(), 1e-9);
            assertEquals(0, lift.getInterpolatedX());
            assertEquals(0, lift.getSpeed());
        }
    }
}
