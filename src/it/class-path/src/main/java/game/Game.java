package game;

import java.io.File;
import yarts.physics.Unit;
import yarts.physics.World;

/** A game on the class path: a plain loop at several frame rates, with tanks of the game's own class. */
public final class Game {
    private static final double DT = 1 / 60.0; // s, the world's step

    private Game() {}

    public static void main(String[] args) {
        require(!Unit.class.getModule().isNamed(), "the library is on the class path");
        String[] classPath = System.getProperty("java.class.path").split(File.pathSeparator);
        require(classPath.length == 2, "the library brings no other: " + String.join(", ", classPath));

        double[] rates = {24, 59.94, 60, 144, 1000};
        for (double rate : rates) race(rate);
        alone();
        brake();
        Convoy.drive(15, 144);
        System.out.println("class-path: the game and one jar; tanks drove as the closed form says at " + rates.length
                + " frame rates and alone, kept to their top speed, and braked without turning round; by motors, they reached"
                + " exactly the ordered velocity and rest, with the same bits at 15 and 144 frames/s");
    }

    /** Ten seconds at full throttle, applied once per frame. The strongest engines reach the top speed. */
    private static void race(double rate) {
        World world = new World();
        for (int i = 1; i <= 20; i++) world.add(new Tank(10_000 * i));
        long frames = Math.round(10 * rate);
        for (long frame = 0; frame < frames; frame++) {
            for (Unit unit : world) ((Tank) unit).drive();
            world.advance(1 / rate);
        }
        long ticks = world.getTick();
        long due = (long) (frames / rate * 60);
        require(ticks == due, "n frames of 1/n s are a second, and so 60 ticks: " + ticks + ", not " + due);
        require(world.getDroppedTime() == 0, "no time is dropped");
        for (Unit unit : world) {
            Tank tank = (Tank) unit;
            compare(tank, ticks, Math.exp(-tank.getFriction() * DT / tank.getMass() * ticks));
        }
    }

    private static void alone() {
        Tank tank = new Tank(60_000);
        for (int tick = 0; tick < 600; tick++) {
            tank.drive();
            tank.integrate(DT);
        }
        compare(tank, 600, Math.pow(1 - tank.getFriction() * DT / tank.getMass(), 600));
    }

    /**
     * n steps from rest: v = F/f (1 − k) with k = e^(−n z), or k = (1 − z)^n for Euler, z = f dt/m; x = (F t − m v)/f; or
     * the top speed, if F/f is more.
     */
    private static void compare(Tank tank, long n, double k) {
        double force = tank.getEngine(), f = tank.getFriction(), m = tank.getMass();
        double terminal = force / f;
        double v = terminal * (1 - k);
        if (terminal <= tank.getMaxSpeed()) {
            near(v, tank.getVx());
            near((force * n * DT - m * v) / f, tank.getX());
        } else {
            near(Math.min(v, tank.getMaxSpeed()), tank.getVx());
            require(tank.getX() < tank.getMaxSpeed() * n * DT, "it went no farther than its top speed allows");
        }
        require(tank.getY() == 0 && tank.getVy() == 0, "it drove straight on");
    }

    /** Friction with z = 1.5, which would reverse a unit under the naive rule, stops it. */
    private static void brake() {
        Unit unit = new Unit(1).setFriction(90).setVelocity(10, 0);
        unit.integrate(DT);
        require(unit.getVx() == 0, "it stopped: " + unit);
        unit.applyForce(900, 0);
        unit.integrate(DT);
        near(10, unit.getVx());
    }

    static void near(double expected, double actual) {
        require(Math.abs(actual - expected) <= 1e-9 * Math.abs(expected), "expected " + expected + ", was " + actual);
    }

    static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
