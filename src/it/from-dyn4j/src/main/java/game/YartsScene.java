package game;

import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

// tag::yarts[]
/** A buggy at full throttle, and a shell in flight, in yarts-physics. */
final class YartsScene implements Scene {
    private final World world;
    private final Unit buggy = new Unit(1_000), shell = new Unit(50);

    YartsScene(int stepsPerSecond, double friction) {
        world = new World(Integrator.EXACT, Timestep.fixed(stepsPerSecond));
        buggy.setFriction(friction); // N·s/m
        shell.setPosition(0, 100);
        shell.setVelocity(30, 40);
        world.add(buggy);
        world.add(shell);
    }

    @Override
    public void frame(double elapsed) {
        buggy.applyForce(30_000, 0); // N, for the frame
        world.advance(elapsed);
    }

    @Override
    public void hit(double jx, double jy) {
        shell.applyImpulse(jx, jy);
    }

    @Override
    public Motion buggy() {
        return motion(buggy);
    }

    @Override
    public Motion shell() {
        return motion(shell);
    }

    private static Motion motion(Unit unit) {
        return new Motion(unit.getX(), unit.getY(), unit.getVx(), unit.getVy());
    }
}
// end::yarts[]
