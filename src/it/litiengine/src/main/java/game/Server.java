package game;

import de.gurkenlabs.litiengine.UpdateLoop;
import de.gurkenlabs.litiengine.entities.CollisionBox;
import de.gurkenlabs.litiengine.entities.IEntity;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The server of a LITIENGINE game: its entities, and a loop like the one that {@code Game.init} starts. That one needs a
 * screen, as it makes a Swing frame even with {@code -nogui}.
 */
public final class Server extends UpdateLoop {
    private static final int TANKS = 50;
    private static final int TICKS = 90;
    private static final double PUSH = 80_000; // N

    private final World world = world();
    private final Map<Unit, IEntity> entities = new HashMap<>();
    private final List<Long> deltas = new ArrayList<>(); // ms

    public static void main(String[] args) {
        // An exception ends LITIENGINE's loop alone, if that; the game must fail with it.
        setDefaultUncaughtExceptionHandler((thread, error) -> {
            error.printStackTrace();
            Runtime.getRuntime().halt(1);
        });
        new Server().start();
    }

    private Server() {
        super("Update Loop", 60);
        for (Unit unit : world) entities.put(unit, new CollisionBox());
        attach(new Physics(this, world, entities));
    }

    /** One tick: the orders, then what is attached. */
    @Override
    protected void process() {
        deltas.add(getDeltaTime());
        drive(world);
        super.process();
        if (world.getTick() < TICKS) return;
        finish();
        terminate();
    }

    private static World world() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 0; i < TANKS; i++) world.add(new Unit(20_000 + 1_000 * i).setFriction(8_000));
        return world;
    }

    private static void drive(World world) {
        for (Unit unit : world) unit.applyForce(PUSH, PUSH / 2);
    }

    private void finish() {
        long elapsed = deltas.stream().mapToLong(Long::longValue).sum(); // ms
        if (world.getDroppedTime() == 0) {
            require(world.getTick() == elapsed * 60 / 1_000, "milliseconds add up to ticks without an error");
        }
        for (Unit unit : world) {
            compare(unit, world.getTime());
            IEntity entity = entities.get(unit);
            require(entity.getX() == Physics.METRE * unit.getInterpolatedX(), "the entity is where its unit is drawn");
            require(entity.getY() == Physics.METRE * unit.getInterpolatedY(), "the entity is where its unit is drawn");
        }
        World replay = world();
        for (long delta : deltas) {
            drive(replay);
            replay.advance(delta / 1_000.0);
        }
        require(world.stateHash() == replay.stateHash(), "a plain World gives the same bits for the same ticks");
        System.out.println("litiengine: " + TANKS + " entities in " + deltas.size() + " ticks of whole milliseconds;"
                + " they are where the closed form says, and the units as in a plain World to the bit");
    }

    /** m dv/dt = F − f v from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f. */
    private static void compare(Unit unit, double t) {
        double m = unit.getMass(), f = unit.getFriction();
        double v = PUSH / f * -Math.expm1(-f * t / m);
        double x = (PUSH * t - m * v) / f;
        near(v, unit.getVx(), 1e-9 * v, "the speed");
        near(x, unit.getX(), 1e-9 * v * t, "the way along x");
        near(x / 2, unit.getY(), 1e-9 * v * t, "the way along y");
    }

    private static void near(double expected, double actual, double within, String claim) {
        require(Math.abs(actual - expected) <= within, claim + ": expected " + expected + ", was " + actual);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
