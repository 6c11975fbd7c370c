package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** The speed cap, at speeds from 1e-30 to the largest double. */
class SpeedCapPropertyTest {
    /** The greatest relative distance of a reduced speed below the cap. */
    private static final double ROUNDING = 2.4e-15;

    @Provide
    Arbitrary<Double> velocities() {
        return Arbitraries.oneOf(
                Doubles.signedLogUniform(1e-30, Double.MAX_VALUE), Doubles.signedLogUniform(1e-3, 1e3));
    }

    @Provide
    Arbitrary<Double> caps() {
        return Arbitraries.oneOf(Doubles.logUniform(1e-30, Double.MAX_VALUE), Doubles.logUniform(1, 2));
    }

    @Provide
    Arbitrary<Double> forces() {
        return Doubles.signedLogUniform(1e-9, 1e50);
    }

    @Provide
    Arbitrary<Double> positive() {
        return Doubles.logUniform(1e-9, 1e9);
    }

    @Property
    void aVelocityAboveTheCapIsReducedAtOnceAndKeepsItsDirection(
            @ForAll("velocities") double vx, @ForAll("velocities") double vy, @ForAll("caps") double cap) {
        assertCut(new Unit(1).setMaxSpeed(cap).setVelocity(vx, vy), vx, vy, cap);
    }

    @Property
    void aLowerCapReducesTheVelocityAtOnce(
            @ForAll("velocities") double vx, @ForAll("velocities") double vy, @ForAll("caps") double cap) {
        Unit unit = new Unit(1).setVelocity(vx, vy);
        double wasX = unit.getVx();
        double wasY = unit.getVy();
        assertCut(unit.setMaxSpeed(cap), wasX, wasY, cap);
    }

    @Property
    void theCapLimitsTheEffectOfAnImpulse(
            @ForAll("forces") double jx,
            @ForAll("forces") double jy,
            @ForAll("positive") double mass,
            @ForAll("caps") double cap) {
        Unit unit = new Unit(mass).setMaxSpeed(cap);
        unit.applyImpulse(jx, jy);
        assertCut(unit, jx / mass, jy / mass, cap);
    }

    @Property
    void inNoStepDoesAUnitExceedItsCapOrMoveFartherThanTheCapAllows(
            @ForAll Integrator integrator,
            @ForAll("velocities") double vx,
            @ForAll("velocities") double vy,
            @ForAll("forces") double fx,
            @ForAll("forces") double fy,
            @ForAll("positive") double mass,
            @ForAll("positive") double dt,
            @ForAll("caps") double cap) {
        Unit unit = new Unit(mass).setMaxSpeed(cap).setVelocity(vx, vy);
        for (int i = 0; i < 20; i++) {
            unit.setPosition(0, 0);
            unit.applyForce(fx, fy);
            unit.integrate(dt, integrator);
            assertUnder(unit, cap);
            double top = Math.min(cap, Range.FASTEST);
            BigDecimal way = squared(unit.getX(), unit.getY());
            BigDecimal limit = big(top).multiply(big(dt)).multiply(big(1 + 4 * Math.ulp(1.0)));
            assertTrue(way.compareTo(limit.pow(2)) <= 0, () -> unit + " with a cap of " + cap);
        }
    }

    @Property
    void aPushAgainstTheCapKeepsTheDirectionOfThePush(
            @ForAll("forces") double fx, @ForAll("forces") double fy, @ForAll("caps") double cap) {
        Unit unit = new Unit(1).setMaxSpeed(cap);
        unit.applyForce(fx, fy);
        unit.integrate(1);
        assertCut(unit, fx, fy, cap);
    }

    @Property
    void theGreatestSpeedLimitsAUnitWithoutATopSpeed(@ForAll("velocities") double vx, @ForAll("velocities") double vy) {
        Unit unit = new Unit(1).setVelocity(vx, vy);
        assertEquals(Double.POSITIVE_INFINITY, unit.getMaxSpeed());
        assertCut(unit, vx, vy, Range.FASTEST);
    }

    @Property
    void aUnitWithATopSpeedOfZeroNeverMoves(
            @ForAll Integrator integrator,
            @ForAll("velocities") double vx,
            @ForAll("forces") double force,
            @ForAll("positive") double dt) {
        Unit unit = new Unit(1).setVelocity(vx, 1).setMaxSpeed(0);
        assertEquals(0.0, unit.getVx());
        assertEquals(0.0, unit.getVy());
        unit.setVelocity(1, vx);
        unit.applyImpulse(force, -force);
        unit.applyForce(-force, force);
        unit.integrate(dt, integrator);
        assertEquals(0.0, unit.getVx());
        assertEquals(0.0, unit.getVy());
        assertEquals(0.0, unit.getX());
        assertEquals(0.0, unit.getY());
    }

    /** For any rounding of its components. */
    @Property(tries = 3000)
    void aUnitAtItsCapIsChangedByNoSetterAndNoStep(
            @ForAll Integrator integrator, @ForAll("velocities") double vx, @ForAll("velocities") double vy) {
        Unit unit = new Unit(1).setVelocity(vx, vy);
        double cap = unit.getSpeed(), x = unit.getVx(), y = unit.getVy();
        unit.setMaxSpeed(cap);
        assertLeft(unit, x, y);
        assertEquals(cap, unit.getSpeed());
        unit.setVelocity(x, y);
        assertLeft(unit, x, y);
        for (int i = 0; i < 10; i++) unit.integrate(1, integrator);
        assertLeft(unit, x, y);
        assertEquals(cap, unit.getSpeed());
    }

