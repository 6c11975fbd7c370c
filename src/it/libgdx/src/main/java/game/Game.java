package game;

import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input;
import com.badlogic.gdx.backends.headless.HeadlessApplication;
import com.badlogic.gdx.backends.headless.HeadlessApplicationConfiguration;
import com.badlogic.gdx.backends.headless.mock.input.MockInput;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector2;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * A libGDX game without a window. Frames take the time they take, so where the tanks end up is worked out from the
 * ticks that ran and from the impulses that were given.
 */
public final class Game extends ApplicationAdapter {
    private static final int TICKS = 90;
    private static final int RATE = 60;
    private static final double PUSH = 50_000; // N

    /** So high a limit that a busy machine makes no frame drop time. */
    private final World world = world();

    private final Unit driven = world.add(tank());
    private final Unit steered = world.add(tank());
    private final Unit[] squad = squad(world);
    private final Vector2 force = new Vector2(); // N
    private final float[] vertices = new float[2 * world.size()];

    /** The game of the docs, without a screen to draw on. */
    private final Battle battle = new Battle() {
        @Override
        protected void draw(float x, float y) {
            require(x >= battleX && y == 0, "the docs' tank never goes back: from " + battleX + " to " + x);
            battleX = x;
        }
    };

    private float battleX; // m

    private int frames;
    private double elapsed, longest; // s: of all frames, of one
    private double impulseX, impulseY; // N·s, given to the steered tank
    private long coasting = Long.MAX_VALUE; // the tick from which on it got no more

    public static void main(String[] args) {
        // An exception in render ends libGDX's thread alone; the game must fail with it.
        Thread.setDefaultUncaughtExceptionHandler((thread, error) -> {
            error.printStackTrace();
            Runtime.getRuntime().halt(1);
        });
        HeadlessApplicationConfiguration config = new HeadlessApplicationConfiguration();
        config.updatesPerSecond = 144;
        new HeadlessApplication(new Game(), config);
    }

    @Override
    public void create() {
        Gdx.input = new MockInput() {
            @Override
            public boolean isKeyPressed(int key) {
                return key == Input.Keys.RIGHT && world.getTick() < TICKS / 2;
            }
        };
    }

    @Override
    public void render() {
        battle.render();
        double dt = Gdx.graphics.getDeltaTime();
        frames++;
        elapsed += dt;
        longest = Math.max(longest, dt);
        driven.applyForce(PUSH, 0);
        if (world.getTick() < TICKS / 2) {
            force.set((float) PUSH, 0).rotateDeg(MathUtils.random(360f));
            steered.applyForce(force.x, force.y);
            impulseX += force.x * dt;
            impulseY += force.y * dt;
        } else {
            coasting = Math.min(coasting, world.getTick());
        }
        world.advance(dt);
        world.copyPositions(vertices, 0);
        for (int i = 0; i < world.size(); i++) {
            Unit unit = world.get(i);
            require(vertices[2 * i] == (float) unit.getInterpolatedX(), "the vertices are where the units are drawn");
        }
        if (world.getTick() >= TICKS) Gdx.app.exit(); // after one more frame
    }

    @Override
    public void dispose() {
        long ticks = world.getTick();
        double rounding = frames * 0.5e-9 / RATE; // s: each frame's time is rounded to 1e-9 of a tick
        require(world.getDroppedTime() == 0, "no time was dropped");
        double alpha = world.getAlpha(), drawn = (1 - alpha) * driven(ticks - 1) + alpha * driven(ticks);
        if (longest < 0.25)
            near(drawn, battleX, 1e-6, "the docs' tank has driven off and braked"); // else it dropped time
        double covered = (ticks + world.getAlpha()) / RATE;
        near(elapsed, covered, rounding + 1e-6 / RATE, "the ticks and the part of one");

        // v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f
        double t = world.getTime(), m = driven.getMass(), f = driven.getFriction();
        double v = PUSH / f * -Math.expm1(-f * t / m);
        near(v, driven.getVx(), 1e-9 * v, "the driven tank's speed");
        near((PUSH * t - m * v) / f, driven.getX(), 1e-9 * v * t, "the driven tank's way");

        // m v = ∫ F dt − f x: what it was given is in its momentum, or was taken by friction
        require(ticks > coasting, "every push has been delivered");
        double lost = PUSH * rounding + 1e-6;
        near(impulseX, m * steered.getVx() + f * steered.getX(), lost, "the steered tank's impulse along x");
        near(impulseY, m * steered.getVy() + f * steered.getY(), lost, "the steered tank's impulse along y");

        World replay = world();
        Unit[] again = squad(replay);
        for (long tick = 0; tick < ticks; tick++) replay.step();
        for (int i = 0; i < squad.length; i++) {
            near(i, squad[i].getX(), 1e-3, "the squad is in line");
            require(squad[i].getX() == again[i].getX() && squad[i].getVx() == again[i].getVx(), "to the bit, replayed");
        }

        int ran = world.advance(3600); // the lid was closed for an hour
        require(ran == 600, "it catches up by as many ticks as it may: " + ran);
        covered = world.getTime() + world.getAlpha() / RATE;
        near(elapsed + 3600, covered + world.getDroppedTime(), 1e-6, "with the time dropped, none is lost");
        System.out.println("libgdx: " + ticks + " ticks in " + frames + " frames of real time; the tanks ended up where"
                + " the closed form, their impulses and a replay say");
    }

    /** Where the docs' tank is after n ticks: it gets faster by 2 m/s² until the key is released, and then brakes alike. */
    private double driven(long n) {
        long until = Math.min(n, coasting), stop = Math.min(n, 2 * coasting), left = 2 * coasting - stop;
        double steps = n <= coasting ? until * until : 2.0 * coasting * coasting - left * left;
        return steps / (RATE * RATE);
    }

    private static World world() {
        return new World(Integrator.EXACT, Timestep.fixed(RATE).withMaxSteps(600));
    }

    private static Unit tank() {
        return new Unit(10_000).setFriction(5_000);
    }

    /** Five scouts, each on a spring, worked out anew for every step, to its place in line. Damped beyond swinging. */
    private static Unit[] squad(World world) {
        Unit[] squad = new Unit[5];
        for (int i = 0; i < squad.length; i++) {
            squad[i] = world.add(new Unit(1).setFriction(40).setPosition(10 * i * i - 30, 0));
        }
        world.addBeforeStep((w, dt) -> {
            for (int i = 0; i < squad.length; i++) squad[i].applyForce(300 * (i - squad[i].getX()), 0);
        });
        return squad;
    }

    private static void near(double expected, double actual, double within, String claim) {
        require(Math.abs(actual - expected) <= within, claim + ": expected " + expected + ", was " + actual);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
