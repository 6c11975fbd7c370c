package yarts.physics.benchmarks;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import yarts.physics.Integrator;
import yarts.physics.World;

/**
 * The time of a frame with up to ten million units, on one and two threads: a force on each in one call, and a step.
 */
@Fork(value = 1, jvmArgs = "-Xmx8g")
@Warmup(iterations = 3, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 7, time = 500, timeUnit = TimeUnit.MILLISECONDS)
public class LoadBenchmark extends Workload {
    @Param({"10000", "100000", "1000000", "3000000", "10000000"})
    public int units;

    @Param({"1", "2"})
    public int threads;

    @Param
    public Integrator integrator;

    private World world;
    private double[] forces;
    private ForkJoinPool pool;

    @Setup
    public void create() {
        world = Army.of(units).world(integrator);
        forces = forces(units);
        pool = new ForkJoinPool(threads);
        world.setPool(pool);
        collect();
    }

    @TearDown
    public void end() {
        pool.shutdown();
    }

    @Benchmark
    public void frame() {
        world.applyForces(forces, 0);
        world.step(DT);
    }
}
