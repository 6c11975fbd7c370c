package game;

import com.artemis.ComponentMapper;
import com.artemis.World;
import com.artemis.WorldConfigurationBuilder;
import com.artemis.annotations.All;
import com.artemis.systems.IteratingSystem;
import java.util.Random;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;

/** An artemis-odb game: tanks drive into a minefield, others follow; beside it the same battle in a plain world. */
public final class Game {
    private static final int TANKS = 50;
    private static final int FRAMES = 600;
    private static final double PUSH = 80_000; // N
    private static final double MINES = 80; // m east

    private final Physics physics = new Physics();
    private final World world = new World(
            new WorldConfigurationBuilder().with(new Orders(), physics).build());
    private final yarts.physics.World plain = new yarts.physics.World(Integrator.EXACT, Timestep.fixed(60));
    private int lost;

    public static void main(String[] args) {
        new Game().play();
    }

    private Game() {
        world.create(); // a tree
    }

    /** Drives all tanks at full throttle. Entities that it deletes are removed before the next system runs. */
    @All(Body.class)
    private static final class Orders extends IteratingSystem {
        private ComponentMapper<Body> bodies;

        @Override
        protected void process(int entity) {
            Unit unit = bodies.get(entity).unit;
            if (!isMined(unit)) drive(unit);
            else if (unit.getId() % 2 == 0) world.delete(entity);
            else bodies.remove(entity); // a wreck stays
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
            world.setDelta(delta);
            world.process();
            lost += plainly(delta);
            compare();
        }
        require(lost > TANKS / 4 && plain.size() > TANKS / 4, "some are lost, some not: " + lost);
        for (long id = 1; id <= TANKS; id++) if (plain.find(id) != null) near(physics.units.find(id));
        require(physics.getEntityIds().size() == plain.size(), "an entity for each unit");
        for (int i = plain.size() - 1; i >= 0; i--)
            world.delete(physics.getEntityIds().get(i));
        world.process();
        require(physics.units.size() == 0, "no entity, no unit");
        System.out.println(
                "artemis-odb: " + lost + " of " + (TANKS + FRAMES / 60) + " entities lost with their units in " + FRAMES
                        + " frames; the others as in a plain World to the bit, and where the closed form says");
    }

    private void deploy(int i) {
        world.edit(world.create()).create(Body.class).unit = physics.units.add(tank(i));
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
        require(physics.units.size() == plain.size(), "as many units");
        for (Unit unit : plain) {
            Unit other = physics.units.find(unit.getId());
            require(other != null, "the same are left");
            require(other.getX() == unit.getX() && other.getY() == unit.getY(), "the same places, to the bit");
            require(other.getVx() == unit.getVx() && other.getVy() == unit.getVy(), "the same velocities, to the bit");
        }
    }

    /** m dv/dt = F − f v from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f. */
    private void near(Unit unit) {
        double t = physics.units.getTime(), m = unit.getMass(), f = unit.getFriction();
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
