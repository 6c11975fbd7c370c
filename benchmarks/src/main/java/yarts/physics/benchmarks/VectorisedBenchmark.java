package yarts.physics.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import yarts.physics.Integrator;
import yarts.physics.World;

/**
 * The same steps in a JVM with vectorisation and in one without. The hot loops of the library have a form that HotSpot
 * vectorises; if a change prevents this, the two scores no longer differ.
 */
public class VectorisedBenchmark extends Workload {
    /** Small enough for the caches, so that memory does not hide the difference. */
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
