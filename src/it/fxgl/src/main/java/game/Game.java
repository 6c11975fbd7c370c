package game;

import static com.almasb.fxgl.dsl.FXGL.entityBuilder;
import static com.almasb.fxgl.dsl.FXGL.getGameController;
import static com.almasb.fxgl.dsl.FXGL.getGameScene;
import static game.TankComponent.PUSH;

import com.almasb.fxgl.app.ApplicationMode;
import com.almasb.fxgl.app.GameApplication;
import com.almasb.fxgl.app.GameSettings;
import com.almasb.fxgl.entity.Entity;
import com.almasb.fxgl.entity.components.ViewComponent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import java.util.logging.Logger;
import javafx.scene.Node;
import javafx.scene.shape.Rectangle;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** An FXGL game without a screen: all of JavaFX runs, and draws into memory. */
public final class Game extends GameApplication {
    private static final int TANKS = 50;
    private static final int TICKS = 90;
    private static final double METRE = 10; // pixels
    /** The logger of JavaFX, which warns that it is on the class path. */
    private static final Logger LOGGER = Logger.getLogger("javafx");

    // tag::adapter[]
    private final World world = new World();
    private final Map<Unit, Entity> entities = new HashMap<>();

    /** Steps the world once per frame. FXGL calls it after the components, which have given their orders. */
    @Override
    protected void onUpdate(double tpf) {
        world.advance(tpf);
        entities.forEach(
                (unit, entity) -> entity.setPosition(METRE * unit.getInterpolatedX(), METRE * unit.getInterpolatedY()));
    }
    // end::adapter[]

    private final List<Double> frames = new ArrayList<>(); // s

    public static void main(String[] args) {
        LOGGER.setLevel(Level.SEVERE);
        launch(args);
    }

    @Override
    protected void initSettings(GameSettings settings) {
        settings.setApplicationMode(ApplicationMode.RELEASE); // logs little
        settings.setFileSystemWriteAllowed(false);
    }

    @Override
    protected void initGame() {
        // FXGL shows an exception in a dialog; the game must fail with it.
        Thread.setDefaultUncaughtExceptionHandler((thread, error) -> {
            error.printStackTrace();
            Runtime.getRuntime().halt(1);
        });
        build(world);
        for (Unit unit : world) {
            Entity entity = entityBuilder()
                    .view(new Rectangle(30, 20))
                    .with(new TankComponent(unit))
                    .buildAndAttach();
            entities.put(unit, entity);
        }
        getGameScene().addListener(this::look);
    }

    /** Runs at the end of a frame, before it is drawn. */
    private void look(double tpf) {
        frames.add(tpf);
        if (world.getTick() >= TICKS) finish();
    }

    private static void build(World world) {
        for (int i = 0; i < TANKS; i++) world.add(new Unit(20_000 + 1_000 * i).setFriction(8_000));
    }

    private void finish() {
        double elapsed = frames.stream().mapToDouble(Double::doubleValue).sum();
        double covered = (world.getTick() + world.getAlpha()) / 60 + world.getDroppedTime();
        near(elapsed, covered, 1e-8, "no frame's time is lost");
        for (Unit unit : world) {
            compare(unit, world.getTime());
            ViewComponent view = entities.get(unit).getViewComponent();
            Node picture = view.getChildren().get(0).getParent();
            require(picture.getTranslateX() == METRE * unit.getInterpolatedX(), "the picture's x");
            require(picture.getTranslateY() == METRE * unit.getInterpolatedY(), "the picture's y");
        }
        require(world.stateHash() == replay().stateHash(), "a plain World gives the same bits for the same frames");
        System.out.println("fxgl: " + TANKS + " entities in " + frames.size() + " frames drawn into memory;"
                + " they are where the closed form says, and the units as in a plain World to the bit");
        getGameController().exit();
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

    private World replay() {
        World replay = new World(Integrator.EXACT, Timestep.fixed(60));
        build(replay);
        for (double tpf : frames) {
            for (Unit unit : replay) unit.applyForce(PUSH, PUSH / 2);
            replay.advance(tpf);
        }
        return replay;
    }

    private static void near(double expected, double actual, double within, String claim) {
        require(Math.abs(actual - expected) <= within, claim + ": expected " + expected + ", was " + actual);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
