package yarts.physics.comparison;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.FrictionJointDef;

final class JBox2d implements Engine {
    static {
        // As in a game, which runs without -ea: in tests, its assertions would stop what they do not stop there.
        JBox2d.class.getClassLoader().setPackageAssertionStatus("org.jbox2d", false);
    }

    private final World world = new World(new Vec2());

    @Override
    public Body add(double mass, double friction, double x, double v) {
        BodyDef def = new BodyDef();
        def.type = BodyType.DYNAMIC;
        def.allowSleep = false;
        def.linearDamping = (float) Engine.damping(friction, mass);
        def.position.set((float) x, 0);
        def.linearVelocity.set((float) v, 0);
        CircleShape disc = new CircleShape();
        disc.m_radius = 0.5f;
        MassData data = new MassData();
        data.mass = (float) mass;
        data.I = 1;
        org.jbox2d.dynamics.Body body = world.createBody(def);
        body.createFixture(disc, 1).setRestitution(1);
        body.setMassData(data);
        return new Body() {
            @Override
            public void push(double force) {
                body.applyForceToCenter(new Vec2((float) force, 0));
            }

            @Override
            public double x() {
                return body.getPosition().x;
            }

            @Override
            public double v() {
                return body.getLinearVelocity().x;
            }

            @Override
            public void stop() {
                body.setLinearVelocity(new Vec2());
            }

            @Override
            public Drive drive(double maxForce) {
                org.jbox2d.dynamics.Body ground = ground();
                FrictionJointDef def = new FrictionJointDef();
                def.initialize(ground, body, body.getWorldCenter());
                def.maxForce = (float) maxForce;
                world.createJoint(def);
                return u -> ground.setLinearVelocity(new Vec2((float) u, 0));
            }
        };
    }

    /** A body without a shape, which nothing stops. */
    private org.jbox2d.dynamics.Body ground() {
        BodyDef def = new BodyDef();
        def.type = BodyType.KINEMATIC;
        return world.createBody(def);
    }

    @Override
    public void step(double dt) {
        world.step((float) dt, 8, 3);
    }

    @Override
    public Engine keepingForces() {
        world.setAutoClearForces(false);
        return this;
    }

    @Override
    public void endFrame() {
        if (!world.getAutoClearForces()) world.clearForces();
    }
}
