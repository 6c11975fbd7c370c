package yarts.physics.benchmarks;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.IntConsumer;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * Measures seven numbers for each size of world, in ns per unit, for a comparison with plain loops in C:
 *
 * <ul>
 *   <li>"cached": a step alone
 *   <li>"computed": a step with another dt than the step before
 *   <li>"sparse": a force on one unit in a thousand, and a step
 *   <li>"force": a force on every unit, by {@code applyForce}
 *   <li>"both": the same and a step
 *   <li>"bulk": all forces in one call, and a step
 *   <li>"rest": a step of a world at rest
 * </ul>
 *
 * <p>Compare "both" with a C program that does all work of a step (lag, rest, an exact cap, previous positions). The
 * numbers are medians of nine rounds, each of about eight million units. JMH is not used: this program prints within
 * seconds, so it can alternate with the other program.
 */
final class Limit {
    private static final int ROUNDS = 9;
    private static final int WARM_UP = 3; // rounds
    private static final double DT = Workload.DT;

    private Limit() {}

    /** Measures. The second argument may name an integrator (default: EULER), the others the numbers to print. */
    static void main(String[] args) {
        Integrator integrator =
                args.length > 1 ? Integrator.valueOf(args[1].toUpperCase(Locale.ROOT)) : Integrator.EULER;
        Set<String> wanted = args.length > 2 ? Set.of(Arrays.copyOfRange(args, 2, args.length)) : Set.of();
        measure(integrator, 10_000, Set.of()); // warm-up: every loop is compiled before it is measured
        for (int units : new int[] {1_000, 10_000, 100_000, 1_000_000}) {
            System.out.println(measure(integrator, units, wanted));
        }
    }

    private static String measure(Integrator integrator, int units, Set<String> wanted) {
        Army army = Army.of(units);
        World world = army.world(integrator), resting = army.world(integrator);
        for (Unit unit : resting) unit.setVelocity(0, 0);
        List<Unit> few = Army.oneInAThousand(world);
        double[] forces = Workload.forces(units);
        Workload.collect();

        Map<String, IntConsumer> works = new LinkedHashMap<>();
        works.put("cached", k -> step(army, world, DT));
        works.put("computed", k -> step(army, world, k % 2 == 0 ? DT / 2 : DT));
        works.put("sparse", k -> {
            Workload.push(few);
            step(army, world, DT);
        });
        works.put("force", k -> Workload.push(world));
        works.put("both", k -> {
            Workload.push(world);
            world.step(DT);
        });
        works.put("bulk", k -> {
            world.applyForces(forces, 0);
            world.step(DT);
        });
        works.put("rest", k -> resting.step(DT));
        if (!wanted.isEmpty()) works.keySet().retainAll(wanted);

        Map<String, double[]> ns = new LinkedHashMap<>();
        for (String name : works.keySet()) ns.put(name, new double[ROUNDS]);
        for (int r = -WARM_UP; r < ROUNDS; r++) {
            for (String name : works.keySet()) {
                ns.get(name)[Math.max(r, 0)] = time(units, works.get(name));
                world.step(0); // discards forces; then one step as in the measurement
                world.step(DT);
            }
        }
        StringBuilder line = new StringBuilder("units " + units);
        ns.forEach((name, all) -> line.append(String.format(Locale.ROOT, " %s %.2f", name, median(all))));
        return line.toString();
    }

    private static void step(Army army, World world, double dt) {
        army.keepMoving(world);
        world.step(dt);
    }

    /** Repeats work on all units; returns ns per unit. */
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
