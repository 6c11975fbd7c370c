package yarts.physics.support;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.StepListener;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * A game drawn from a seed. In its frames it makes all calls that a game can make, with ordinary and extreme numbers.
 * The calls depend only on the seed and the world, so equal worlds stay equal. It uses only the library, so it runs on
 * any JVM.
 */
public final class Churn {
    /** The increment of SplitMix64. */
    public static final long GOLDEN = 0x9E3779B97F4A7C15L;

    private static final Timestep[] TIMESTEPS = {
        Timestep.fixed(60).withMaxSteps(4),
        Timestep.fixed(60),
        Timestep.fixed(144).withMaxSteps(3),
        Timestep.fixed(7).withMaxSteps(1),
        Timestep.variable(0.01).withMaxSteps(4),
        Timestep.variable(0.05)
    };

    /** Sometimes thrown by the listener. */
    private static final class Halt extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    private final int least, rare;
    private final boolean finds;
    private final StepListener before = this::before, after = this::after;
    /** Removed units, which may be added again. */
    private final List<Unit> bench = new ArrayList<>();

    private final Snapshot past = new Snapshot();
    private long seed;

    /** A game in which one of eight numbers is extreme. It has few units, and sometimes some hundreds more. */
    public Churn(long seed) {
        this(seed, 0, 8);
    }

    /**
     * A game.
     *
     * @param seed the seed of all decisions
     * @param least the least number of units at the start of a frame
     * @param rare on average, one of this many numbers is extreme
     */
    public Churn(long seed, int least, int rare) {
        this.seed = scramble(seed);
        this.least = least;
        this.rare = rare;
        finds = draw(2) == 0;
    }

    /** {@return a world after some frames} */
    public static World world(long seed, Integrator integrator, Timestep timestep, int frames) {
        World world = new World(integrator, timestep);
        new Churn(seed).play(world, frames);
        return world;
    }

    /** {@return the hash after each of some frames} */
    public List<Long> play(World world, int frames) {
        List<Long> hashes = new ArrayList<>();
        for (int i = 0; i < frames; i++) {
            frame(world);
            hashes.add(world.stateHash());
        }
        return hashes;
    }

    /** Plays a frame: orders, and an advance or step. */
    public void frame(World world) {
        int missing = least > 0 ? least - world.size() : draw(50) == 0 ? 600 : draw(3) > 0 ? draw(6) : 0;
        for (; missing > 0; missing--) world.add(newUnit());
        for (int orders = draw(8) + world.size() / 16; orders > 0; orders--) order(world);
        for (int orders = draw(3); orders > 0; orders--) orderAll(world);
        Integrator integrator = world.getIntegrator();
        if (draw(16) == 0) world.setIntegrator(integrator());
        if (draw(3) > 0) {
            world.addBeforeStep(before);
            world.addAfterStep(after);
        }
        try {
            pass(world);
        } catch (Halt e) {
            // thrown by the listener: the rest of the frame is dropped
        }
        world.removeStepListener(before);
        world.removeStepListener(after);
        world.setIntegrator(integrator);
        if (draw(8) == 0) order(world); // its forces still wait after the frame
    }

    private void pass(World world) {
        switch (draw(8)) {
            case 0:
            case 1:
                world.step(seconds());
                break;
            case 2:
                world.step();
                break;
            case 3:
            case 4:
                world.advance(0.005);
                break;
            default:
                world.advance(seconds());
        }
    }

    /** Steers some units; sometimes it throws. */
    private void before(World world, double dt) {
        for (int i = draw(8); i < world.size(); i += 8) { // towards the first unit
            Unit unit = world.get(i), first = world.get(0);
            unit.applyForce(limit(first.getX() - unit.getX(), 1e6), dt - limit(unit.getVx(), 1e6));
        }
        if (world.size() > 5 && draw(8) == 0) world.remove(world.get(draw(world.size())));
        if (draw(32) == 0) throw new Halt();
    }

    /** Keeps some units behind walls, and pushes some in the next step; sometimes it throws. */
    private void after(World world, double dt) {
        for (int i = draw(8); i < world.size(); i += 8) {
            Unit unit = world.get(i);
            if (Math.abs(unit.getX()) > 1e3) unit.moveTo(limit(unit.getX(), 1e3), unit.getY());
            if (draw(4) == 0) unit.applyForce(force(), force());
        }
        if (draw(8) == 0) {
            world.add(newUnit()).moveTo(1, 2);
            world.get(draw(world.size())).applyForce(force(), force());
        }
        if (draw(32) == 0) throw new Halt();
    }

    private static double limit(double v, double most) {
        return Math.max(-most, Math.min(most, v));
    }

    /** {@return a unit found by a random id, or by a random index if there is none} */
    private Unit any(World world) {
        int size = world.size();
        Unit unit = finds ? world.find(world.get(size - 1).getId() - draw(2 * size)) : null;
        return unit != null ? unit : world.get(draw(size));
    }

