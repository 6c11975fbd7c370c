package yarts.physics.soak;

import java.util.Arrays;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Plays a game of 10,000 units for some frames, as fast as possible. Each frame has orders of every kind, saves and
 * restores, units that join and leave, and then some timed steps under forces. At intervals it prints the hash of the
 * world; for each part of the run it prints the duration of a step and the memory in use.
 */
final class SoakMain {
    private static final int UNITS = 10_000, PARTS = 20, STEPS = 8, HASH_EVERY = 10;

    private SoakMain() {}

    private static final class Samples {
        private final long[] ns = new long[1 << 18];
        private int count;

        void add(long t) {
            if (count < ns.length) ns[count++] = t;
        }

        /** {@return a quantile of the samples; 1 is the longest} */
        long quantile(double part) {
            Arrays.sort(ns, 0, count);
            return count == 0 ? 0 : ns[(int) Math.min(count - 1L, (long) (part * count))];
        }
    }

    private static long liveBytes() {
        Runtime jvm = Runtime.getRuntime();
        long least = Long.MAX_VALUE;
        for (int i = 0; i < 3; i++) {
            System.gc();
            least = Math.min(least, jvm.totalMemory() - jvm.freeMemory());
        }
        return least;
    }

    public static void main(String[] args) {
        long frames = Long.parseLong(args[0]);
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        Churn churn = new Churn(1, UNITS, 30);
        Samples samples = new Samples();
        double[] forces = new double[0];
        long frame = 0;
        for (int part = 1; part <= PARTS; part++) {
            samples.count = 0;
            do {
                churn.frame(world);
                if (forces.length < 2 * world.size()) forces = new double[4 * world.size()];
                for (int step = 0; step < STEPS; step++) {
                    for (int i = 0; i < forces.length; i++) forces[i] = (i + frame + step) % 37 - 18;
                    long begin = System.nanoTime();
                    world.applyForces(forces, 0);
                    world.step();
                    samples.add((System.nanoTime() - begin) * UNITS / Math.max(UNITS, world.size()));
                }
                if (++frame % HASH_EVERY == 0) System.out.println("hash " + frame + " " + world.stateHash());
            } while (frame < part * frames / PARTS);
            System.out.println("part " + part + " " + world.getTick() + " " + samples.quantile(0.5) + " "
                    + samples.quantile(0.99) + " " + samples.quantile(1) + " " + liveBytes());
        }
    }
}
