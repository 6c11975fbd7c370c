package yarts.physics.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import yarts.physics.Integrator;
import yarts.physics.World;

/**
 * The same steps in a JVM that vectorises loops and in one that is told not to. The library's hot loops are written so
 * that HotSpot vectorises them; if a change stops that, the scores of the two no longer differ.
 */
public class VectorisedBenchmark extends Workload {
    /** Within the caches: memory does not hide the difference. */
    @Param("10000")
    public int units;

    @Param({"EULER", "MIDPOINT", "EXACT"})
    public Integrator integrator;

    @Param({"false", "true"})
    public boolean changingDt;

    private Army army;
    private World world;
    private int tick;

    @Setup
    public void create() {
        army = Army.of(units);
        world = army.world(integrator);
        collect();
    }

    @Benchmark
    public void vectorised() {
        step();
    }

    @Benchmark
    @Fork(value = 3, jvmArgsAppend = "-XX:-UseSuperWord")
    public void scalar() {
        step();
    }

    private void step() {
        army.keepMoving(world);
        if (changingDt) tick = (tick + 1) % 1000;
        world.step(DT + tick * 1e-6);
    }
}