    /** An order to a unit. */
    private void order(World world) {
        if (world.size() == 0) return;
        Unit unit = any(world);
        switch (draw(20)) {
            case 0:
                world.remove(unit);
                bench.add(unit);
                break;
            case 1:
                if (!bench.isEmpty()) addIfOutside(world, bench.remove(draw(bench.size())));
                break;
            case 2:
                world.remove(unit);
                world.add(unit);
                break;
            case 3:
                unit.setMass(mass());
                break;
            case 4:
                unit.setFriction(friction(unit));
                break;
            case 5:
                unit.setMaxSpeed(maxSpeed());
                break;
            case 6:
                unit.setVelocity(signed(1e-3, 1e3, Double.MAX_VALUE), signed(1e-3, 1e3, Double.MAX_VALUE));
                break;
            case 7:
                unit.setVelocity(signed(1e-155, 1e-140, 1), signed(1e-155, 1e3, 1)); // near the rest threshold
                break;
            case 8:
                unit.setPosition(signed(1e-3, 1e3, Double.MAX_VALUE), signed(1e-3, 1e3, Double.MAX_VALUE));
                break;
            case 9: // to its interpolated position
                double alpha = draw(5) / 4.0;
                if (draw(2) == 0) unit.setPosition(unit.getInterpolatedX(alpha), unit.getInterpolatedY());
                else unit.moveTo(unit.getInterpolatedX(alpha), unit.getInterpolatedY());
                break;
            case 10:
                unit.applyImpulse(signed(1e-3, 1e6, 1e50), signed(1e-3, 1e6, 1e50));
                break;
            case 11:
                unit.clearForces();
                break;
            case 12:
                unit.integrate(seconds(), integrator());
                break;
            case 13:
                unit.setFrozen(draw(3) == 0);
                break;
            case 14:
                if (draw(4) == 0) drive(unit);
                else unit.applyForce(force(), force());
                break;
            default:
                unit.applyForce(force(), force());
        }
        if (bench.size() > 100) addIfOutside(world, bench.remove(0));
    }

    /** Adds a unit, unless a restore has already returned it to the world. */
    private static void addIfOutside(World world, Unit unit) {
        if (unit.getWorld() == null) world.add(unit);
    }

    /** An order to the whole world. */
    private void orderAll(World world) {
        switch (draw(16)) {
            case 0:
                world.removeIf(unit -> draw(8) == 0);
                break;
            case 1:
                applyForces(world);
                break;
            case 2:
                if (world.size() > 0) explode(world, any(world));
                break;
            case 3:
                if (draw(3) == 0) world.setTimestep(TIMESTEPS[draw(TIMESTEPS.length)]);
                break;
            case 4:
                lookAhead(world);
                break;
            case 5:
                if (draw(3) == 0) load(world);
                break;
            case 6:
                if (draw(20) == 0) world.clear();
                break;
            case 7:
                follow(world);
                break;
            case 8: // motors are rare, so that some tiles have none
                if (draw(4) == 0) for (int i = draw(32); i < world.size(); i += 32) drive(world.get(i));
                else for (Unit unit : world) unit.setMotor(0, 0, 0);
                break;
            default: // one of each four, or all
                for (int i = draw(4), by = draw(2) == 0 ? 4 : 1; i < world.size(); i += by) {
                    double force = force();
                    world.get(i).applyForce(force, force / -3);
                }
        }
    }

    private void applyForces(World world) {
        int offset = draw(3);
        double[] xy = new double[offset + 2 * world.size()];
        for (int i = offset; i < xy.length; i++) xy[i] = draw(4) == 0 ? force() : 0;
        world.applyForces(xy, offset);
    }

    /** Kicks the units near a unit away from it, or towards it. */
    private void explode(World world, Unit bomb) {
        double x = bomb.getX(), y = bomb.getY(), radius = positive(1, 1e5, 1, 1e9), power = signed(1, 1e6, 1e9);
        for (Unit unit : world) {
            double dx = unit.getX() - x, dy = unit.getY() - y, square = dx * dx + dy * dy;
            if (!(square < radius * radius)) continue;
            double k = power / (1 + square); // and so falls as 1/r
            unit.applyImpulse(k * dx, k * dy);
        }
    }

    /** Plays some steps and restores the world; then applies a force that depends on their result. */
    private void lookAhead(World world) {
        world.save(past);
        if (world.size() > 0) world.remove(any(world));
        world.add(newUnit()).applyForce(force(), force());
        world.step(seconds());
        world.advance(seconds());
        double led = world.size() > 0 ? world.get(0).getX() : 0;
        world.restore(past);
        if (world.size() > 0) world.get(0).applyForce(limit(led, 1e6), 0);
    }

    /** Restores from bytes: units that were removed are created again. */
    private void load(World world) {
        byte[] save = world.save().toBytes();
        world.removeIf(unit -> draw(8) == 0);
        world.restore(Snapshot.fromBytes(save));
    }

