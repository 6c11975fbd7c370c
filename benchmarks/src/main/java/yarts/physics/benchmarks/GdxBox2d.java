package yarts.physics.benchmarks;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.Box2D;
import com.badlogic.gdx.physics.box2d.MassData;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.utils.GdxNativesLoader;

/** The native Box2D of libGDX, with bodies without shapes, so that nothing can collide. */
final class GdxBox2d implements Peer {
    private final World world;
    private final Body[] bodies;

    GdxBox2d(Army army) {
        GdxNativesLoader.load(); // as a backend does in a game
        Box2D.init();
        world = new World(new Vector2(), false);
        world.setContinuousPhysics(false);
        bodies = new Body[army.size];
        for (int i = 0; i < army.size; i++) {
            BodyDef def = new BodyDef();
            def.type = BodyDef.BodyType.DynamicBody;
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
        for (Body body : bodies) body.applyForceToCenter((float) Workload.FX, (float) Workload.FY, true);
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
