package yarts.physics.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The same unit in the engines that Java games use: m = 1 kg, pushed by F = 10 N, damped by f = 10 N·s/m, so that F/f
 * is 1 m/s. They damp after they add the force: a terminal speed that depends on the tick rate, and 0 from z = 1 on.
 */
class PeersTest {
    private static final double FORCE = 10;
    private static final double FRICTION = 10;

    /** Velocity after a number of steps of dt from rest under FORCE. */
    private interface Engine {
        double push(double dt, int steps);
    }

    private record Peer(String name, Engine engine) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Peer> peers() {
        return List.of(new Peer("dyn4j", PeersTest::dyn4j), new Peer("JBox2D", PeersTest::jbox2d));
    }

    @ParameterizedTest
    @MethodSource("peers")
    void aPeersTerminalSpeedDependsOnTheTickRate(Peer peer) {
        for (double dt : new double[] {1 / 240.0, 1 / 120.0, 1 / 60.0, 1 / 20.0}) {
            double z = FRICTION * dt;
            assertEquals((1 - z) * FORCE / FRICTION, peer.engine.push(dt, 5000), 1e-5, "z = " + z);
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void aPeerFreezesAThrustingUnitFromZOneOn(Peer peer) {
        for (double dt : new double[] {0.1, 0.2, 0.5}) assertEquals(0, peer.engine.push(dt, 100), 1e-6, "dt = " + dt);
    }

    @ParameterizedTest
    @EnumSource
    void oursIsForceOverFrictionAtEveryTickRate(Integrator integrator) {
        for (double dt : new double[] {1 / 240.0, 1 / 120.0, 1 / 60.0, 1 / 20.0, 0.1, 0.2, 0.5, 10}) {
            assertEquals(FORCE / FRICTION, ours(integrator, dt, 5000), 1e-12, "dt = " + dt);
        }
    }

    @ParameterizedTest
    @MethodSource("peers")
    void atHighTickRatesAllAgree(Peer peer) {
        double dt = 1e-4;
        int steps = 1000; // 0.1 s, in which v gets to 63 % of F/f
        double theirs = peer.engine.push(dt, steps);
        for (Integrator integrator : Integrator.values()) {
            assertEquals(theirs, ours(integrator, dt, steps), 2 * FRICTION * dt, integrator.toString());
            assertTrue(ours(integrator, dt, steps) > 0.6);
        }
    }

    private static double ours(Integrator integrator, double dt, int steps) {
        World world = new World(integrator, Timestep.fixed(60));
        Unit unit = world.add(new Unit(1).setFriction(FRICTION));
        for (int i = 0; i < steps; i++) {
            unit.applyForce(FORCE, 0);
            world.step(dt);
        }
        return unit.getVx();
    }

    private static double dyn4j(double dt, int steps) {
        org.dyn4j.world.World<Body> world = new org.dyn4j.world.World<>();
        world.setGravity(0, 0);
        Body body = new Body();
        body.addFixture(Geometry.createCircle(0.5), 1 / (Math.PI * 0.25));
        body.setMass(MassType.NORMAL);
        body.setLinearDamping(FRICTION);
        body.setAtRestDetectionEnabled(false);
        world.addBody(body);
        world.getSettings().setStepFrequency(dt);
        world.getSettings().setMaximumTranslation(1e9);
        for (int i = 0; i < steps; i++) {
            body.applyForce(new org.dyn4j.geometry.Vector2(FORCE, 0));
            world.step(1, dt);
        }
        return body.getLinearVelocity().x;
    }

    private static double jbox2d(double dt, int steps) {
        org.jbox2d.dynamics.World world = new org.jbox2d.dynamics.World(new Vec2(0, 0));
        BodyDef def = new BodyDef();
        def.type = BodyType.DYNAMIC;
        def.linearDamping = (float) FRICTION;
        def.allowSleep = false;
        org.jbox2d.dynamics.Body body = world.createBody(def);
        CircleShape circle = new CircleShape();
        circle.m_radius = 0.5f;
        body.createFixture(circle, (float) (1 / (Math.PI * 0.25)));
        for (int i = 0; i < steps; i++) {
            body.applyForceToCenter(new Vec2((float) FORCE, 0));
            world.step((float) dt, 1, 1);
        }
        return body.getLinearVelocity().x;
    }
}