    /** The cap changes a reduced velocity no further, and its speed is permanently the top speed. */
    @Property(tries = 3000)
    void aReducedSpeedIsTheTopSpeedAndIsNotReducedAgain(
            @ForAll Integrator integrator,
            @ForAll("velocities") double vx,
            @ForAll("velocities") double vy,
            @ForAll("forces") double fx,
            @ForAll("forces") double fy,
            @ForAll("caps") double cap) {
        if (cap > Range.FASTEST) return;
        Unit unit = new Unit(1).setMaxSpeed(cap).setVelocity(vx, vy);
        if (Math.hypot(vx, vy) > cap) assertTop(unit, cap);
        unit.applyImpulse(fx, fy);
        boolean past = unit.getSpeed() == cap;
        if (past) assertTop(unit, cap);
        unit.applyForce(fx, fy);
        unit.integrate(1, integrator);
        if (unit.getSpeed() == cap) assertTop(unit, cap);
        unit.setVelocity(0, 0);
        unit.applyForce(fx, fy);
        unit.integrate(1, integrator);
        if (Math.hypot(fx, fy) > 2 * cap) assertTop(unit, cap);
        double x = unit.getVx(), y = unit.getVy();
        unit.setMaxSpeed(cap).setVelocity(x, y).applyImpulse(0, 0);
        assertLeft(unit, x, y);
        for (int i = 0; i < 10; i++) unit.integrate(1, integrator);
        assertLeft(unit, x, y);
    }

    /** Also in a world, whose step handles many rows together. */
    @Property(tries = 50)
    void unitsOfAWorldAtTheirTopSpeedStayThere(@ForAll Integrator integrator, @ForAll long seed) {
        Random random = new Random(seed);
        World world = new World(integrator, Timestep.fixed(60));
        for (int i = 0; i < 2 * Tiles.TILE + 1; i++) {
            double cap = 0.1 + random.nextDouble();
            world.add(new Unit(1).setMaxSpeed(cap).setVelocity(9 * random.nextGaussian(), 9 * random.nextGaussian()));
        }
        world.removeIf(unit -> unit.getSpeed() < unit.getMaxSpeed());
        assertTrue(world.size() > Tiles.TILE);
        double[] before = new double[2 * world.size()], after = before.clone();
        world.copyVelocities(before, 0);
        for (int i = 0; i < 10; i++) {
            world.copyVelocities(before, 0);
            world.step(1);
            world.copyVelocities(after, 0);
            assertArrayEquals(before, after, "no force acts");
            world.applyForces(before, 0); // in the direction of motion
            world.step(0.5);
            for (Unit unit : world) assertTop(unit, unit.getMaxSpeed());
        }
    }

    private static void assertTop(Unit unit, double cap) {
        assertEquals(cap, unit.getSpeed());
        assertUnder(unit, cap);
        BigDecimal least = big(cap).multiply(big(1 - 4e-15)).pow(2); // as getSpeed states
        assertTrue(squared(unit.getVx(), unit.getVy()).compareTo(least) >= 0, () -> unit + " with a cap of " + cap);
    }

    private static void assertLeft(Unit unit, double vx, double vy) {
        assertEquals(vx, unit.getVx());
        assertEquals(vy, unit.getVy());
    }

    private static void assertCut(Unit unit, double vx, double vy, double cap) {
        assertUnder(unit, cap);
        // If it was faster: at its cap, to a few rounding errors. If it was slower: unchanged.
        BigDecimal was = squared(vx, vy);
        BigDecimal least = was.min(big(Math.min(cap, Range.FASTEST)).pow(2)).multiply(big(1 - 2 * ROUNDING));
        assertTrue(squared(unit.getVx(), unit.getVy()).compareTo(least) >= 0, () -> unit + " with a cap of " + cap);
        // vx' : vy' = vx : vy, to the rounding errors of the two products (or a component is rest)
        BigDecimal left = big(unit.getVx()).multiply(big(vy));
        BigDecimal right = big(unit.getVy()).multiply(big(vx));
        BigDecimal slack = left.abs().max(right.abs()).multiply(big(4 * Math.ulp(1.0)));
        boolean rest = Math.abs(unit.getVx()) < Range.REST || Math.abs(unit.getVy()) < Range.REST;
        assertTrue(rest || left.subtract(right).abs().compareTo(slack) <= 0, () -> unit + " from " + vx + ", " + vy);
        assertTrue(unit.getVx() * Math.signum(vx) >= 0 && unit.getVy() * Math.signum(vy) >= 0);
        if (vx != 0 && Math.abs(vx) >= Math.abs(vy)) assertTrue(unit.getVx() != 0, "the larger component is kept");
    }

    /** The exact speed, and the one that getSpeed returns. */
    private static void assertUnder(Unit unit, double cap) {
        assertTrue(unit.getSpeed() <= cap, () -> unit + " with a cap of " + cap);
        // A speed that was not reduced may exceed the cap by the rounding error of the kernel's comparison.
        BigDecimal limit = big(Math.min(cap, Range.FASTEST)).multiply(big(1 + Math.ulp(1.0)));
        assertTrue(
                squared(unit.getVx(), unit.getVy()).compareTo(limit.pow(2)) <= 0, () -> unit + " with a cap of " + cap);
    }

    private static BigDecimal squared(double x, double y) {
        return big(x).pow(2).add(big(y).pow(2));
    }

    private static BigDecimal big(double v) {
        return new BigDecimal(v);
    }
}
