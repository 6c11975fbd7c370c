package yarts.physics.bits;

import java.util.concurrent.ForkJoinPool;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Plays {@link Churn} with each integrator, and prints a hash of all its states and of all that can be read of them. Run
 * it on any JVM, with any flags, on any number of threads: it prints the same.
 *
 * <pre>{@code java -cp … yarts.physics.bits.SameBitsMain <units> <ticks> <threads>}</pre>
 */
public final class SameBitsMain {
    private final World world;
    private long hash;

    private SameBitsMain(Integrator integrator, ForkJoinPool pool) {
        world = new World(integrator, Timestep.fixed(60).withMaxSteps(4));
        world.setPool(pool);
    }

    public static void main(String[] args) {
        System.out.println(play(Integer.parseInt(args[0]), Integer.parseInt(args[1]), Integer.parseInt(args[2])));
    }

    /** {@return a line with a hash for each integrator} */
    static String play(int units, int ticks, int threads) {
        ForkJoinPool pool = threads == 1 ? null : new ForkJoinPool(threads);
        try {
            StringBuilder line = new StringBuilder();
            for (Integrator integrator : Integrator.values()) {
                long hash = new SameBitsMain(integrator, pool).run(units, ticks);
                line.append(integrator)
                        .append(' ')
                        .append(Long.toHexString(hash))
                        .append(' ');
            }
            if (pool != null && pool.getStealCount() == 0) throw new IllegalStateException("the pool had no work");
            return line.toString().trim();
        } finally {
            if (pool != null) pool.shutdown();
        }
    }

    private long run(int units, int ticks) {
        Churn game = new Churn(1, units, 200);
        while (world.getTick() < ticks) {
            long tick = world.getTick();
            game.frame(world);
            mix(world.stateHash());
            if (world.getTick() >> 4 != tick >> 4) mixAll();
        }
        mixAll();
        return hash;
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
            mix(unit.getPendingImpulseX());
            mix(unit.getPendingImpulseY());
        }
        float[] xy = new float[2 * world.size()];
        world.copyPositions(xy, 0, 0.75);
        for (float v : xy) mix(v);
    }

    /** Of what is 0, the sign does not count. */
    private void mix(double v) {
        mix(Double.doubleToRawLongBits(v + 0.0));
    }

    private void mix(long v) {
        hash = Churn.scramble(hash * 31 + v);
    }
}
