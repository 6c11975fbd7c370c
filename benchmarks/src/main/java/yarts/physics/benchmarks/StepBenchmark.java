package yarts.physics.benchmarks;

import java.util.List;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/** A step of a world, by each integrator. */
public class StepBenchmark extends Workload {
    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    @Param({"EULER", "MIDPOINT", "EXACT"})
    public Integrator integrator;

    private Army army;
    private World world;
    private List<Unit> few;
    private double[] forces;
    private int tick;

    @Setup
    public void create() {
        army = Army.of(units);
        world = army.world(integrator);
        few = Army.oneInAThousand(world);
        forces = forces(units);
        collect();
    }

    /** What a game does: a force on every unit, and a step. */
    @Benchmark
    public void both() {
        push(world);
        world.step(DT);
    }

    /** The same, and all forces in one call. */
    @Benchmark
    public void bulk() {
        world.applyForces(forces, 0);
        world.step(DT);
    }

    /** A force on one unit in a thousand, and a step. All are moving. */
    @Benchmark
    public void oneInAThousand() {
        army.keepMoving(world);
        push(few);
        world.step(DT);
    }

    /** No forces. */
    @Benchmark
    public void step() {
        army.keepMoving(world);
        world.step(DT);
    }

    /** No forces, and dt is another one in every step, so that nothing can be kept from the step before. */
    @Benchmark
    public void changingDt() {
        army.keepMoving(world);
        tick = (tick + 1) % 1000;
        world.step(DT + tick * 1e-6);
    }
}
