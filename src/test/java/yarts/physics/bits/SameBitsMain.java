package yarts.physics.bits;

import java.util.concurrent.ForkJoinPool;
import java.util.function.Consumer;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Plays {@link Churn} with each integrator, and prints a hash of all states and of all values that getters return. The
 * output is the same on any JVM, with any flags and any number of threads.
 *
 * <pre>{@code java -cp … yarts.physics.bits.SameBitsMain <units> <ticks> <threads>}</pre>
 */
public final class SameBitsMain {
    private final World world;
    private long hash;

    private SameBitsMain(Integrator integrator) {
        world = new World(integrator, Timestep.fixed(60).withMaxSteps(4));
    }

    public static void main(String[] args) {
        System.out.println(play(Integer.parseInt(args[0]), Integer.parseInt(args[1]), Integer.parseInt(args[2])));
    }

    /** {@return a line with a hash for each integrator} */
    static String play(int units, int ticks, int threads) {
        if (threads == 1) return play(units, ticks, world -> {});
        ForkJoinPool pool = new ForkJoinPool(threads);
        try {
            String line = play(units, ticks, world -> world.setPool(pool));
            if (pool.getStealCount() == 0) throw new IllegalStateException("the pool had no work");
            return line;
        } finally {
            pool.shutdown();
        }
    }

    /** The same in worlds that the caller sets up. It needs no threads, so it runs on platforms without them. */
    public static String play(int units, int ticks, Consumer<World> setUp) {
        StringBuilder line = new StringBuilder();
        for (Integrator integrator : Integrator.values()) {
            SameBitsMain game = new SameBitsMain(integrator);
            setUp.accept(game.world);
            line.append(integrator).append(' ');
            line.append(Long.toHexString(game.run(units, ticks))).append(' ');
        }
        return line.toString().trim();
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

    /** Ignores the sign of 0. */
    private void mix(double v) {
        mix(Double.doubleToRawLongBits(v + 0.0));
    }

    private void mix(long v) {
        hash = Churn.scramble(hash * 31 + v);
    }
}
