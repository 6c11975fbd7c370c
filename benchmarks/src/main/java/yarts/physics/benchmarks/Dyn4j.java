package yarts.physics.benchmarks;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

/** dyn4j, with bodies without shapes, so that nothing can collide. */
final class Dyn4j implements Peer {
    private static final Vector2 FORCE = new Vector2(Workload.FX, Workload.FY);

    private final World<Body> world = new World<>();

    Dyn4j(Army army) {
        world.setGravity(World.ZERO_GRAVITY);
        world.getSettings().setStepFrequency(Workload.DT);
        world.getSettings().setAtRestDetectionEnabled(false);
        world.getSettings().setContinuousDetectionMode(ContinuousDetectionMode.NONE);
        for (int i = 0; i < army.size; i++) {
            Body body = new Body();
            body.setMass(new Mass(new Vector2(), army.mass[i], 0));
            body.setLinearDamping(army.friction[i] / army.mass[i]);
            body.setLinearVelocity(army.vx[i], army.vy[i]);
            world.addBody(body);
        }
    }

    @Override
    public void step() {
        for (Body body : world.getBodies()) body.applyForce(FORCE);
        world.step(1);
    }

    @Override
    public double x(int i) {
        return world.getBody(i).getTransform().getTranslationX();
    }

    @Override
    public double y(int i) {
        return world.getBody(i).getTransform().getTranslationY();
    }

    @Override
    public double vx(int i) {
        return world.getBody(i).getLinearVelocity().x;
    }

    @Override
    public double vy(int i) {
        return world.getBody(i).getLinearVelocity().y;
    }
}
