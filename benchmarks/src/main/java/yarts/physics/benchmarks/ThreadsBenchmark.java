package yarts.physics.benchmarks;

import java.util.concurrent.ForkJoinPool;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.TearDown;
import yarts.physics.Integrator;
import yarts.physics.World;

/** A step alone, by EULER, on one thread and on two; meaningful only if the machine has two. */
public class ThreadsBenchmark extends Workload {
    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    @Param({"1", "2"})
    public int threads;

    private Army army;
    private World world;
    private ForkJoinPool pool;

    @Setup
    public void create() {
        army = Army.of(units);
        world = army.world(Integrator.EULER);
        pool = new ForkJoinPool(threads);
        world.setPool(pool);
        collect();
    }

    @TearDown
    public void end() {
        pool.shutdown();
    }

    @Benchmark
    public void step() {
        army.keepMoving(world);
        world.step(DT);
    }
}
