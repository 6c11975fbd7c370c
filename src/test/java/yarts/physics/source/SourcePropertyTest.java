package yarts.physics.source;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.support.Doubles;

/** Without friction, each step of the library follows the source's own rule. */
class SourcePropertyTest {
    /** A force, and the time for which it acts. */
    private record Push(double fx, double fy, double dt) {}

    @Provide
    Arbitrary<List<Push>> pushes() {
        Arbitrary<Double> forces = Doubles.signedLogUniform(1e-3, 1e6);
        return Combinators.combine(forces, forces, Doubles.logUniform(1e-4, 1))
                .as(Push::new)
                .list()
                .ofMaxSize(50);
    }

    @Provide
    Arbitrary<Double> masses() {
        return Doubles.logUniform(1e-3, 1e6);
    }

    @Provide
    Arbitrary<Double> speeds() {
        return Doubles.signedLogUniform(1e-3, 1e3);
    }

    @Provide
    Arbitrary<Double> caps() {
        return Arbitraries.oneOf(Doubles.logUniform(1e-2, 1e4), Arbitraries.just(Double.POSITIVE_INFINITY));
    }

    @Property
    void eulerGivesTheSourcesVelocitiesAndPositions(
            @ForAll("pushes") List<Push> pushes,
            @ForAll("masses") double mass,
            @ForAll("speeds") double vx,
            @ForAll("speeds") double vy,
            @ForAll("caps") double maxSpeed) {
        compare(Integrator.EULER, pushes, mass, vx, vy, maxSpeed);
    }

    @Property
    void midpointGivesTheSourcesVelocitiesAndPositions(
            @ForAll("pushes") List<Push> pushes,
            @ForAll("masses") double mass,
            @ForAll("speeds") double vx,
            @ForAll("speeds") double vy,
            @ForAll("caps") double maxSpeed) {
        compare(Integrator.MIDPOINT, pushes, mass, vx, vy, maxSpeed);
    }

    private static void compare(
            Integrator integrator, List<Push> pushes, double mass, double vx, double vy, double maxSpeed) {
        Unit unit = new Unit(mass).setVelocity(vx, vy);
        ArticleUnit article = new ArticleUnit(mass);
        article.vx = vx;
        article.vy = vy;
        if (Math.sqrt(vx * vx + vy * vy) <= maxSpeed) {
            unit.setMaxSpeed(maxSpeed);
            article.maxSpeed = maxSpeed;
        }
        double speed = Math.abs(vx) + Math.abs(vy); // the largest so far, the scale of rounding errors
        double way = 0;
        for (Push push : pushes) {
            unit.applyForce(push.fx, push.fy);
            article.applyForce(push.fx, push.fy);
            double before = Math.abs(article.vx) + Math.abs(article.vy);
            double gained = (Math.abs(push.fx) + Math.abs(push.fy)) / mass * push.dt;
            unit.integrate(push.dt, integrator);
            if (integrator == Integrator.EULER) article.integrate(push.dt);
            else article.integrateMidpoint(push.dt);
            speed = Math.max(speed, before + gained);
            way += speed * push.dt;
            assertEquals(article.vx, unit.getVx(), 1e-13 * speed);
            assertEquals(article.vy, unit.getVy(), 1e-13 * speed);
            assertEquals(article.x, unit.getX(), 1e-13 * way);
            assertEquals(article.y, unit.getY(), 1e-13 * way);
        }
    }
}