    /** Moves some units to the interpolated positions of others, with their velocities. */
    private void follow(World world) {
        int n = world.size();
        double[] positions = new double[2 * n], velocities = new double[2 * n];
        float[] drawn = new float[2 * n + 1];
        world.copyPositions(positions, 0, draw(5) / 4.0);
        world.copyPositions(drawn, 1);
        world.copyVelocities(velocities, 0);
        for (int i = draw(16); i < n; i += 16) {
            int j = draw(n);
            world.get(i).setPosition(positions[2 * j], drawn[2 + 2 * j]);
            world.get(i).setVelocity(velocities[2 * j], velocities[2 * j + 1]);
        }
    }

    /** Sets a motor that drives, brakes, or is off. */
    private void drive(Unit unit) {
        boolean brake = draw(3) == 0;
        double vx = brake ? 0 : signed(1e-3, 1e3, Double.MAX_VALUE), vy = brake ? 0 : signed(1e-3, 1e3, 1e-155);
        unit.setMotor(vx, vy, draw(4) == 0 ? 0 : positive(1e-3, 1e6, 0, 1e50));
    }

    private Unit newUnit() {
        Unit unit = new Unit(mass());
        unit.setFriction(friction(unit)).setMaxSpeed(maxSpeed()).setFrozen(draw(32) == 0);
        return unit.setPosition(signed(1e-3, 1e4, Double.MAX_VALUE), signed(1e-3, 1e4, Double.MAX_VALUE));
    }

    private double mass() {
        return positive(1e-2, 1e5, 1e-50, 1e50);
    }

    /** Usually such that f dt/m is between 1e-6 and 1e3. */
    private double friction(Unit unit) {
        if (draw(8) == 0) return 0;
        if (draw(rare) == 0) return positive(1e-2, 1e5, 0, 1e50);
        return Math.min(1e50, positive(1e-6, 1e3, 0, 1e3) * unit.getMass() * 60);
    }

    /** Usually a speed that some units reach. */
    private double maxSpeed() {
        if (draw(3) == 0) return draw(2 * rare) == 0 ? 0 : Double.POSITIVE_INFINITY;
        return positive(0.1, 1e3, Double.MIN_VALUE, Double.MAX_VALUE);
    }

    private double force() {
        return signed(1e-3, 1e6, 1e50);
    }

    private double seconds() {
        return draw(rare) == 0 ? 0 : positive(1e-3, 0.1, 1e-9, 1e9);
    }

    private Integrator integrator() {
        return Integrator.values()[draw(4)];
    }

    private double signed(double min, double max, double most) {
        double v = positive(min, max, 1e-300, most);
        return draw(2) == 0 ? v : -v;
    }

    /** From min to max, or rarely from least to most; nearly uniform in the logarithm. */
    private double positive(double min, double max, double least, double most) {
        boolean usual = draw(rare) != 0;
        long from = bits(usual ? min : least), to = bits(usual ? max : most);
        return Double.longBitsToDouble(from + next() % (to - from + 1));
    }

    private int draw(int n) {
        return (int) (next() % n);
    }

    /** Not negative. */
    private long next() {
        return scramble(seed += GOLDEN) >>> 1;
    }

    /** SplitMix64's finalizer (Steele, Lea, Flood, 2014): written out, so that it is the same in every release. */
    public static long scramble(long v) {
        v = (v ^ (v >>> 30)) * 0xBF58476D1CE4E5B9L;
        v = (v ^ (v >>> 27)) * 0x94D049BB133111EBL;
        return v ^ (v >>> 31);
    }

    /** {@return all values of a world, read without save and stateHash} The sign of 0 is ignored. */
    public static List<Long> bits(World world) {
        List<Long> bits = new ArrayList<>(Arrays.asList(
                world.getTick(), bits(world.getTime()), bits(world.getDroppedTime()), bits(world.getAlpha())));
        bits.add((long) world.getIntegrator().name().hashCode());
        bits.add((long) world.getTimestep().hashCode());
        for (Unit unit : world) bits.addAll(bits(unit));
        return bits;
    }

    /** {@return all values of a unit} Its {@link #kept} values come first. */
    public static List<Long> bits(Unit unit) {
        List<Long> bits = kept(unit);
        for (double v : new double[] {
            unit.getFx(),
            unit.getFy(),
            unit.getPendingImpulseX(),
            unit.getPendingImpulseY(),
            unit.getInterpolatedX(0),
            unit.getInterpolatedY(0),
            unit.getInterpolatedX(),
            unit.getInterpolatedY()
        }) {
            bits.add(bits(v));
        }
        return bits;
    }

    /** {@return the values that a unit keeps when it leaves its world} */
    public static List<Long> kept(Unit unit) {
        List<Long> bits = new ArrayList<>(Arrays.asList(unit.getId(), unit.isFrozen() ? 1L : 0));
        for (double v : new double[] {
            unit.getX(),
            unit.getY(),
            unit.getVx(),
            unit.getVy(),
            unit.getMass(),
            unit.getFriction(),
            unit.getMaxSpeed(),
            unit.getMotorVx(),
            unit.getMotorVy(),
            unit.getMotorForce()
        }) {
            bits.add(bits(v));
        }
        return bits;
    }

    private static long bits(double v) {
        return Double.doubleToRawLongBits(v + 0.0);
    }
}
