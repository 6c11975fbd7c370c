package yarts.physics.benchmarks;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntConsumer;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * Seven numbers for each size of world, in ns per unit, to set beside those of a plain loop in C: a step alone
 * ("cached"), a step with another dt than the one before ("computed"), a force on one unit in a thousand and a step
 * ("sparse"), a force on every unit ("force"), that and a step ("both"), the same by one call for all forces ("bulk"),
 * and a step of a world at rest ("rest"). Medians of nine rounds, each of eight million units or so. No JMH: it prints
 * within seconds, so that it and the other program can take turns.
 */
final class Limit {
    private static final int ROUNDS = 9;
    private static final int WARM_UP = 3; // rounds
    private static final double DT = Workload.DT;

    private Limit() {}

    /** Measures; the second argument may name an integrator other than EULER. */
    static void main(String[] args) {
        Integrator integrator =
                args.length > 1 ? Integrator.valueOf(args[1].toUpperCase(Locale.ROOT)) : Integrator.EULER;
        measure(integrator, 10_000); // for the compiler, which sees every loop before it is measured
        for (int units : new int[] {1_000, 10_000, 100_000, 1_000_000}) {
            System.out.println(measure(integrator, units));
        }
    }

    private static String measure(Integrator integrator, int units) {
        Army army = Army.of(units);
        World world = army.world(integrator), resting = army.world(integrator);
        for (Unit unit : resting) unit.setVelocity(0, 0);
        List<Unit> few = Army.oneInAThousand(world);
        double[] forces = Workload.forces(units);
        Workload.collect();
        String[] names = {"cached", "computed", "sparse", "force", "both", "bulk", "rest"};
        double[][] ns = new double[names.length][ROUNDS];
        for (int r = -WARM_UP; r < ROUNDS; r++) {
            int i = Math.max(r, 0);
            ns[0][i] = time(units, k -> step(army, world, DT));
            ns[1][i] = time(units, k -> step(army, world, k % 2 == 0 ? DT / 2 : DT));
            ns[2][i] = time(units, k -> {
                Workload.push(few);
                step(army, world, DT);
            });
            ns[3][i] = time(units, k -> Workload.push(world));
            world.step(0); // uses the forces up, and the next one is as the steps measured
            world.step(DT);
            ns[4][i] = time(units, k -> {
                Workload.push(world);
                world.step(DT);
            });
            ns[5][i] = time(units, k -> {
                world.applyForces(forces, 0);
                world.step(DT);
            });
            ns[6][i] = time(units, k -> resting.step(DT));
        }
        StringBuilder line = new StringBuilder("units " + units);
        for (int k = 0; k < names.length; k++) {
            line.append(String.format(Locale.ROOT, " %s %.2f", names[k], median(ns[k])));
        }
        return line.toString();
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
