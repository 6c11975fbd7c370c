package yarts.physics.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * As {@link StepBenchmark#both}, by EULER, in a JVM that has stepped only three units for an hour of a game, as in a
 * menu. HotSpot optimises by past runs; it must not assume that all worlds are small.
 */
public class HistoryBenchmark extends Workload {
    private static final int HOUR = 60 * 60 * 60; // steps

    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    private World world;

    @Setup
    public void create() {
        World menu = Army.of(3).world(Integrator.EULER);
        Unit lone = Army.of(1).unit(0);
        for (int i = 0; i < HOUR; i++) {
            push(menu);
            if (i % 2 == 0) menu.step(DT);
            else menu.advance(1.5 * DT);
            lone.applyForce(FX, FY);
            lone.integrate(DT);
        }
        world = Army.of(units).world(Integrator.EULER);
        collect();
    }

    @Benchmark
    public void afterFew() {
        push(world);
        world.step(DT);
    }
}
