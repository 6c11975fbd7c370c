package game;

import com.jme3.app.SimpleApplication;
import com.jme3.app.state.AbstractAppState;
import com.jme3.math.Vector3f;
import com.jme3.scene.Node;
import com.jme3.system.JmeContext;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.Logger;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A jMonkeyEngine game without a window: tanks drive across a scene graph, in frames of real time. */
public final class Game extends SimpleApplication {
    private static final int TANKS = 50;
    private static final int TICKS = 90;
    private static final double PUSH = 80_000; // N
    private static final Vector3f CAMP = new Vector3f(100, 5, -20); // m
    /** The logger of jME, which warns of each missing loader of models. */
    private static final Logger LOGGER = Logger.getLogger("com.jme3");

    private final UnitsState units;
    private final List<Float> frames = new ArrayList<>(); // s

    public static void main(String[] args) {
        LOGGER.setLevel(Level.SEVERE);
        new Game(new UnitsState()).start(JmeContext.Type.Headless);
    }

    /** States are updated in the order in which they are attached: the orders first, then the physics. */
    private Game(UnitsState units) {
        super(new Orders(units.world), units);
        this.units = units;
    }

    /** The player: full throttle in every frame. */
    private static final class Orders extends AbstractAppState {
        private final World world;

        Orders(World world) {
            this.world = world;
        }

        @Override
        public void update(float tpf) {
            drive(world);
        }
    }

    private static void drive(World world) {
        for (Unit unit : world) unit.applyForce(PUSH, PUSH / 2);
    }

    private static void build(World world) {
        for (int i = 0; i < TANKS; i++) world.add(new Unit(20_000 + 1_000 * i).setFriction(8_000));
    }

    @Override
    public void simpleInitApp() {
        build(units.world);
        Node camp = new Node("camp");
        camp.setLocalTranslation(CAMP);
        rootNode.attachChild(camp);
        for (Unit unit : units.world) {
            Node spatial = new Node("tank " + unit.getId());
            camp.attachChild(spatial);
            units.spatials.put(unit, spatial);
        }
    }

    /** Runs after the states, as a game that looks at the scene does. */
    @Override
    public void simpleUpdate(float tpf) {
        frames.add(tpf);
        if (units.world.getTick() >= TICKS / 2) speed = 0.5f; // slow motion: jME's tpf is half of what a frame took
        if (units.world.getTick() >= TICKS) stop();
    }

    @Override
    public void destroy() {
        World world = units.world;
        double elapsed = frames.stream().mapToDouble(Float::doubleValue).sum();
        double covered = (world.getTick() + world.getAlpha()) / 60 + world.getDroppedTime();
        near(elapsed, covered, 1e-8, "no frame's time is lost");
        for (Unit unit : world) {
            compare(unit, world.getTime());
            Vector3f there = units.spatials.get(unit).getWorldTranslation().subtract(CAMP);
            near(unit.getInterpolatedX(), there.x, 1e-4, "the spatial is where its unit is drawn");
            near(unit.getInterpolatedY(), -there.z, 1e-4, "north is -z");
            require(there.y == 0, "it stays on the ground");
        }
        require(world.stateHash() == replay().stateHash(), "a plain World gives the same bits for the same frames");
        super.destroy();
        System.out.println("jmonkeyengine: " + TANKS + " spatials in " + frames.size() + " frames, some in slow motion;"
                + " they are where the closed form says, and the units as in a plain World to the bit");
    }

    /** m dv/dt = F − f v from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f. */
    private static void compare(Unit unit, double t) {
        double m = unit.getMass(), f = unit.getFriction();
        double v = PUSH / f * -Math.expm1(-f * t / m);
        double x = (PUSH * t - m * v) / f;
        near(v, unit.getVx(), 1e-9 * v, "the speed");
        near(x, unit.getX(), 1e-9 * v * t, "the way");
        near(x / 2, unit.getY(), 1e-9 * v * t, "the way north");
    }

    private World replay() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        build(world);
        for (float tpf : frames) {
            drive(world);
            world.advance(tpf);
        }
        return world;
    }

    /** jME logs an exception and ends its thread; the game must fail with it. */
    @Override
    public void handleError(String message, Throwable error) {
        error.printStackTrace();
        Runtime.getRuntime().halt(1);
    }

    private static void near(double expected, double actual, double within, String claim) {
        require(Math.abs(actual - expected) <= within, claim + ": expected " + expected + ", was " + actual);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
