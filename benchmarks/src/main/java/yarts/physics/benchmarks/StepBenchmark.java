package yarts.physics.benchmarks;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/** A step of a world by each integrator, and the forces before it. */
public class StepBenchmark extends Workload {
    private static final int TILE = 512; // rows

    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    @Param({"EULER", "SEMI_IMPLICIT", "MIDPOINT", "EXACT"})
    public Integrator integrator;

    private Army army;
    private World world;
    private Unit[] handles;
    private List<Unit> few, twoInEachTile;
    private double[] forces;
    private int tick;

    /** Steps the world before each call. */
    @State(Scope.Thread)
    public static class Stepped {
        /** Not measured. */
        @Setup(Level.Invocation)
        public void step(StepBenchmark benchmark) {
            benchmark.world.step(DT);
        }
    }

    @Setup
    public void create() {
        army = Army.of(units);
        world = army.world(integrator);
        handles = world.units().toArray(new Unit[0]);
        few = Army.oneInAThousand(world);
        twoInEachTile = IntStream.range(0, units)
                .filter(i -> i % TILE < 2)
                .mapToObj(world::get)
                .collect(Collectors.toList());
        forces = forces(units);
        collect();
    }

    /** A force on every unit, without a step: the forces add up. */
    @Benchmark
    public void force() {
        for (Unit unit : handles) unit.applyForce(FX, FY);
    }

    /** The same, with the iterator of the world. */
    @Benchmark
    public void forceByIterator() {
        push(world);
    }

    /** As force, after a step, as in a game. The step is not measured, but its data is in the caches. */
    @Benchmark
    public void forceAfterStep(Stepped stepped) {
        force();
    }

    /** The usual work of a game: a force on every unit, and a step. */
    @Benchmark
    public void both() {
        push(world);
        world.step(DT);
    }

    /** The same, with all forces in one call. */
    @Benchmark
    public void bulk() {
        world.applyForces(forces, 0);
        world.step(DT);
    }

    /** A force on one unit in a thousand, and a step. All units move. */
    @Benchmark
    public void oneInAThousand() {
        army.keepMoving(world);
        push(few);
        world.step(DT);
    }

    /**
     * A force on two units in every tile, and a step. Few forces are applied, but the step integrates those of all
     * units.
     */
    @Benchmark
    public void twoInEachTile() {
        push(twoInEachTile);
        world.step(DT);
    }

    /** A step without forces. */
    @Benchmark
    public void step() {
        army.keepMoving(world);
        world.step(DT);
    }

    /** A step without forces, with another dt each time, so that all coefficients are computed again. */
    @Benchmark
    public void changingDt() {
        army.keepMoving(world);
        tick = (tick + 1) % 1000;
        world.step(DT + tick * 1e-6);
    }
}
