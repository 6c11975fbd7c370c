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
 * How every benchmark is measured. A score is the nanoseconds of one call, for all units; {@link Results} divides it by
 * the number of units, and of steps if a call runs more than one.
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
     * Moves what lives together, in the order in which it lies, as a game's first collections do. Units fresh from their
     * constructors lie farther apart.
     */
    static void collect() {
        System.gc();
    }

    /** The forces on n units, as a world takes them in one call. */
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
