package yarts.physics.comparison;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.Box2D;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.MassData;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.physics.box2d.joints.FrictionJointDef;
import com.badlogic.gdx.physics.box2d.joints.MotorJoint;
import com.badlogic.gdx.physics.box2d.joints.MotorJointDef;
import com.badlogic.gdx.utils.GdxNativesLoader;
import com.badlogic.gdx.utils.GdxRuntimeException;

/** libGDX's Box2D, which is native. */
final class GdxBox2d implements Engine {
    private final World world = new World(new Vector2(), true);

    /** {@return whether there is a native library for this machine} */
    static boolean isAvailable() {
        try {
            GdxNativesLoader.load(); // what a backend does in a game
            Box2D.init();
            return true;
        } catch (GdxRuntimeException | LinkageError e) {
            return false;
        }
    }

    static void assumeIsThere() {
        assumeTrue(
                isAvailable(),
                "gdx-box2d has no native library for " + System.getProperty("os.name") + " on "
                        + System.getProperty("os.arch"));
    }

    @Override
    public Body add(double mass, double friction, double x, double v) {
        BodyDef def = new BodyDef();
        def.type = BodyDef.BodyType.DynamicBody;
        def.allowSleep = false;
        def.linearDamping = (float) Engine.damping(friction, mass);
        def.position.set((float) x, 0);
        def.linearVelocity.set((float) v, 0);
        CircleShape disc = new CircleShape();
        disc.setRadius(0.5f);
        MassData data = new MassData();
        data.mass = (float) mass;
        data.I = 1;
        com.badlogic.gdx.physics.box2d.Body body = world.createBody(def);
        body.createFixture(disc, 1).setRestitution(1);
        body.setMassData(data);
        disc.dispose();
        return new Body() {
            @Override
            public void push(double force) {
                body.applyForceToCenter((float) force, 0, true);
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
                body.setLinearVelocity(0, 0);
            }

            @Override
            public Drive drive(double maxForce) {
                com.badlogic.gdx.physics.box2d.Body ground = ground();
                FrictionJointDef def = new FrictionJointDef();
                def.initialize(ground, body, body.getWorldCenter());
                def.maxForce = (float) maxForce;
                world.createJoint(def);
                return u -> ground.setLinearVelocity((float) u, 0);
            }

            @Override
            public Drive drive(double maxForce, double correction) {
                com.badlogic.gdx.physics.box2d.Body ground = ground();
                MotorJointDef def = new MotorJointDef();
                def.initialize(ground, body);
                def.maxForce = (float) maxForce;
                def.correctionFactor = (float) correction;
                MotorJoint joint = (MotorJoint) world.createJoint(def);
                if (correction == 0) return u -> ground.setLinearVelocity((float) u, 0);
                return new MovingTarget(x(), target -> joint.setLinearOffset(new Vector2((float) target, 0)));
            }
        };
    }

    /** A body without a shape, which nothing stops. */
    private com.badlogic.gdx.physics.box2d.Body ground() {
        BodyDef def = new BodyDef();
        def.type = BodyDef.BodyType.KinematicBody;
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
