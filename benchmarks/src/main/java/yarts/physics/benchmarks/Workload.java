package yarts.physics.benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import yarts.physics.Unit;

/**
 * The settings of every benchmark. A score is the time of one call for all units, in ns; {@link Results} divides it by
 * the number of units, and by the number of steps if a call runs several.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 5, time = 400, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 5, time = 400, timeUnit = TimeUnit.MILLISECONDS)
public abstract class Workload {
    static final double DT = 1 / 60.0; // s

    /** The force on every unit; in N. */
    static final double FX = 3, FY = -2;

    /**
     * Runs the garbage collector, which moves live objects together, as the first collections of a game do. New units
     * are farther apart in memory.
     */
    static void collect() {
        System.gc();
    }

    /** The forces on n units, for {@code World.applyForces}. */
    static double[] forces(int n) {
        double[] xy = new double[2 * n];
        for (int i = 0; i < n; i++) {
            xy[2 * i] = FX;
            xy[2 * i + 1] = FY;
        }
        return xy;
    }

    static void push(Iterable<Unit> units) {
        for (Unit unit : units) unit.applyForce(FX, FY);
    }
}
