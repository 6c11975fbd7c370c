package yarts.physics.metamorphic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A game drawn from a seed, played in a {@link View}, with a {@link Layout} of its units. */
final class Play {
    /**
     * The order in which units are added, the number of worlds, the number of units at rest between them, and the pool.
     */
    record Layout(int[] order, int worlds, int sleepers, ForkJoinPool pool) {
        static Layout plain(int units) {
            int[] order = new int[units];
            Arrays.setAll(order, i -> i);
            return new Layout(order, 1, 0, null);
        }
    }

    private static final double[] STEPS = {1 / 60.0, 1 / 32.0, 0.01, 0.1, 1.5};

    private final Random random;
    private final View view;
    private final boolean fixed;
    private final List<World> worlds = new ArrayList<>();
    private final Unit[] units;

    Play(long seed, Integrator integrator, boolean fixed, View view, Layout layout) {
        random = new Random(seed);
        this.view = view;
        this.fixed = fixed;
        Timestep timestep = timestep();
        for (int i = 0; i < layout.worlds; i++) {
            World world = new World(integrator, timestep);
            world.setPool(layout.pool);
            world.addBeforeStep((w, dt) -> steer(w));
            world.addAfterStep((w, dt) -> react(w));
            worlds.add(world);
        }
        units = new Unit[layout.order.length];
        for (int i = 0; i < units.length; i++) units[i] = unit();
        for (int i : layout.order) {
            World world = worlds.get(i % layout.worlds);
            world.add(units[i]);
            for (int k = 0; k < layout.sleepers; k++) world.add(new Sleeper(k % 3 == 1));
        }
    }

    private Timestep timestep() {
        boolean one = random.nextBoolean();
        Timestep timestep =
                fixed ? Timestep.fixed(one ? 64 : 25) : Timestep.variable((one ? 0.05 : 0.02) * view.time());
        return timestep.withMaxSteps(4);
    }

    /** A unit at rest that gets no orders. It may have a brake, which has no effect. */
    private static final class Sleeper extends Unit {
        Sleeper(boolean braked) {
            super(3);
            setFriction(2).setMaxSpeed(1).setPosition(5, 6).setMotor(0, 0, braked ? 7 : 0);
        }
    }

    private Unit unit() {
        double mass = number(0.1, 100), stiffness = random.nextInt(4) == 0 ? 0 : number(1e-3, 1e3);
        Unit unit = new Unit(mass * view.mass()).setFriction(stiffness * mass * view.friction());
        if (random.nextInt(3) > 0) unit.setMaxSpeed(number(0.1, 100) * view.speed());
        place(unit, number(1, 100), number(1, 100));
        if (random.nextInt(3) == 0) drive(unit, number(0.1, 100), number(0.1, 100));
        return unit;
    }

    private void place(Unit unit, double x, double y) {
        unit.setPosition(view.x(x, y, view.length()), view.y(x, y, view.length()));
    }

    private void drive(Unit unit, double vx, double vy) {
        unit.setVelocity(view.x(vx, vy, view.speed()), view.y(vx, vy, view.speed()));
    }

    /** Springs pull some units to the origin. */
    private void steer(World world) {
        double spring = -8 * view.mass() / view.time() / view.time();
        for (Unit unit : world) {
            if (unit.getMass() > 50 * view.mass()) unit.applyForce(unit.getX() * spring, unit.getY() * spring);
        }
    }

    /** Walls stop light units. A force for the next step slows some others down. */
    private void react(World world) {
        double wall = 64 * view.length(), drag = -view.friction();
        for (Unit unit : world) {
            double x = unit.getX(), y = unit.getY();
            if (unit.getMass() < 2 * view.mass()) {
                if (Math.abs(x) > wall) unit.moveTo(Math.copySign(wall, x), y);
                if (Math.abs(y) > wall) unit.moveTo(unit.getX(), Math.copySign(wall, y));
            } else if (unit.getMass() < 8 * view.mass()) {
                unit.applyForce(unit.getVx() * drag, unit.getVy() * drag);
            }
        }
    }

    /** A frame: orders to some units, sometimes another timestep, and an advance. */
    void frame() {
        int orders = random.nextInt(3) == 0 ? 0 : 1 + random.nextInt(1 + units.length / 8);
        for (; orders > 0; orders--) order(units[random.nextInt(units.length)]);
        if (random.nextInt(5) == 0) {
            Timestep timestep = timestep();
            worlds.forEach(world -> world.setTimestep(timestep));
        }
        double seconds = STEPS[random.nextInt(STEPS.length)] * view.time();
        boolean frame = random.nextBoolean();
        for (World world : worlds) {
            if (frame) world.advance(seconds);
            else world.step(seconds);
        }
    }

    private void order(Unit unit) {
        double a = number(0.01, 1000), b = number(0.01, 1000);
        if (random.nextBoolean()) a = -a;
        if (random.nextBoolean()) b = -b;
        switch (random.nextInt(16)) {
            case 0 -> place(unit, a, b);
            case 1 -> drive(unit, a, b);
            case 2 -> unit.applyImpulse(view.x(a, b, view.impulse()), view.y(a, b, view.impulse()));
            case 3 -> unit.setMass(Math.abs(a) * view.mass());
            case 4 -> unit.setFriction(Math.abs(a) * view.friction());
            case 5 -> unit.setMaxSpeed(Math.abs(a) * view.speed());
            case 6 -> unit.setFrozen(a > 0);
            case 7 -> unit.clearForces();
            case 8 -> { // leaves its world and joins again as the last
                World world = unit.getWorld();
                world.remove(unit);
                world.add(unit);
            }
            case 9, 10 -> { // drives, or brakes
                double k = random.nextInt(3) == 0 ? 0 : view.speed(), most = number(0.01, 1000) * view.force();
                unit.setMotor(view.x(a, b, k), view.y(a, b, k), most);
            }
            case 11 -> unit.setMotor(0, 0, 0);
            case 12 -> unit.moveTo(view.x(a, b, view.length()), view.y(a, b, view.length()));
            default -> unit.applyForce(view.x(a, b, view.force()), view.y(a, b, view.force()));
        }
    }

    /** Nearly uniform in the logarithm. */
    private double number(double min, double max) {
        return min * Math.pow(max / min, random.nextDouble());
    }

    /** Asserts that every unit of another play has the state of this one's in the view of the other. */
    void assertEqualInView(Play other, String when) {
        for (int i = 0; i < units.length; i++) {
            int unit = i;
            assertArrayEquals(view.bits(units[i]), other.view.bits(other.units[i]), () -> "unit " + unit + ", " + when);
        }
    }
}
