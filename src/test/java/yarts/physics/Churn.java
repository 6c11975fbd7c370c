package yarts.physics;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A game drawn from a seed: in its frames it does whatever a game can do to a world, with ordinary and extreme numbers.
 * What it does depends on the seed and the world alone, so that worlds which are alike stay alike.
 */
final class Churn {
    private final SplittableRandom random;
    private final StepListener listener;
    /** Units that were removed, to be added again. */
    private final List<Unit> bench = new ArrayList<>();

    Churn(long seed) {
        random = new SplittableRandom(seed);
        listener = random.nextBoolean() ? Churn::steer : null;
    }

    private static void steer(World world, double dt) {
        for (int i = 0; i < world.size(); i += 3)
            world.get(i).applyForce(dt, Math.min(1e38, Math.abs(world.get(i).getVx())));
        if (world.size() > 5 && world.getTick() % 8 == 0) world.remove(world.get(2));
    }

    /** {@return a world that has seen some frames} */
    static World world(long seed, Integrator how, Timestep timestep, int frames) {
        World world = new World(how, timestep);
        new Churn(seed).play(world, frames);
        return world;
    }

    /** {@return the hash after each of some frames} */
    List<Long> play(World world, int frames) {
        List<Long> hashes = new ArrayList<>();
        for (int i = 0; i < frames; i++) {
            frame(world);
            hashes.add(world.stateHash());
        }
        return hashes;
    }

    private void frame(World world) {
        for (int orders = random.nextInt(8); orders > 0; orders--) order(world);
        world.setStepListener(listener);
        if (random.nextInt(4) == 0) world.step(seconds());
        else world.advance(random.nextInt(3) == 0 ? 0.005 : seconds());
        world.setStepListener(null);
        if (random.nextInt(8) == 0) order(world); // what it leaves is still held when the frame is over
    }

    private void order(World world) {
        if (random.nextInt(4) == 0 || world.size() == 0) {
            for (int n = random.nextInt(50) == 0 ? 300 : random.nextInt(6); n > 0; n--) world.add(recruit());
            return;
        }
        Unit unit = world.get(random.nextInt(world.size()));
        switch (random.nextInt(14)) {
            case 0:
                world.remove(unit);
                bench.add(unit);
                break;
            case 1:
                if (!bench.isEmpty()) world.add(bench.remove(random.nextInt(bench.size())));
                break;
            case 2:
                world.remove(unit);
                world.add(unit);
                break;
            case 3:
                unit.setMass(positive(1e-2, 1e5, 1e-50, 1e50));
                break;
            case 4:
                unit.setFriction(positive(1e-2, 1e5, 0, 1e50));
                break;
            case 5:
                unit.setMaxSpeed(maxSpeed());
                break;
            case 6:
                unit.setVelocity(signed(1e-3, 1e3, Double.MAX_VALUE), signed(1e-3, 1e3, Double.MAX_VALUE));
                break;
            case 7:
                unit.setPosition(signed(1e-3, 1e3, Double.MAX_VALUE), signed(1e-3, 1e3, Double.MAX_VALUE));
                break;
            case 8:
                unit.applyImpulse(signed(1e-3, 1e6, 1e50), signed(1e-3, 1e6, 1e50));
                break;
            case 9:
                unit.clearForces();
                break;
            case 10:
                unit.integrate(seconds(), Integrator.values()[random.nextInt(3)]);
                break;
            case 11:
                if (random.nextInt(20) == 0) world.clear();
                break;
            default:
                for (Unit any : world) if (random.nextBoolean()) any.applyForce(force(), force());
        }
    }

    private Unit recruit() {
        return new Unit(positive(1e-2, 1e5, 1e-50, 1e50))
                .setFriction(positive(1e-2, 1e5, 0, 1e50))
                .setMaxSpeed(maxSpeed());
    }

    private double maxSpeed() {
        if (random.nextInt(3) == 0) return random.nextInt(3) == 0 ? 0 : Double.POSITIVE_INFINITY;
        return positive(0.1, 1e3, Double.MIN_VALUE, Double.MAX_VALUE);
    }

    private double force() {
        return signed(1e-3, 1e6, 1e38);
    }

    private double seconds() {
        return random.nextInt(8) == 0 ? 0 : positive(1e-3, 0.1, 1e-9, 1e9);
    }

    private double signed(double min, double max, double most) {
        double v = positive(min, max, 1e-300, most);
        return random.nextBoolean() ? v : -v;
    }

    /** From min to max, or now and then from least to most: nearly uniform in the logarithm. */
    private double positive(double min, double max, double least, double most) {
        boolean usual = random.nextInt(8) != 0;
        long from = bits(usual ? min : least), to = bits(usual ? max : most);
        return Double.longBitsToDouble(random.nextLong(from, to + 1));
    }

    /** {@return all that can be known of a world, read past save and stateHash} Of what is 0, the sign does not count. */
    static List<Long> bits(World world) {
        List<Long> bits = new ArrayList<>(
                List.of(world.getTick(), bits(world.getTime()), bits(world.getDroppedTime()), bits(world.getAlpha())));
        for (Unit unit : world) bits.addAll(bits(unit));
        return bits;
    }

    static List<Long> bits(Unit unit) {
        List<Long> bits = new ArrayList<>(List.of(unit.getId()));
        for (double[] column : unit.columns.state()) bits.add(bits(column[unit.row]));
        bits.set(Columns.STATE.length - 1, bits(unit.getInterpolatedX())); // for previousX, which may mean nothing
        bits.set(Columns.STATE.length, bits(unit.getInterpolatedY()));
        return bits;
    }

    private static long bits(double v) {
        return Double.doubleToRawLongBits(v + 0.0);
    }
}
