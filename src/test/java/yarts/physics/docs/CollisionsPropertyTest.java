package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
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

/** The collision recipes of docs/cookbook.md, with random numbers. */
class CollisionsPropertyTest {
    private static final double LEFT = 0, RIGHT = 10;

    @Provide
    Arbitrary<Double> offsets() {
        return Arbitraries.oneOf(Doubles.signedLogUniform(Double.MIN_VALUE, 20), Arbitraries.just(0.0));
    }

    @Provide
    Arbitrary<Double> masses() {
        return Doubles.logUniform(1e-3, 1e3);
    }

    @Provide
    Arbitrary<Double> anySpeed() {
        return Doubles.signedLogUniform(1e-3, 1e150);
    }

    private static StepListener pushApart(Unit a, Unit b, double reach, double k) {
        return (w, dt) -> {
            double dx = b.getX() - a.getX(), dy = b.getY() - a.getY();
            double distance = Math.sqrt(dx * dx + dy * dy);
            if (distance >= reach) return;
            if (distance < 1e-3) {
                dx = distance = 1e-3;
                dy = 0;
            }
            double push = k * (reach / distance - 1);
            a.applyForce(-push * dx, -push * dy);
            b.applyForce(push * dx, push * dy);
        };
    }

    /** Also from the same place, and from a distance so small that dx² underflows. */
    @Property(tries = 50)
    void unitsThatPushEachOtherComeToRestSideBySide(
            @ForAll Integrator integrator,
            @ForAll("offsets") double x,
            @ForAll("offsets") double y,
            @ForAll @DoubleRange(min = 1_000, max = 6_000) double k) {
        World world = new World(integrator, Timestep.fixed(60));
        Unit a = world.add(new Unit(1_000).setFriction(8_000));
        Unit b = world.add(new Unit(1_000).setFriction(8_000).setPosition(x, y));
        world.addBeforeStep(pushApart(a, b, 4, k));
        for (int tick = 0; tick < 60 * 60; tick++) world.step();
        double before = Math.hypot(x, y), distance = Math.hypot(b.getX() - a.getX(), b.getY() - a.getY());
        assertEquals(Math.max(4, before), distance, 1e-3);
        assertEquals(x, a.getX() + b.getX(), 1e-9);
        assertEquals(y, a.getY() + b.getY(), 1e-9);
    }

    private static void bounce(Unit a, Unit b, double nx, double ny, double e) {
        double va = a.isFrozen() ? 0 : a.getVx() * nx + a.getVy() * ny, wa = a.isFrozen() ? 0 : 1 / a.getMass();
        double vb = b.isFrozen() ? 0 : b.getVx() * nx + b.getVy() * ny, wb = b.isFrozen() ? 0 : 1 / b.getMass();
        if (va > vb) {
            double j = (1 + e) * (va - vb) / (wa + wb);
            a.applyImpulse(-j * nx, -j * ny);
            b.applyImpulse(j * nx, j * ny);
        }
    }

    @Property
    void aBounceConservesMomentumAndMultipliesTheVelocityOfTheApproachByMinusTheRestitution(
            @ForAll("masses") double ma,
            @ForAll("masses") double mb,
            @ForAll @DoubleRange(min = -50, max = 50) double ax,
            @ForAll @DoubleRange(min = -50, max = 50) double bx,
            @ForAll @DoubleRange(min = -50, max = 50) double by,
            @ForAll @DoubleRange(min = -4, max = 4) double bearing,
            @ForAll @DoubleRange(min = 0, max = 1) double e) {
        double nx = Math.cos(bearing), ny = Math.sin(bearing);
        Unit a = new Unit(ma).setVelocity(ax, 0), b = new Unit(mb).setVelocity(bx, by);
        double closing = (ax - bx) * nx - by * ny, along = ax * -ny;
        bounce(a, b, nx, ny, e);
        double after = (a.getVx() - b.getVx()) * nx + (a.getVy() - b.getVy()) * ny;
        assertEquals(closing > 0 ? -e * closing : closing, after, 1e-9);
        assertEquals(ma * ax + mb * bx, ma * a.getVx() + mb * b.getVx(), 1e-9 * (ma + mb));
        assertEquals(mb * by, ma * a.getVy() + mb * b.getVy(), 1e-9 * (ma + mb));
        assertEquals(along, a.getVx() * -ny + a.getVy() * nx, 1e-9);
    }

    /** A frozen unit may have a velocity; the bounce ignores it. */
    @Property
    void aUnitBouncesOffAFrozenUnitAsOffAWall(
            @ForAll @DoubleRange(min = -50, max = 50) double va,
            @ForAll @DoubleRange(min = -50, max = 50) double vb,
            @ForAll @DoubleRange(min = 0, max = 1) double e,
            @ForAll @IntRange(min = 1, max = 3) int frozen) {
        Unit a = new Unit(2).setVelocity(va, 3).setFrozen((frozen & 1) != 0);
        Unit b = new Unit(3).setVelocity(vb, 4).setFrozen((frozen & 2) != 0);
        bounce(a, b, 1, 0, e);
        assertEquals(frozen == 2 && va > 0 ? -e * va : va, a.getVx(), 1e-12);
        assertEquals(frozen == 1 && vb < 0 ? -e * vb : vb, b.getVx(), 1e-12);
        assertArrayEquals(new double[] {3, 4}, new double[] {a.getVy(), b.getVy()});
    }

