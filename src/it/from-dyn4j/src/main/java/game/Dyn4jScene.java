package game;

import org.dyn4j.dynamics.Body;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

// tag::dyn4j[]
/** A buggy at full throttle, and a shell in flight, in dyn4j. */
final class Dyn4jScene implements Scene {
    private final World<Body> world = new World<>();
    private final Body buggy = body(1_000, 2), shell = body(50, 0.1);

    Dyn4jScene(int stepsPerSecond, double friction) {
        world.setGravity(World.ZERO_GRAVITY); // seen from above
        world.getSettings().setStepFrequency(1.0 / stepsPerSecond);
        buggy.setLinearDamping(friction / 1_000); // 1/s
        shell.translate(0, 100);
        shell.setLinearVelocity(30, 40);
        world.addBody(buggy);
        world.addBody(shell);
    }

    private static Body body(double mass, double radius) {
        Body body = new Body();
        body.addFixture(Geometry.createCircle(radius), mass / (Math.PI * radius * radius));
        body.setMass(MassType.FIXED_ANGULAR_VELOCITY); // does not turn
        return body;
    }

    @Override
    public void frame(double elapsed) {
        buggy.applyForce(new Vector2(30_000, 0)); // N, for the next step
        world.update(elapsed, 15);
    }

    @Override
    public void hit(double jx, double jy) {
        shell.applyImpulse(new Vector2(jx, jy));
    }

    @Override
    public Motion buggy() {
        return motion(buggy);
    }

    @Override
    public Motion shell() {
        return motion(shell);
    }

    private static Motion motion(Body body) {
        Vector2 p = body.getWorldCenter(), v = body.getLinearVelocity();
        return new Motion(p.x, p.y, v.x, v.y);
    }
}
// end::dyn4j[]
