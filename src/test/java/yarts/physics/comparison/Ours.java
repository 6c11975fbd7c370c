package yarts.physics.comparison;

import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The library. */
final class Ours implements Engine {
    final World world;
    private final double maxSpeed;

    Ours(Integrator integrator) {
        this(integrator, Double.POSITIVE_INFINITY);
    }

    Ours(Integrator integrator, double maxSpeed) {
        this.world = new World(integrator, Timestep.fixed(60));
        this.maxSpeed = maxSpeed;
    }

    @Override
    public Body add(double mass, double friction, double x, double v) {
        Unit unit = world.add(
                new Unit(mass).setFriction(friction).setMaxSpeed(maxSpeed).setPosition(x, 0));
        unit.setVelocity(v, 0);
        return new Body() {
            @Override
            public void push(double force) {
                unit.applyForce(force, 0);
            }

            @Override
            public double x() {
                return unit.getX();
            }

            @Override
            public double v() {
                return unit.getVx();
            }

            @Override
            public void stop() {
                unit.setVelocity(0, 0);
            }

            @Override
            public Drive drive(double maxForce) {
                return u -> unit.setMotor(u, 0, maxForce);
            }
        };
    }

    @Override
    public void step(double dt) {
        world.step(dt);
    }
}
