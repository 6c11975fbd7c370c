package game;

import dev.dominion.ecs.api.Dominion;
import dev.dominion.ecs.api.Entity;
import dev.dominion.ecs.api.Results;
import dev.dominion.ecs.api.Scheduler;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A Dominion game: tanks drive into a minefield, others follow; beside it the same battle in a plain world. */
public final class Game {
    private static final int TANKS = 50;
    private static final int FRAMES = 600;
    private static final double PUSH = 80_000; // N
    private static final double MINES = 80; // m east

    private final Dominion dominion = Dominion.create();
    private final Scheduler scheduler = dominion.createScheduler();
    private final World world = new World(Integrator.EXACT, Timestep.fixed(60));
    private final World plain = new World(Integrator.EXACT, Timestep.fixed(60));
    private final Map<Unit, Entity> entities = new HashMap<>();
    private int lost;

    public static void main(String[] args) {
        Game game = new Game();
        try {
            game.play();
        } finally {
            game.scheduler.shutDown(); // its threads would keep a game that failed alive
        }
    }

    /** Systems run one after the other, in threads of the scheduler. */
    private Game() {
        scheduler.schedule(this::order);
        scheduler.schedule(new Physics(scheduler, world, entities));
        dominion.createEntity("a tree");
    }

    /** Full throttle. */
    private void order() {
        List<Entity> mined = new ArrayList<>();
        for (Results.With1<Unit> found : dominion.findEntitiesWith(Unit.class)) {
            if (isMined(found.comp())) mined.add(found.entity());
            else drive(found.comp());
        }
        mined.forEach(dominion::deleteEntity);
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
            long delta = 4_000_000 + random.nextInt(36_000_000); // ns
            scheduler.tick(delta);
            lost += plainly(delta / 1e9);
            compare();
        }
        require(lost > TANKS / 4 && plain.size() > TANKS / 4, "some are lost, some not: " + lost);
        for (long id = 1; id <= TANKS; id++) if (plain.find(id) != null) near(world.find(id));
        require(entities.size() == plain.size(), "an entity for each unit");
        entities.values().forEach(dominion::deleteEntity);
        scheduler.tick(0);
        require(world.size() == 0, "no entity, no unit");
        System.out.println(
                "dominion: " + lost + " of " + (TANKS + FRAMES / 60) + " entities deleted with their units in " + FRAMES
                        + " frames; the others as in a plain World to the bit, and where the closed form says");
    }

    private void deploy(int i) {
        Unit unit = tank(i);
        entities.put(unit, dominion.createEntity(world.add(unit)));
        plain.add(tank(i));
    }

    /** Runs the same frame without an engine, and returns the number of tanks that are lost. */
    private int plainly(double delta) {
        int before = plain.size();
        plain.removeIf(Game::isMined);
        plain.forEach(Game::drive);
        plain.advance(delta);
        return before - plain.size();
    }

    private void compare() {
        require(world.size() == plain.size(), "as many units");
        for (Unit unit : plain) {
            Unit other = world.find(unit.getId());
            require(other != null, "the same are left");
            require(other.getX() == unit.getX() && other.getY() == unit.getY(), "the same places, to the bit");
            require(other.getVx() == unit.getVx() && other.getVy() == unit.getVy(), "the same velocities, to the bit");
        }
    }

    /** m dv/dt = F − f v from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f. */
    private void near(Unit unit) {
        double t = world.getTime(), m = unit.getMass(), f = unit.getFriction();
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
