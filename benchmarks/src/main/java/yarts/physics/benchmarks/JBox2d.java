package yarts.physics.benchmarks;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;

/** JBox2D, with bodies without shapes, so that nothing can collide. */
final class JBox2d implements Peer {
    private static final Vec2 FORCE = new Vec2((float) Workload.FX, (float) Workload.FY);

    private final World world = new World(new Vec2());
    private final Body[] bodies;

    JBox2d(Army army) {
        world.setContinuousPhysics(false);
        bodies = new Body[army.size];
        for (int i = 0; i < army.size; i++) {
            BodyDef def = new BodyDef();
            def.type = BodyType.DYNAMIC;
            def.allowSleep = false;
            def.fixedRotation = true;
            def.linearDamping = (float) (army.friction[i] / army.mass[i]);
            def.linearVelocity.set((float) army.vx[i], (float) army.vy[i]);
            MassData mass = new MassData();
            mass.mass = (float) army.mass[i];
            bodies[i] = world.createBody(def);
            bodies[i].setMassData(mass);
        }
    }

    @Override
    public void step() {
        for (Body body : bodies) body.applyForceToCenter(FORCE);
        world.step((float) Workload.DT, 1, 1);
    }

    @Override
    public double x(int i) {
        return bodies[i].getPosition().x;
    }

    @Override
    public double y(int i) {
        return bodies[i].getPosition().y;
    }

    @Override
    public double vx(int i) {
        return bodies[i].getLinearVelocity().x;
    }

    @Override
    public double vy(int i) {
        return bodies[i].getLinearVelocity().y;
    }
}
