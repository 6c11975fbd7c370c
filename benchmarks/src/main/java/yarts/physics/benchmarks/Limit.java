package yarts.physics.benchmarks;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.IntConsumer;
import yarts.physics.Integrator;
import yarts.physics.World;

/**
 * Four numbers for each size of world, in ns per unit, to set beside those of a plain loop in C: a step alone
 * ("cached"), a step with another dt than the one before ("computed"), a force on every unit ("force"), and a force and
 * a step ("both"). Medians of nine rounds, each of eight million units or so. No JMH: it prints within seconds, so that
 * it and the other program can take turns.
 */
final class Limit {
    private static final int ROUNDS = 9;
    private static final int WARM_UP = 3; // rounds
    private static final double DT = Workload.DT;

    private Limit() {}

    /** Measures; the second argument may name an integrator other than EULER. */
    static void main(String[] args) {
        Integrator how = args.length > 1 ? Integrator.valueOf(args[1].toUpperCase(Locale.ROOT)) : Integrator.EULER;
        measure(how, 10_000); // for the compiler, which sees every loop before it is measured
        for (int units : new int[] {1_000, 10_000, 100_000, 1_000_000}) {
            System.out.println(measure(how, units));
        }
    }

    private static String measure(Integrator how, int units) {
        Army army = Army.of(units);
        World world = army.world(how);
        Workload.collect();
        double[] cached = new double[ROUNDS], computed = new double[ROUNDS];
        double[] force = new double[ROUNDS], both = new double[ROUNDS];
        for (int r = -WARM_UP; r < ROUNDS; r++) {
            int i = Math.max(r, 0);
            cached[i] = time(units, k -> step(army, world, DT));
            computed[i] = time(units, k -> step(army, world, k % 2 == 0 ? DT / 2 : DT));
            force[i] = time(units, k -> Workload.push(world));
            world.step(0); // uses the forces up, and the next one is as the steps measured
            world.step(DT);
            both[i] = time(units, k -> {
                Workload.push(world);
                world.step(DT);
            });
        }
        return String.format(
                Locale.ROOT,
                "units %d cached %.2f computed %.2f force %.2f both %.2f",
                units,
                median(cached),
                median(computed),
                median(force),
                median(both));
    }

    private static void step(Army army, World world, double dt) {
        army.keepMoving(world);
        world.step(dt);
    }

    /** Runs work on all units again and again; returns ns per unit. */
    private static double time(int units, IntConsumer work) {
        int times = Math.max(8, 8_000_000 / units);
        long start = System.nanoTime();
        for (int k = 0; k < times; k++) work.accept(k);
        return (System.nanoTime() - start) / ((double) times * units);
    }

    private static double median(double[] a) {
        Arrays.sort(a);
        return a[a.length / 2];
    }
}
