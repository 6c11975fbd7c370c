package game;

/** Compares one scene in dyn4j and in yarts-physics: the same results, and the differences by design. */
public final class Game {
    private static final double PUSH = 30_000, MASS = 1_000; // N, kg

    private Game() {}

    public static void main(String[] args) {
        fliesAlike();
        drivesAlikeAtHighTickRates();
        leads();
        hasAnotherTerminalSpeed();
        losesAndMultipliesForces();
        hasALimitOfItsOwn();
        System.out.println("from-dyn4j: the shell flies alike, and the buggy drives alike at 1,000 steps a second;"
                + " from z = 1 on dyn4j stands still where F/f is 0.5 m/s; a push a frame depends on the frame rate");
    }

    /** Free flight and an impulse give the same results, to within rounding. */
    private static void fliesAlike() {
        Scene before = new Dyn4jScene(60, 0), after = new YartsScene(60, 0);
        for (Scene scene : new Scene[] {before, after}) {
            play(scene, 5, 60);
            scene.hit(-500, 250);
            play(scene, 5, 60);
            near(5 * 30 + 5 * 20, scene.shell().x(), 1e-9, "the shell's x");
            near(100 + 5 * 40 + 5 * 45, scene.shell().y(), 1e-9, "the shell's y");
            near(20, scene.shell().vx(), 1e-12, "the shell's velocity along x");
            near(45, scene.shell().vy(), 1e-12, "the shell's velocity along y");
        }
    }

    /** Damping is friction/mass. Both motions converge as z = f dt/m becomes small; here z is 0.0015. */
    private static void drivesAlikeAtHighTickRates() {
        double friction = 1_500, z = friction / MASS / 1_000, t = 1;
        Scene before = new Dyn4jScene(1_000, friction), after = new YartsScene(1_000, friction);
        play(before, t, 1_000);
        play(after, t, 1_000);
        double v = PUSH / friction * -Math.expm1(-friction / MASS * t);
        near(v, after.buggy().vx(), 1e-9, "the closed form");
        near(v, before.buggy().vx(), 2 * z * PUSH / friction, "dyn4j comes near it");
    }

    /** Without friction, both give the right speed; the position in dyn4j is ahead by a t dt/2. */
    private static void leads() {
        Scene before = new Dyn4jScene(60, 0), after = new YartsScene(60, 0);
        play(before, 1, 60);
        play(after, 1, 60);
        double a = PUSH / MASS;
        near(a, before.buggy().vx(), 1e-9, "dyn4j's speed");
        near(a, after.buggy().vx(), 1e-9, "the speed");
        near(a / 2, after.buggy().x(), 1e-9, "the way is a t²/2");
        near(a / 2 + a / 120, before.buggy().x(), 1e-9, "dyn4j's way");
    }

    /** Damping after the push gives the terminal speed (1 - z) F/f, and 0 from z = 1 on. */
    private static void hasAnotherTerminalSpeed() {
        double friction = 60_000;
        for (int rate : new int[] {20, 60, 120, 240}) {
            double z = friction / MASS / rate;
            Scene before = new Dyn4jScene(rate, friction), after = new YartsScene(rate, friction);
            play(before, 2, rate);
            play(after, 2, rate);
            near(PUSH / friction, after.buggy().vx(), 1e-12, "F/f at z = " + z);
            near(Math.max(0, 1 - z) * PUSH / friction, before.buggy().vx(), 1e-9, "dyn4j at z = " + z);
        }
    }

    /**
     * One push per frame, with steps of 1/60 s: in dyn4j it acts for the next step, whether the frame has four steps or a
     * quarter of one. The remedy is to push in a step listener.
     */
    private static void losesAndMultipliesForces() {
        for (int framesPerSecond : new int[] {15, 60, 240}) {
            Scene before = new Dyn4jScene(60, 0), after = new YartsScene(60, 0);
            play(before, 1, framesPerSecond);
            play(after, 1, framesPerSecond);
            near(PUSH / MASS, after.buggy().vx(), 1e-9, "a push of 1 s at " + framesPerSecond);
            double v = PUSH / MASS * framesPerSecond / 60;
            near(v, before.buggy().vx(), 0.02 * v, "dyn4j at " + framesPerSecond);
        }
    }

    /** The cap of dyn4j is 2 m per step by default; a unit has no top speed by default. */
    private static void hasALimitOfItsOwn() {
        Scene before = new Dyn4jScene(60, 0), after = new YartsScene(60, 0);
        for (Scene scene : new Scene[] {before, after}) {
            scene.hit(50 * 270, 50 * 360);
            play(scene, 1, 60);
        }
        near(500, Math.hypot(after.shell().vx(), after.shell().vy()), 1e-9, "the speed");
        near(120, Math.hypot(before.shell().vx(), before.shell().vy()), 1e-9, "dyn4j's speed");
    }

    private static void play(Scene scene, double seconds, int framesPerSecond) {
        for (int frame = 0; frame < seconds * framesPerSecond; frame++) scene.frame(1.0 / framesPerSecond);
    }

    private static void near(double expected, double actual, double within, String claim) {
        if (!(Math.abs(actual - expected) <= within)) {
            throw new IllegalStateException(claim + ": expected " + expected + ", was " + actual);
        }
    }
}
