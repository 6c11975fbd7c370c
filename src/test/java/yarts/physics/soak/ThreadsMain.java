package yarts.physics.soak;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ForkJoinPool;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * Steps worlds of 33,000 and of 200,000 units on pools of 1, 2, 3 and 7 threads and on the common pool: one world, and three
 * worlds that share the pool. Ends the JVM with a dump of all threads if a step takes longer than 10 s, and fails if a world
 * differs from one that steps without a pool.
 *
 * <pre>{@code java -cp … yarts.physics.soak.ThreadsMain <steps of each small world>}</pre>
 */
public final class ThreadsMain {
    private static final int SMALL = 33_000, LARGE = 200_000; // units
    /** The steps of a large world, as a part of those of a small one. */
    private static final int PART = 20;

    private static final long LIMIT = 10_000_000_000L; // ns

    private ThreadsMain() {}

    public static void main(String[] args) throws InterruptedException {
        int steps = Integer.parseInt(args[0]);
        long total = 0;
        for (int units : new int[] {SMALL, LARGE}) {
            int n = units == SMALL ? steps : steps / PART;
            long expected = new Stepper(units, null, n).call();
            for (int threads : new int[] {1, 2, 3, 7, 0}) {
                for (int worlds : new int[] {1, 3}) {
                    long start = System.nanoTime();
                    play(units, n, threads, worlds, expected);
                    total += (long) n * worlds;
                    System.out.printf(
                            Locale.ROOT,
                            "%d units, %s, worlds: %d, steps: %d, %.1f s%n",
                            units,
                            threads == 0 ? "common pool" : "pool of " + threads,
                            worlds,
                            n,
                            (System.nanoTime() - start) / 1e9);
                }
            }
        }
        System.out.println(total + " steps with pools, the same bits");
    }

    private static void play(int units, int steps, int threads, int worlds, long expected) throws InterruptedException {
        ForkJoinPool pool = threads == 0 ? ForkJoinPool.commonPool() : new ForkJoinPool(threads);
        List<Stepper> steppers = new ArrayList<>();
        for (int i = 0; i < worlds; i++) steppers.add(new Stepper(units, pool, steps));
        List<Thread> callers = new ArrayList<>();
        for (Stepper stepper : steppers) callers.add(new Thread(stepper::call));
        callers.forEach(Thread::start);
        for (int i = 0; i < worlds; ) {
            callers.get(i).join(1_000);
            for (Stepper stepper : steppers) stepper.check();
            if (!callers.get(i).isAlive()) i++;
        }
        for (Stepper stepper : steppers) {
            if (stepper.hash != expected) throw new IllegalStateException(units + " units: another hash with a pool");
        }
        if (threads != 0) pool.shutdown();
    }

    /** Steps a world, in which some units move and some are pushed now and then. */
    private static final class Stepper {
        private final World world = new World(Integrator.EXACT, Timestep.fixed(60));
        private final int steps;
        private volatile long begun = Long.MAX_VALUE; // ns, of the present step
        private volatile long hash;

        Stepper(int units, ForkJoinPool pool, int steps) {
            this.steps = steps;
            for (int i = 0; i < units; i++) world.add(new Unit(1 + i % 3).setVelocity(i % 7 - 3, i % 5 - 2));
            if (pool != null) world.setPool(pool);
        }

        long call() {
            for (int step = 0; step < steps; step++) {
                begun = System.nanoTime();
                if (step % 16 == 0) world.get(step % world.size()).applyImpulse(1, 0);
                world.step();
            }
            begun = Long.MAX_VALUE;
            hash = world.stateHash();
            return hash;
        }

        void check() {
            long since = begun;
            if (since == Long.MAX_VALUE || System.nanoTime() - since < LIMIT) return;
            System.out.println("a step hangs at tick " + world.getTick());
            Thread.getAllStackTraces().forEach((thread, trace) -> {
                System.out.println(thread);
                for (StackTraceElement element : trace) System.out.println("    " + element);
            });
            Runtime.getRuntime().halt(1);
        }
    }
}
