package game;

import com.badlogic.ashley.core.Engine;
import com.badlogic.ashley.core.Entity;
import com.badlogic.ashley.core.Family;
import com.badlogic.ashley.systems.IteratingSystem;
import java.util.Random;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** An Ashley game: tanks drive into a minefield, others follow; beside it the same battle in a plain world. */
public final class Game {
    private static final int TANKS = 50;
    private static final int FRAMES = 600;
    private static final double PUSH = 80_000; // N
    private static final double MINES = 80; // m east

    private final Engine engine = new Engine();
    private final Physics physics = new Physics();
    private final World plain = new World(Integrator.EXACT, Timestep.fixed(60));
    private int lost;

    public static void main(String[] args) {
        new Game().play();
    }

    private Game() {
        Family bodies = Family.all(Body.class).get();
        engine.addSystem(new Orders(bodies)); // systems of equal priority run in the order in which they are added
        engine.addSystem(physics);
        engine.addEntityListener(bodies, physics);
        engine.addEntity(new Entity()); // a tree
    }

    /** Drives all tanks at full throttle. While a system runs, the engine delays removals until the system ends. */
    private static final class Orders extends IteratingSystem {
        Orders(Family bodies) {
            super(bodies);
        }

        @Override
        protected void processEntity(Entity entity, float deltaTime) {
            Unit unit = entity.getComponent(Body.class).unit();
            if (isMined(unit)) getEngine().removeEntity(entity);
            else drive(unit);
        }
    }

    private static Unit tank(int i) {
        return new Unit(20_000 + 1_000 * i).setFriction(8_000);
    }

    private static boolean isMined(Unit unit) {
        return unit.getX() > MINES;
    }

    private static void drive(Unit unit) {
        unit.applyForce(PUSH, PUSH / 2);
    }

    private void play() {
        Random random = new Random(1);
        for (int i = 0; i < TANKS; i++) deploy(i);
        for (int frame = 0; frame < FRAMES; frame++) {
            if (frame % 60 == 30) deploy(frame / 60);
            float delta = 0.004f + 0.036f * random.nextFloat(); // s
            engine.update(delta);
            lost += plainly(delta);
            compare();
        }
        require(lost > TANKS / 4 && plain.size() > TANKS / 4, "some are lost, some not: " + lost);
        for (long id = 1; id <= TANKS; id++) if (plain.find(id) != null) near(physics.world.find(id));
        require(engine.getEntities().size() == 1 + plain.size(), "an entity for each unit, and a tree");
        engine.removeAllEntities();
        require(physics.world.size() == 0, "no entity, no unit");
        System.out.println("ashley: " + lost + " of " + (TANKS + FRAMES / 60) + " entities removed with their units in "
                + FRAMES + " frames; the others as in a plain World to the bit, and where the closed form says");
    }

    private void deploy(int i) {
        engine.addEntity(new Entity().add(new Body(physics.world.add(tank(i)))));
        plain.add(tank(i));
    }

    /** Runs the same frame without an engine, and returns the number of tanks that are lost. */
    private int plainly(float delta) {
        int before = plain.size();
        plain.removeIf(Game::isMined);
        plain.forEach(Game::drive);
        plain.advance(delta);
        return before - plain.size();
    }

    private void compare() {
        require(physics.world.size() == plain.size(), "as many units");
        for (Unit unit : plain) {
            Unit other = physics.world.find(unit.getId());
            require(other != null, "the same are left");
            require(other.getX() == unit.getX() && other.getY() == unit.getY(), "the same places, to the bit");
            require(other.getVx() == unit.getVx() && other.getVy() == unit.getVy(), "the same velocities, to the bit");
        }
    }

    /** m dv/dt = F − f v from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f. */
    private void near(Unit unit) {
        double t = physics.world.getTime(), m = unit.getMass(), f = unit.getFriction();
        double v = PUSH / f * -Math.expm1(-f * t / m);
        double x = (PUSH * t - m * v) / f;
        require(Math.abs(unit.getVx() - v) <= 1e-9 * v, "the speed: expected " + v + ", was " + unit.getVx());
        require(Math.abs(unit.getX() - x) <= 1e-9 * x, "the way: expected " + x + ", was " + unit.getX());
        require(Math.abs(unit.getY() - x / 2) <= 1e-9 * x, "the way north: expected " + x / 2 + ", was " + unit.getY());
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
