package yarts.physics.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Unit;

/**
 * Every statement and every number of the source's physics chapter as a named test. {@link ArticleUnit} is the
 * chapter's rule; the numbers are the chapter's: v = 10 m/s, f = 10 N·s/m, m = 1 kg.
 */
class SourceTest {
    /** A million miles an hour; in m/s. */
    private static final double MILLION_MILES_AN_HOUR = 447_040;

    @Test
    void forcesAddUpUntilTheyAreIntegrated() {
        Unit unit = new Unit(2);
        unit.applyForce(3, -1);
        unit.applyForce(5, 4);
        assertEquals(8, unit.getFx());
        assertEquals(3, unit.getFy());
    }

    @Test
    void integrateUsesTheForcesAndThenClearsThem() {
        Unit unit = new Unit(2);
        unit.applyForce(8, 4);
        unit.integrate(0.5);
        assertEquals(2, unit.getVx());
        assertEquals(1, unit.getVy());
        assertEquals(0, unit.getFx());
        assertEquals(0, unit.getFy());
        unit.integrate(0.5);
        assertEquals(2, unit.getVx(), "a force acts once");
    }

    @Test
    void eulerMovesByTheVelocityAtTheStartOfTheStep() {
        Unit unit = new Unit(1).setVelocity(2, -1);
        unit.applyForce(8, 8);
        unit.integrate(0.5);
        assertEquals(1, unit.getX());
        assertEquals(-0.5, unit.getY());
        assertEquals(6, unit.getVx());
        assertEquals(3, unit.getVy());
    }

    @Test
    void midpointMovesByTheAverageOfTheVelocities() {
        Unit unit = new Unit(1).setVelocity(2, -1);
        unit.applyForce(8, 8);
        unit.integrate(0.5, Integrator.MIDPOINT);
        assertEquals((2 + 6) / 2.0 * 0.5, unit.getX());
        assertEquals((-1 + 3) / 2.0 * 0.5, unit.getY());
    }

    @Test
    void theMassMustNotBeZero() {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> new Unit(0));
        assertTrue(e.getMessage().contains("mass must be") && e.getMessage().contains("not zero"), e.getMessage());
        assertTrue(e.getMessage().endsWith("was 0.0"), e.getMessage());
    }

    @Test
    void aPushedUnitNeverTurns() {
        // A force has no point of application: it moves the unit in its direction, and changes nothing else.
        Unit unit = new Unit(3).setFriction(1);
        for (int i = 0; i < 100; i++) {
            unit.applyForce(7, 0);
            unit.integrate(0.1);
            assertEquals(0, unit.getY());
            assertEquals(0, unit.getVy());
        }
        assertTrue(unit.getX() > 0);
    }

    @Test
    void theSpeedCapComparesSquaresAndKeepsTheDirection() {
        Unit unit = new Unit(1).setMaxSpeed(5);
        unit.setVelocity(3, 4);
        assertEquals(3, unit.getVx(), "at the cap, nothing changes");
        assertEquals(4, unit.getVy());
        unit.setVelocity(30, 40);
        assertEquals(3, unit.getVx(), 1e-14);
        assertEquals(4, unit.getVy(), 1e-14);
    }

    @Test
    void timestepsMayVaryFromStepToStep() {
        Unit unit = new Unit(1);
        ArticleUnit article = new ArticleUnit(1);
        for (double dt : new double[] {0.25, 0.5, 0.125, 1, 0.0625}) {
            unit.applyForce(2, -4);
            article.applyForce(2, -4);
            unit.integrate(dt);
            article.integrate(dt);
            assertEquals(article.x, unit.getX());
            assertEquals(article.vx, unit.getVx());
            assertEquals(article.y, unit.getY());
            assertEquals(article.vy, unit.getVy());
        }
    }

    @Test
    void naiveFrictionStopsTheUnitAtOnceInAStepOfATenthOfASecond() {
        assertEquals(0, naive(0.1, 10).vx, 1e-15);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.101, 0.11, 0.15, 0.19})
    void naiveFrictionReversesTheUnitInALongerStepThanATenthOfASecond(double dt) {
        double vx = naive(dt, 10).vx;
        assertTrue(vx < 0, "v = " + vx);
        assertTrue(vx > -10, "faster than before: v = " + vx);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.21, 0.25, 0.3})
    void naiveFrictionAcceleratesTheUnitInALongerStepThanTwoTenthsOfASecond(double dt) {
        ArticleUnit article = naive(dt, 10);
        assertTrue(article.vx < -10, "v = " + article.vx);
        for (int i = 0; i < 1000; i++) article.integrate(dt);
        assertTrue(Math.abs(article.vx) > 1e40, "v = " + article.vx);
    }

    @Test
    void moreFrictionMakesTheJittersWorse() {
        double before = 0;
        for (double friction : new double[] {11, 15, 20, 30, 100}) {
            double back = -naive(0.1, friction).vx;
            assertTrue(back > before, "friction " + friction + " reverses the unit to " + back);
            before = back;
        }
    }

    @Test
    void aLightPushAcceleratesAnUncappedUnitToAMillionMilesAnHour() {
        ArticleUnit article = new ArticleUnit(1);
        article.friction = 10;
        article.applyForce(1, 0); // a light push, once
        int steps = 0;
        while (Math.abs(article.vx) < MILLION_MILES_AN_HOUR && steps < 1000) {
            article.integrate(0.25);
            steps++;
        }
        assertTrue(Math.abs(article.vx) >= MILLION_MILES_AN_HOUR, "v = " + article.vx);
        assertTrue(steps < 60, "it takes too long: " + steps + " steps");

        for (Integrator integrator : Integrator.values()) {
            Unit unit = new Unit(1).setFriction(10);
            unit.applyForce(1, 0);
            for (int i = 0; i < steps; i++) {
                unit.integrate(0.25, integrator);
                assertTrue(unit.getVx() >= 0 && unit.getVx() <= 0.1, integrator + ": v = " + unit.getVx());
            }
        }
    }

    @Test
    void aCapBoundsTheJittersButDoesNotRemoveThem() {
        ArticleUnit article = new ArticleUnit(1);
        article.friction = 30;
        article.maxSpeed = 15;
        article.vx = 10;
        for (int i = 0; i < 100; i++) {
            double before = article.vx;
            article.integrate(0.1);
            assertTrue(Math.abs(article.vx) <= 15 * (1 + 1e-15), "v = " + article.vx);
            assertTrue(article.vx * before < 0, "it does not reverse in this step");
        }
        assertNotEquals(0, article.vx);
    }

    @ParameterizedTest
    @EnumSource
    void theLibraryNeverReversesTheUnit(Integrator integrator) {
        for (double dt : new double[] {0.05, 0.1, 0.101, 0.15, 0.2, 0.25, 0.3, 10}) {
            Unit unit = new Unit(1).setFriction(10).setVelocity(10, 0);
            double before = unit.getVx();
            for (int i = 0; i < 1000; i++) {
                unit.integrate(dt, integrator);
                assertTrue(unit.getVx() >= 0 && unit.getVx() <= before, "dt = " + dt + ": v = " + unit.getVx());
                before = unit.getVx();
            }
            assertTrue(before < 1e-100, "dt = " + dt + ": v = " + before);
        }
    }

    /** One step of the naive rule from v = 10, m = 1. */
    private static ArticleUnit naive(double dt, double friction) {
        ArticleUnit article = new ArticleUnit(1);
        article.friction = friction;
        article.vx = 10;
        article.integrate(dt);
        return article;
    }
}
