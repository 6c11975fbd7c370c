package yarts.physics.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.Warmup;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.World;

/**
 * A single restore, by EULER, in a JVM that has restored 400 times before, as in a game with rollback that has run for
 * some seconds. HotSpot has not compiled everything by then; {@link GameBenchmark#restore} measures the final speed.
 */
@BenchmarkMode(Mode.SingleShotTime)
@Warmup(iterations = 0)
@Measurement(iterations = 40)
public class RestoreBenchmark extends Workload {
    private static final int BEFORE = 400;

    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    private World world;
    private final Snapshot snapshot = new Snapshot();

    @Setup
    public void create() {
        world = Army.of(units).world(Integrator.EULER);
        world.save(snapshot);
        for (int i = 0; i < BEFORE; i++) {
            world.step(DT);
            world.restore(snapshot);
        }
        collect();
    }

    @Setup(Level.Iteration)
    public void move() {
        world.step(DT);
    }

    @Benchmark
    public void after400() {
        world.restore(snapshot);
    }
}
