package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** The speed cap, at speeds from 1e-30 to the largest double. */
class SpeedCapPropertyTest {
    /** Of speeds, relatively: how far below its cap a unit may be that was cut to it. */
    private static final double ROUNDING = 10 * Math.ulp(1.0);

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
    void aVelocityPastTheCapIsCutToItAtOnceInTheSameDirection(
            @ForAll("velocities") double vx, @ForAll("velocities") double vy, @ForAll("caps") double cap) {
        assertCut(new Unit(1).setMaxSpeed(cap).setVelocity(vx, vy), vx, vy, cap);
    }

    @Property
    void loweringTheCapActsAtOnce(
            @ForAll("velocities") double vx, @ForAll("velocities") double vy, @ForAll("caps") double cap) {
        Unit unit = new Unit(1).setVelocity(vx, vy);
        double wasX = unit.getVx();
        double wasY = unit.getVy();
        assertCut(unit.setMaxSpeed(cap), wasX, wasY, cap);
    }

    @Property
    void anImpulsePastTheCapIsCutToIt(
            @ForAll("forces") double jx,
            @ForAll("forces") double jy,
            @ForAll("positive") double mass,
            @ForAll("caps") double cap) {
        Unit unit = new Unit(mass).setMaxSpeed(cap);
        unit.applyImpulse(jx, jy);
        assertCut(unit, jx / mass, jy / mass, cap);
    }

    @Property
    void noStepTakesAUnitPastItsCapOrFartherThanTheCapAllows(
            @ForAll Integrator how,
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
            unit.integrate(dt, how);
            assertUnder(unit, cap);
            double top = Math.min(cap, Kernel.FASTEST);
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
    void theCapOfTheFastestHoldsWhereThereIsNone(@ForAll("velocities") double vx, @ForAll("velocities") double vy) {
        Unit unit = new Unit(1).setVelocity(vx, vy);
        assertEquals(Double.POSITIVE_INFINITY, unit.getMaxSpeed());
        assertCut(unit, vx, vy, Kernel.FASTEST);
    }

    @Property
    void maxSpeedZeroPinsAUnitDown(
            @ForAll Integrator how,
            @ForAll("velocities") double vx,
            @ForAll("forces") double force,
            @ForAll("positive") double dt) {
        Unit unit = new Unit(1).setVelocity(vx, 1).setMaxSpeed(0);
        assertEquals(0.0, unit.getVx());
        assertEquals(0.0, unit.getVy());
        unit.setVelocity(1, vx);
        unit.applyImpulse(force, -force);
        unit.applyForce(-force, force);
        unit.integrate(dt, how);
        assertEquals(0.0, unit.getVx());
        assertEquals(0.0, unit.getVy());
        assertEquals(0.0, unit.getX());
        assertEquals(0.0, unit.getY());
    }

    @Property
    void aUnitSetToItsCapIsLeftSoAndAStepTakesRoundingErrorsOff(
            @ForAll Integrator how, @ForAll("velocities") double v) {
        Unit unit = new Unit(1).setVelocity(v, 0);
        double cap = unit.getSpeed();
        unit.setMaxSpeed(cap);
        assertEquals(cap, unit.getSpeed());
        for (int i = 0; i < 100; i++) unit.integrate(1, how);
        assertTrue(
                unit.getSpeed() <= cap && unit.getSpeed() >= cap * (1 - ROUNDING), () -> unit.getSpeed() + " " + cap);
    }

    private static void assertCut(Unit unit, double vx, double vy, double cap) {
        assertUnder(unit, cap);
        // At its cap, if it was faster, to a few rounding errors; as it was, if it was slower.
        BigDecimal was = squared(vx, vy);
        BigDecimal least = was.min(big(Math.min(cap, Kernel.FASTEST)).pow(2)).multiply(big(1 - 2 * ROUNDING));
        assertTrue(squared(unit.getVx(), unit.getVy()).compareTo(least) >= 0, () -> unit + " with a cap of " + cap);
        // vx' : vy' = vx : vy, to what the two products round by (or to a component that is rest)
        BigDecimal left = big(unit.getVx()).multiply(big(vy));
        BigDecimal right = big(unit.getVy()).multiply(big(vx));
        BigDecimal slack = left.abs().max(right.abs()).multiply(big(4 * Math.ulp(1.0)));
        boolean rest = Math.abs(unit.getVx()) < Kernel.REST || Math.abs(unit.getVy()) < Kernel.REST;
        assertTrue(rest || left.subtract(right).abs().compareTo(slack) <= 0, () -> unit + " from " + vx + ", " + vy);
        assertTrue(unit.getVx() * Math.signum(vx) >= 0 && unit.getVy() * Math.signum(vy) >= 0);
        if (vx != 0 && Math.abs(vx) >= Math.abs(vy)) assertTrue(unit.getVx() != 0, "the larger component is kept");
    }

    /** Exactly, and as getSpeed reports it. */
    private static void assertUnder(Unit unit, double cap) {
        assertTrue(unit.getSpeed() <= cap, () -> unit + " with a cap of " + cap);
        // Where nothing was cut, the speed may be over the cap by what getSpeed cannot tell.
        BigDecimal limit = big(Math.min(cap, Kernel.FASTEST)).multiply(big(1 + Math.ulp(1.0)));
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