    private static World room(Integrator integrator, double restitution, Unit inside) {
        World world = new World(integrator, Timestep.fixed(60));
        world.add(inside);
        world.addAfterStep((w, dt) -> {
            for (Unit unit : w) {
                double x = unit.getX(), vx = unit.getVx(), wall = x >= RIGHT ? RIGHT : LEFT;
                if (x > LEFT && x < RIGHT) continue;
                double e = Math.abs(vx) > 1 ? restitution : 0;
                unit.moveTo(Math.max(LEFT, Math.min(RIGHT, wall - e * (x - wall))), unit.getY());
                if ((x >= RIGHT) == (vx > 0)) unit.setVelocity(-e * vx, unit.getVy());
            }
        });
        return world;
    }

    /** Also at speeds of many room widths per step. Each bounce multiplies the speed by e. */
    @Property
    void aUnitIsNeverDrawnBeyondAWallAndNeverThereAfterAStep(
            @ForAll Integrator integrator,
            @ForAll @DoubleRange(min = 0, max = 1) double e,
            @ForAll @DoubleRange(min = 0, max = 10) double start,
            @ForAll("anySpeed") double vx,
            @ForAll @DoubleRange(min = -1000, max = 1000) double vy,
            @ForAll @IntRange(min = 10, max = 500) int framesPerSecond) {
        Unit unit = new Unit(1).setPosition(start, 0).setVelocity(vx, vy);
        World world = room(integrator, e, unit);
        double speed = vx;
        for (int frame = 0; frame < 200; frame++) {
            int steps = world.advance(1.0 / framesPerSecond);
            double x = unit.getX(), drawn = unit.getInterpolatedX();
            assertTrue(x >= LEFT && x <= RIGHT, () -> "at " + x);
            assertTrue(drawn >= LEFT && drawn <= RIGHT, () -> "drawn at " + drawn);
            if (steps == 1 && unit.getVx() != speed) {
                assertEquals(Math.abs(speed) > 1 ? -e * speed + 0.0 : 0, unit.getVx() + 0.0);
            }
            speed = unit.getVx();
        }
        assertEquals(vy * world.getTime(), unit.getY(), 1e-9 * Math.abs(vy) * world.getTime());
    }

    /** At speeds below one room width per step, the path of an elastic ball is exact, also at the walls. */
    @Property
    void anElasticBallFollowsTheReflectedPath(
            @ForAll Integrator integrator,
            @ForAll @DoubleRange(min = 0, max = 10) double start,
            @ForAll @DoubleRange(min = -500, max = 500) double vx) {
        Assume.that(Math.abs(vx) > 1);
        Unit ball = new Unit(1).setPosition(start, 0).setVelocity(vx, 0);
        World world = room(integrator, 1, ball);
        for (int tick = 0; tick < 300; tick++) {
            world.step();
            double unfolded = Math.abs(Math.IEEEremainder(start + vx * world.getTime(), 2 * RIGHT));
            assertEquals(unfolded, ball.getX(), 1e-8);
            assertEquals(Math.abs(vx), ball.getSpeed());
        }
    }

    /** If 3·a·dt/(1 − e) is at most 1 m/s. */
    @Property(tries = 50)
    void aUnitThatAMotorPressesAgainstAWallComesToRestAtIt(
            @ForAll Integrator integrator,
            @ForAll @DoubleRange(min = 0, max = 0.8) double e,
            @ForAll @DoubleRange(min = 0.3, max = 1) double share,
            @ForAll @DoubleRange(min = -10, max = 10) double vx) {
        double a = share * (1 - e) * 60 / 3;
        Unit tank = new Unit(40).setPosition(5, 0).setVelocity(vx, 0).setMotor(50, 0, 40 * a);
        World world = room(integrator, e, tank);
        for (int tick = 0; tick < 200 * 60; tick++) world.step();
        for (int tick = 0; tick < 60; tick++) {
            world.step();
            assertEquals(RIGHT, tank.getX());
            assertEquals(0, tank.getSpeed());
        }
    }

    /** A unit that was placed outside the room and moves back into it keeps its velocity. */
    @Property
    void aWallDoesNotStopAUnitThatMovesAwayFromIt(
            @ForAll @DoubleRange(min = 20, max = 100) double start, @ForAll @DoubleRange(min = 2, max = 50) double v) {
        Unit unit = new Unit(1).setPosition(start, 0).setVelocity(-v, 0);
        room(Integrator.EXACT, 0.5, unit).step();
        assertEquals(-v, unit.getVx());
    }
}
