package yarts.physics;

import java.util.ArrayDeque;
import java.util.concurrent.ForkJoinPool;

/**
 * Plays a game's worth of everything with each integrator, and prints a hash of all its states and of all that can be
 * read of them. Run it on any JVM, with any flags, on any number of threads: it prints the same.
 *
 * <pre>{@code java -cp … yarts.physics.SameBitsMain <units> <ticks> <threads>}</pre>
 */
public final class SameBitsMain {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    private final World world;
    private final ArrayDeque<Unit> reserve = new ArrayDeque<>();
    private long seed = 1;
    private long hash;

    private SameBitsMain(Integrator how, ForkJoinPool pool) {
        world = new World(how, Timestep.fixed(60).withMaxSteps(4));
        if (pool != null) world.team = new Team(pool, 1); // which would leave so small a world to the caller
    }

    public static void main(String[] args) {
        System.out.println(play(Integer.parseInt(args[0]), Integer.parseInt(args[1]), Integer.parseInt(args[2])));
    }

    /** {@return a line with a hash for each integrator} */
    static String play(int units, int ticks, int threads) {
        ForkJoinPool pool = threads == 1 ? null : new ForkJoinPool(threads);
        try {
            StringBuilder line = new StringBuilder();
            for (Integrator how : Integrator.values()) {
                long hash = new SameBitsMain(how, pool).run(units, ticks);
                line.append(how).append(' ').append(Long.toHexString(hash)).append(' ');
            }
            return line.toString().trim();
        } finally {
            if (pool != null) pool.shutdown();
        }
    }

    private long run(int units, int ticks) {
        for (int i = 0; i < units; i++) {
            Unit unit = recruit(new Unit(between(1e-2, 1e5)));
            world.add(unit.setPosition(signed(1, 1e4), signed(1, 1e4)));
        }
        world.setStepListener((w, dt) -> {
            for (int i = 0; i < w.size(); i += 16)
                w.get(i).applyForce(dt, -w.get(i).getVx());
        });
        while (world.getTick() < ticks) {
            command();
            if (next() % 8 == 0) explode(world.get((int) (next() % world.size())), between(1, 1e5), signed(1, 1e6));
            long tick = world.getTick();
            // Time passes in fixed ticks, but for one frame in sixteen, whose step is of a length of its own.
            if (next() % 16 == 0) world.step(between(1e-3, 1));
            else if (next() % 4 == 0) world.step(1 / 60.0);
            else world.advance(between(2e-3, 0.1));
            mix(world.stateHash());
            if (world.getTick() >> 6 != tick >> 6) mixAll();
        }
        mixAll();
        return hash;
    }

    /** Kicks whoever is near a unit away from it, or towards it. */
    private void explode(Unit bomb, double radius, double power) {
        double x = bomb.getX(), y = bomb.getY();
        for (Unit unit : world) {
            double dx = unit.getX() - x, dy = unit.getY() - y, square = dx * dx + dy * dy;
            if (!(square < radius * radius)) continue;
            double k = power / (1 + square); // and so falls as 1/r
            unit.applyImpulse(k * dx, k * dy);
        }
    }

    /** A frame's orders to a quarter of the units: most of these are pushed, some changed, some removed. */
    private void command() {
        for (int i = (int) (next() % 4); i < world.size(); i += 4) {
            Unit unit = world.get(i);
            switch ((int) (next() & 63)) {
                case 0:
                    unit.applyImpulse(signed(1e-2, 1e6), signed(1e-2, 1e6));
                    break;
                case 1:
                    recruit(unit);
                    break;
                case 2:
                    unit.setMass(between(1e-2, 1e5));
                    break;
                case 3:
                    unit.setVelocity(signed(1e-155, 1e-140), signed(1e-3, 1e3)); // the first is near rest
                    break;
                case 4:
                    unit.integrate(between(1e-3, 1), Integrator.values()[(int) (next() % 3)]);
                    break;
                case 5:
                    world.remove(unit);
                    reserve.add(unit);
                    break;
                default: // half of them coast
                    if ((i & 4) == 0) {
                        double force = signed(1e-3, 1e6);
                        unit.applyForce(force, force / -3);
                    }
            }
        }
        while (reserve.size() > 100) world.add(reserve.remove());
    }

    /** Sets friction such that f dt/m lies between 1e-6 and 1e3, or is 0, and a top speed that some reach. */
    private Unit recruit(Unit unit) {
        double z = next() % 8 == 0 ? 0 : between(1e-6, 1e3);
        double cap = next() % 3 == 0 ? Double.POSITIVE_INFINITY : between(0.1, 1e3);
        return unit.setFriction(z * unit.getMass() * 60).setMaxSpeed(cap);
    }

    private void mixAll() {
        mix(world.getTime());
        mix(world.getDroppedTime());
        mix(world.getAlpha());
        for (Unit unit : world) {
            mix(unit.getX());
            mix(unit.getY());
            mix(unit.getVx());
            mix(unit.getVy());
            mix(unit.getSpeed());
            mix(unit.getInterpolatedX());
            mix(unit.getInterpolatedY());
        }
        float[] xy = new float[2 * world.size()];
        world.copyPositions(xy, 0);
        for (float v : xy) mix(v);
    }

    private void mix(double v) {
        mix(Double.doubleToRawLongBits(v));
    }

    private void mix(long v) {
        hash = scramble(hash * 31 + v);
    }

    /** Not negative. */
    private long next() {
        return scramble(seed += GOLDEN) >>> 1;
    }

    /** SplitMix64's finalizer (Steele, Lea, Flood, 2014): written out, so that it is the same in every release. */
    private static long scramble(long v) {
        v = (v ^ (v >>> 30)) * 0xBF58476D1CE4E5B9L;
        v = (v ^ (v >>> 27)) * 0x94D049BB133111EBL;
        return v ^ (v >>> 31);
    }

    /** Any of the bit patterns from min to max: uniform in the logarithm, nearly. */
    private double between(double min, double max) {
        long from = Double.doubleToRawLongBits(min);
        return Double.longBitsToDouble(from + next() % (Double.doubleToRawLongBits(max) - from));
    }

    private double signed(double min, double max) {
        return (next() & 1) == 0 ? between(min, max) : -between(min, max);
    }
}
