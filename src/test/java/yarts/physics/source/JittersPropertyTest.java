package yarts.physics.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.support.Doubles;

/**
 * The jitters, reproduced with {@link ArticleUnit}: the effect of z = f·dt/m on a unit whose friction is one more
 * force. Every property then checks that the same unit in the library has no jitters.
 */
class JittersPropertyTest {
    /** A million miles an hour; in m/s. */
    private static final double MILLION_MILES_AN_HOUR = 447_040;

    @Provide
    Arbitrary<Double> masses() {
        return Doubles.logUniform(1e-6, 1e9);
    }

    @Provide
    Arbitrary<Double> times() {
        return Doubles.logUniform(1e-4, 10);
    }

    @Provide
    Arbitrary<Double> speeds() {
        return Doubles.logUniform(1e-6, 1e6);
    }

    @Provide
    Arbitrary<Double> flipping() {
        return Doubles.logUniform(1.0001, 1.9999);
    }

    @Provide
    Arbitrary<Double> growing() {
        return Doubles.logUniform(2.001, 1e3);
    }

    @Provide
    Arbitrary<Double> turning() {
        return Doubles.logUniform(1.0001, 1e3);
    }

    @Property
    void zBetweenOneAndTwoChangesTheSignInEveryStepAndSlowsTheUnit(
            @ForAll("masses") double mass,
            @ForAll("times") double dt,
            @ForAll("speeds") double v,
            @ForAll("flipping") double z) {
        ArticleUnit article = article(mass, dt, z, v);
        for (int i = 0; i < 50 && Math.abs(article.vx) > 1e-300; i++) {
            double before = article.vx;
            article.integrate(dt);
            assertEquals(-Math.signum(before), Math.signum(article.vx), "from " + before + " to " + article.vx);
            assertTrue(Math.abs(article.vx) < Math.abs(before), "from " + before + " to " + article.vx);
        }
        assertSteady(mass, dt, z, v, 0);
    }

    @Property
    void withZAboveTwoTheSpeedGrowsWithoutBound(
            @ForAll("masses") double mass,
            @ForAll("times") double dt,
            @ForAll("speeds") double v,
            @ForAll("growing") double z) {
        ArticleUnit article = article(mass, dt, z, v);
        int doublings = (int) Math.ceil(Math.log(2) / Math.log(z - 1));
        for (int i = 0; i < 20; i++) {
            double before = article.vx;
            for (int k = 0; k < doublings; k++) article.integrate(dt);
            assertTrue(Math.abs(article.vx) > 1.99 * Math.abs(before), "from " + before + " to " + article.vx);
        }
        assertSteady(mass, dt, z, v, 0);
    }

    @Property
    void moreFrictionReversesTheUnitToAHigherSpeed(
            @ForAll("masses") double mass,
            @ForAll("times") double dt,
            @ForAll("speeds") double v,
            @ForAll("turning") double z1,
            @ForAll("turning") double z2) {
        double more = Math.max(z1, z2) * 1.000001;
        ArticleUnit worse = article(mass, dt, more, v);
        ArticleUnit bad = article(mass, dt, Math.min(z1, z2), v);
        worse.integrate(dt);
        bad.integrate(dt);
        assertTrue(worse.vx < bad.vx && bad.vx < 0, bad.vx + " and with more friction " + worse.vx);
        assertSteady(mass, dt, more, v, 0);
    }

    @Property
    void aLightPushAcceleratesAnUncappedUnitBeyondAMillionMilesAnHour(
            @ForAll("masses") double mass, @ForAll("times") double dt, @ForAll("growing") double z) {
        ArticleUnit article = article(mass, dt, z, 0);
        double push = 1e-3 * mass / dt; // for one step: a millimetre a second
        article.applyForce(push, 0);
        article.integrate(dt);
        assertEquals(1e-3, article.vx, 1e-12);
        double steps = Math.log(MILLION_MILES_AN_HOUR / 1e-3) / Math.log(z - 1) + 2;
        for (int i = 0; i < steps; i++) article.integrate(dt);
        assertTrue(Math.abs(article.vx) > MILLION_MILES_AN_HOUR, "v = " + article.vx);
        assertSteady(mass, dt, z, 1e-3, 0);
    }

    @Property
    void aCapBoundsTheSpeedButTheUnitContinuesToJitter(
            @ForAll("masses") double mass,
            @ForAll("times") double dt,
            @ForAll("speeds") double cap,
            @ForAll("growing") double z) {
        ArticleUnit article = article(mass, dt, z, cap / 2);
        article.maxSpeed = cap;
        for (int i = 0; i < 100; i++) {
            double before = article.vx;
            article.integrate(dt);
            assertEquals(-Math.signum(before), Math.signum(article.vx), "from " + before + " to " + article.vx);
            assertTrue(Math.abs(article.vx) <= cap * (1 + 1e-15), "v = " + article.vx);
            assertTrue(Math.abs(article.vx) > cap / 2 * (1 - 1e-12), "the oscillation decays: " + article.vx);
        }
    }

    @Property
    void underAConstantPushTheUnitOscillatesAroundTheTerminalSpeed(
            @ForAll("masses") double mass,
            @ForAll("times") double dt,
            @ForAll("speeds") double terminal,
            @ForAll("turning") double z) {
        ArticleUnit article = article(mass, dt, z, 0);
        double force = article.friction * terminal;
        double distance = -terminal;
        for (int i = 0; i < 10 && Math.abs(distance) > 1e-9 * terminal && Math.abs(distance) < 1e200; i++) {
            article.applyForce(force, 0);
            article.integrate(dt);
            double next = article.vx - terminal;
            assertTrue(next * distance < 0, "from F/f + " + distance + " to F/f + " + next);
            distance = next;
        }
        assertSteady(mass, dt, z, 0, force);
    }

    private static ArticleUnit article(double mass, double dt, double z, double v) {
        ArticleUnit article = new ArticleUnit(mass);
        article.friction = z * mass / dt;
        article.vx = v;
        return article;
    }

    /** In the library, every step moves v towards F/f, and not past it. */
    private static void assertSteady(double mass, double dt, double z, double v, double force) {
        for (Integrator integrator : Integrator.values()) {
            Unit unit = new Unit(mass).setFriction(z * mass / dt).setVelocity(v, 0);
            double terminal = force / unit.getFriction();
            for (int i = 0; i < 20; i++) {
                double before = unit.getVx();
                unit.applyForce(force, 0);
                unit.integrate(dt, integrator);
                double slack = 4 * Math.ulp(Math.max(Math.abs(before), terminal));
                assertTrue(
                        unit.getVx() >= Math.min(before, terminal) - slack
                                && unit.getVx() <= Math.max(before, terminal) + slack,
                        integrator + " from " + before + " to " + unit.getVx() + " with F/f = " + terminal);
            }
        }
    }
}
