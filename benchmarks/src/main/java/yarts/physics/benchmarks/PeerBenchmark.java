package yarts.physics.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** The work of {@link StepBenchmark#both} in other libraries: a force on every unit, and a step. */
public class PeerBenchmark extends Workload {
    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    @Param
    public Peers peer;

    private Peer army;

    @Setup
    public void create() {
        peer.check();
        army = peer.of(Army.of(units));
        collect();
    }

    @Benchmark
    public void both() {
        army.step();
    }
}
