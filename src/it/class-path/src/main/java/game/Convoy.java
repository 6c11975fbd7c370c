package game;

import java.util.ArrayList;
import java.util.List;
import yarts.physics.World;

/** Twenty tanks that are driven by their motors, with engines of 10 to 200 kN: march, turn, brake, resist a push, go on. */
final class Convoy {
    private static final int TURN = 20, BRAKE = 50, PUSH = 53, REST = 55, GO_ON = 56, END = 57; // s
    private static final double SPEED = 10; // m/s
    private static final double DT = 1 / 60.0; // s, the world's step

    private final World world = new World();
    private final List<Tank> tanks = new ArrayList<>();
    /** The place, speed and duration of each tank's braking. */
    private final double[] x = new double[20], y = new double[20], speed = new double[20];

    private final int[] braking = new int[20]; // ticks
    private final List<Long> bits = new ArrayList<>(); // after each tick

    private Convoy() {
        for (int i = 1; i <= 20; i++) tanks.add(world.add(new Tank(10_000 * i)));
        world.addBeforeStep((w, dt) -> {
            boolean push = w.getTime() >= PUSH && w.getTime() < REST;
            if (push) for (Tank tank : tanks) tank.applyForce(0, 0.999 * Tank.BRAKES);
        });
        world.addAfterStep((w, dt) -> {
            bits.add(bits());
            boolean brake = w.getTime() > BRAKE && w.getTime() < PUSH;
            if (brake) for (int i = 0; i < 20; i++) if (tanks.get(i).getSpeed() > 0) braking[i]++;
        });
    }

    private long bits() {
        long bits = 0;
        for (Tank tank : tanks) {
            for (double v : new double[] {tank.getX(), tank.getY(), tank.getVx(), tank.getVy()}) {
                bits = 31 * bits + Double.doubleToRawLongBits(v);
            }
        }
        return bits;
    }

    /** The same bits at the same tick at each frame rate, with orders given once, or again in each frame. */
    static void drive(int... frameRates) {
        Convoy steps = new Convoy();
        steps.play(60, false, steps.world::step);
        for (int rate : frameRates) {
            for (boolean again : new boolean[] {false, true}) {
                Convoy frames = new Convoy();
                frames.play(rate, again, () -> frames.world.advance(1.0 / rate));
                boolean same = frames.bits.equals(steps.bits);
                Game.require(same, "the same bits at " + rate + " frames/s" + (again ? ", with orders in each" : ""));
            }
        }
    }

    private void play(int framesPerSecond, boolean again, Runnable advance) {
        for (int second = 0; second < END; second++) {
            for (int frame = 0; frame < framesPerSecond; frame++) {
                boolean isNew = second == 0 || second == TURN || second == BRAKE || second == GO_ON;
                if (isNew && frame == 0 || again) order(second);
                advance.run();
            }
            Game.require(world.getTick() == 60 * (second + 1), "a second has 60 ticks");
            look(second + 1);
        }
    }

    private void order(int second) {
        for (Tank tank : tanks) {
            if (second < TURN) tank.go(0.8 * SPEED, 0.6 * SPEED);
            else if (second < BRAKE || second >= GO_ON) tank.go(-0.6 * SPEED, 0.8 * SPEED);
            else tank.brake();
        }
    }

    private void look(int second) {
        for (int i = 0; i < 20; i++) {
            Tank tank = tanks.get(i);
            if (second == TURN) hasMarched(tank);
            if (second == BRAKE) {
                if (isStrong(tank)) hasVelocity(tank, -0.6 * SPEED, 0.8 * SPEED);
                keep(i);
                speed[i] = tank.getSpeed();
            }
            if (second == PUSH) {
                hasStopped(i);
                keep(i);
            }
            if (second == GO_ON) Game.require(tank.getX() == x[i] && tank.getY() == y[i], "brakes hold: " + tank);
            if (second == END) Game.near(speedAfter(END - GO_ON, tank), tank.getSpeed());
        }
    }

    private void keep(int i) {
        x[i] = tanks.get(i).getX();
        y[i] = tanks.get(i).getY();
    }

    /** Whether the engine is stronger than friction at the ordered speed. */
    private static boolean isStrong(Tank tank) {
        return tank.getEngine() > tank.getFriction() * SPEED;
    }

    private static void hasVelocity(Tank tank, double vx, double vy) {
        Game.require(tank.getVx() == vx && tank.getVy() == vy, "exactly the ordered velocity: " + tank);
    }

    /** From rest by the engine's force R: v = R/f (1 − e^(−f t/m)). */
    private static double speedAfter(double time, Tank tank) {
        double f = tank.getFriction();
        return tank.getEngine() / f * -Math.expm1(-f * time / tank.getMass());
    }

    /** From rest, s = (R t − m v)/f, until v = u; then exactly u. A weak engine comes near R/f instead. */
    private static void hasMarched(Tank tank) {
        double r = tank.getEngine(), f = tank.getFriction(), m = tank.getMass();
        double arrival = isStrong(tank) ? m / f * Math.log(r / (r - f * SPEED)) : TURN;
        double v = speedAfter(arrival, tank);
        if (isStrong(tank)) hasVelocity(tank, 0.8 * SPEED, 0.6 * SPEED);
        else Game.near(v, tank.getSpeed());
        went((r * arrival - m * v) / f + v * (TURN - arrival), Math.hypot(tank.getX(), tank.getY()), tank, r);
    }

    /** With brakes B, from v: t = m/f ln(1 + f v/B) and s = (m v − B t)/f. */
    private void hasStopped(int i) {
        Tank tank = tanks.get(i);
        double b = Tank.BRAKES, f = tank.getFriction(), m = tank.getMass();
        double time = m / f * Math.log1p(f * speed[i] / b);
        hasVelocity(tank, 0, 0);
        Game.require(braking[i] == (int) (time / DT), braking[i] + " ticks until it stops, expected " + time / DT);
        went((m * speed[i] - b * time) / f, Math.hypot(tank.getX() - x[i], tank.getY() - y[i]), tank, b);
    }

    /** The distance is that of the closed form, to within the step in which the motor reaches its velocity. */
    private static void went(double expected, double actual, Tank tank, double force) {
        double most = force * DT * DT / (4 * tank.getMass()) + 1e-9 * expected;
        Game.require(Math.abs(actual - expected) <= most, "expected a way of " + expected + " m, was " + actual);
    }
}
