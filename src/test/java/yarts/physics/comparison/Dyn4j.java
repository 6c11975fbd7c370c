package yarts.physics.comparison;

import org.dyn4j.dynamics.joint.FrictionJoint;
import org.dyn4j.dynamics.joint.MotorJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

final class Dyn4j implements Engine {
    final World<org.dyn4j.dynamics.Body> world = new World<>();

    Dyn4j() {
        world.setGravity(World.ZERO_GRAVITY);
        world.getSettings().setAtRestDetectionEnabled(false);
    }

    /** The cap that it has: the farthest that a body moves in a step; in metres. */
    Dyn4j withMaximumTranslation(double metres) {
        world.getSettings().setMaximumTranslation(metres);
        return this;
    }

    @Override
    public Body add(double mass, double friction, double x, double v) {
        org.dyn4j.dynamics.Body body = new org.dyn4j.dynamics.Body();
        body.addFixture(Geometry.createCircle(0.5)).setRestitution(1);
        body.setMass(new Mass(new Vector2(), mass, 1));
        body.setLinearDamping(Engine.damping(friction, mass));
        body.translate(x, 0);
        body.setLinearVelocity(v, 0);
        world.addBody(body);
        return new Body() {
            @Override
            public void push(double force) {
                body.applyForce(new Vector2(force, 0));
            }

            @Override
            public double x() {
                return body.getTransform().getTranslationX();
            }

            @Override
            public double v() {
                return body.getLinearVelocity().x;
            }

            @Override
            public void stop() {
                body.setLinearVelocity(0, 0);
            }

            @Override
            public Drive drive(double maxForce) {
                org.dyn4j.dynamics.Body ground = ground();
                FrictionJoint<org.dyn4j.dynamics.Body> joint = new FrictionJoint<>(body, ground, body.getWorldCenter());
                joint.setMaximumForce(maxForce);
                world.addJoint(joint);
                return u -> ground.setLinearVelocity(u, 0);
            }

            @Override
            public Drive drive(double maxForce, double correction) {
                org.dyn4j.dynamics.Body ground = ground();
                MotorJoint<org.dyn4j.dynamics.Body> joint = new MotorJoint<>(ground, body);
                joint.setMaximumForce(maxForce);
                joint.setCorrectionFactor(correction);
                world.addJoint(joint);
                if (correction == 0) return u -> ground.setLinearVelocity(u, 0);
                return new MovingTarget(x(), target -> joint.setLinearTarget(new Vector2(target, 0)));
            }
        };
    }

    /** A body of infinite mass and without a shape, which nothing stops. */
    private org.dyn4j.dynamics.Body ground() {
        org.dyn4j.dynamics.Body ground = new org.dyn4j.dynamics.Body();
        ground.setMass(MassType.INFINITE);
        world.addBody(ground);
        return ground;
    }

    @Override
    public void step(double dt) {
        world.step(1, dt);
    }
}
