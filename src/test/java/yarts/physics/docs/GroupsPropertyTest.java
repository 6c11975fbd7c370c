package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.DoubleToIntFunction;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.GenerationMode;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The recipes for groups in docs/cookbook.md: separation with a grid, and a crowd at one point. */
class GroupsPropertyTest {
    private static final double REACH = 4, GOLDEN = 2.399963; // m, radians

    @Provide
    Arbitrary<Integer> rates() {
        return Arbitraries.of(20, 60);
    }

    @Property
    void theGridFindsEachNearPairOnceOnTheMapAndBeyondItsEdge(
            @ForAll long seed,
            @ForAll @IntRange(min = 0, max = 300) int n,
            @ForAll @IntRange(min = 1, max = 40) int cells) {
        double reach = 4;
        Random random = new Random(seed);
        double[] x = new double[n], y = new double[n];
        for (int i = 0; i < n; i++) {
            x[i] = reach * cells * (1.5 * random.nextDouble() - 0.25);
            y[i] = reach * cells * (1.5 * random.nextDouble() - 0.25);
            if (random.nextInt(4) == 0) y[i] = reach * Math.rint(y[i] / reach); // on the edge of a cell
        }
        Set<Long> found = new TreeSet<>(), near = new TreeSet<>();
        int side = cells + 2;
        int[] around = {-side - 1, -side, -side + 1, -1, 0, 1, side - 1, side, side + 1};
        DoubleToIntFunction cell = v -> (int) Math.max(1, Math.min(side - 2, 1 + v / reach));
        int[] head = new int[side * side], next = new int[n];
        Arrays.fill(head, -1);
        for (int i = 0; i < n; i++) {
            int home = side * cell.applyAsInt(y[i]) + cell.applyAsInt(x[i]);
            for (int step : around) {
                for (int j = head[home + step]; j >= 0; j = next[j]) {
                    if (Math.hypot(x[i] - x[j], y[i] - y[j]) < reach) assertTrue(found.add(1000L * i + j), "twice");
                }
            }
            next[i] = head[home];
            head[home] = i;
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) if (Math.hypot(x[i] - x[j], y[i] - y[j]) < reach) near.add(1000L * i + j);
        }
        assertEquals(near, found);
    }

    /** The sum of the pushes on each unit, as in the recipe, but from all pairs instead of a grid. */
    private static double[] pushes(World world, double k, double limit) {
        double[] push = new double[2 * world.size()], xy = push.clone();
        world.copyPositions(xy, 0, 1);
        for (int i = 0; i < xy.length; i += 2) {
            for (int j = 0; j < i; j += 2) {
                double dx = xy[i] - xy[j], dy = xy[i + 1] - xy[j + 1];
                if (Math.abs(dx) >= REACH || Math.abs(dy) >= REACH) continue;
                if (dx == 0 && dy == 0) {
                    int unit = i / 2;
                    dx = 1e-9 * StrictMath.cos(GOLDEN * unit);
                    dy = 1e-9 * StrictMath.sin(GOLDEN * unit);
                }
                double distance = Math.sqrt(dx * dx + dy * dy), force = k * (REACH / distance - 1);
                if (distance >= REACH) continue;
                push[i] += force * dx;
                push[i + 1] += force * dy;
                push[j] -= force * dx;
                push[j + 1] -= force * dy;
            }
        }
        for (int i = 0; i < push.length; i += 2) {
            double factor = limit / Math.max(limit, Math.hypot(push[i], push[i + 1]));
            push[i] *= factor;
            push[i + 1] *= factor;
        }
        return push;
    }

    private static double fastest(World world) {
        double fastest = 0;
        for (Unit unit : world) fastest = Math.max(fastest, unit.getSpeed());
        return fastest;
    }

    /** Runs only the separation for a time in s. Returns the highest speed. */
    private static double separate(World world, int units, double scatter, double time) {
        Random random = new Random(1);
        for (int i = 0; i < units; i++) {
            Unit unit = world.add(new Unit(1_000).setFriction(4_000));
            unit.setPosition(scatter * random.nextDouble(), scatter * random.nextDouble());
        }
        world.addBeforeStep((w, dt) -> w.applyForces(pushes(w, 4_000, 20_000), 0));
        double top = 0;
        while (world.getTime() < time) {
            world.step();
            top = Math.max(top, fastest(world));
        }
        return top;
    }

    /** With a constant direction, they formed a line of 145 m, and 54 of them still moved after two minutes. */
    @Property(generation = GenerationMode.EXHAUSTIVE)
    void sixtyUnitsAtOnePointSeparateInAllDirectionsAndComeToRest(
            @ForAll Integrator integrator, @ForAll("rates") int rate) {
        World world = new World(integrator, Timestep.fixed(rate));
        separate(world, 60, 0, 120);
        assertTrue(fastest(world) < 0.01, () -> fastest(world) + " m/s");
        for (Unit a : world) {
            assertTrue(Math.hypot(a.getX(), a.getY()) < 20, a::toString);
            for (Unit b : world)
                assertTrue(a == b || Math.hypot(a.getX() - b.getX(), a.getY() - b.getY()) > 0.98 * REACH);
        }
    }

    /** Without a limit, they reached 184 m/s. */
    @Property(generation = GenerationMode.EXHAUSTIVE)
    void fiveHundredUnitsWithinTenCentimetresNeverExceedTheLimitOverFriction(@ForAll Integrator integrator) {
        assertTrue(separate(new World(integrator, Timestep.fixed(20)), 500, 0.1, 20) <= 5 * (1 + 1e-12));
    }

    /** With places on a spiral and swaps, they are at rest within a minute. */
    @Property(generation = GenerationMode.EXHAUSTIVE)
    void sixtyTanksWithOneGoalComeToRestAndNeverTurnBackInTheSecondMinute(
            @ForAll Integrator integrator, @ForAll("rates") int rate) {
        int n = 60;
        double lag = integrator == Integrator.EULER ? 1 : integrator == Integrator.SEMI_IMPLICIT ? 0 : 0.5;
        World world = new World(integrator, Timestep.fixed(rate));
        Random random = new Random(1);
        double[] x = new double[n], y = new double[n];
        for (int i = 0; i < n; i++) {
            world.add(new Unit(1_000)).setPosition(60 * random.nextDouble() - 100, 60 * random.nextDouble() - 30);
            double radius = 0.65 * REACH * Math.sqrt(i + 0.5);
            x[i] = radius * StrictMath.cos(GOLDEN * i);
            y[i] = radius * StrictMath.sin(GOLDEN * i);
        }
        world.addBeforeStep((w, dt) -> {
            swap(w, x, y);
            w.applyForces(pushes(w, 20_000, 8_000), 0);
            for (int i = 0; i < n; i++) arrive(w.get(i), x[i], y[i], lag, dt);
        });
        while (world.getTime() < 60) world.step();
        double[] before = new double[2 * n], after = before.clone();
        world.copyPositions(before, 0, 1);
        while (world.getTime() < 120) {
            world.step();
            assertEquals(0, fastest(world));
        }
        world.copyPositions(after, 0, 1);
        assertArrayEquals(before, after);
        for (int i = 0; i < n; i++) assertEquals(0, Math.hypot(after[2 * i] - x[i], after[2 * i + 1] - y[i]), 1e-9);
    }

    private static void swap(World world, double[] x, double[] y) {
        for (int i = 0; i < x.length; i++) {
            for (int j = 0; j < i; j++) {
                double dx = world.get(i).getX() - world.get(j).getX(),
                        dy = world.get(i).getY() - world.get(j).getY();
                if (Math.hypot(dx, dy) >= REACH || dx * (x[i] - x[j]) + dy * (y[i] - y[j]) >= 0) continue;
                for (double[] v : new double[][] {x, y}) {
                    double old = v[i];
                    v[i] = v[j];
                    v[j] = old;
                }
            }
        }
    }

    private static void arrive(Unit unit, double goalX, double goalY, double lag, double dt) {
        double engine = 4, brakes = 8, top = 10, u = 0; // m/s², m/s
        double dx = goalX - unit.getX() - lag * dt * unit.getVx(), dy = goalY - unit.getY() - lag * dt * unit.getVy();
        double left = Math.hypot(dx, dy);
        if (left > 1e-10) {
            double n = Math.ceil((Math.sqrt(1 + 8 * left / (brakes * dt * dt)) - 1) / 2 - 1e-12);
            u = Math.min(2 * left / ((1 + Math.max(1, n)) * dt), top);
        }
        double away = Math.max(1e-10, left), force = 1_000 * (u == 0 || u < unit.getSpeed() ? brakes : engine);
        unit.setMotor(u * dx / away, u * dy / away, force);
    }
}
