package game;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;

// tag::jbox2d[]
/** A buggy at full throttle, and a shell in flight, in JBox2D. */
final class JBox2dScene implements Scene {
    private final World world = new World(new Vec2(0, 0)); // no gravity: seen from above
    private final Body buggy = body(0, 0, 1_000, 2), shell = body(0, 100, 50, 0.1f);
    private final double dt;
    private double time; // s, that no step covers yet

    JBox2dScene(int stepsPerSecond, double friction) {
        dt = 1.0 / stepsPerSecond;
        buggy.setLinearDamping((float) friction / 1_000); // 1/s
        shell.setLinearVelocity(new Vec2(30, 40));
    }

    private Body body(float x, float y, float mass, float radius) {
        BodyDef def = new BodyDef();
        def.type = BodyType.DYNAMIC;
        def.position.set(x, y);
        def.fixedRotation = true; // does not turn
        Body body = world.createBody(def);
        CircleShape circle = new CircleShape();
        circle.m_radius = radius;
        body.createFixture(circle, mass / (float) (Math.PI * radius * radius));
        return body;
    }

    @Override
    public void frame(double elapsed) {
        buggy.applyForceToCenter(new Vec2(30_000, 0)); // N, for the next step
        for (time += elapsed; time >= dt; time -= dt) world.step((float) dt, 8, 3);
    }

    @Override
    public void hit(double jx, double jy) {
        shell.applyLinearImpulse(new Vec2((float) jx, (float) jy), shell.getWorldCenter());
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
        Vec2 p = body.getPosition(), v = body.getLinearVelocity();
        return new Motion(p.x, p.y, v.x, v.y);
    }
}
// end::jbox2d[]
