package yarts.physics.benchmarks;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** Units that could be slow to step: at rest, some at their top speed, scattered over the heap. */
public class UnitsBenchmark extends Workload {
    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    private final World resting = world(), halfCapped = world(), uncapped = world(), scattered = world();
    private List<Unit> inOrder, shuffled;

    private static World world() {
        return new World(Integrator.EULER, Timestep.fixed(60));
    }

    @Setup
    public void create() {
        Random random = new Random(3);
        for (int i = 0; i < units; i++) {
            resting.add(new Unit(1).setFriction(1));
            uncapped.add(new Unit(1).setVelocity(2 * FX, 2 * FY));
            Unit perhaps = halfCapped.add(new Unit(1).setMaxSpeed(random.nextBoolean() ? 5 : Double.POSITIVE_INFINITY));
            perhaps.setVelocity(2 * FX, 2 * FY); // above 5 m/s: reduced to it; the force keeps it there
        }
        scatter();
    }

    /** Creates units in random order, among garbage: neighbours in the world are not neighbours on the heap. */
    private void scatter() {
        Army army = Army.of(units);
        Unit[] made = new Unit[units];
        for (int i : Army.shuffled(units)) made[i] = Garbage.among(() -> army.unit(i));
        for (Unit unit : made) scattered.add(unit);
        collect(); // before the list is shuffled: a copying collector would follow its order
        inOrder = new ArrayList<>(scattered.units());
        shuffled = new ArrayList<>(inOrder);
        Collections.shuffle(shuffled, new Random(4));
    }

    /** A step with all units at rest and no forces: all tiles are asleep. */
    @Benchmark
    public void atRest() {
        resting.step(DT);
    }

    /** A force on every unit and a step. Half of the units are at their top speed, in random order. */
    @Benchmark
    public void halfCapped() {
        both(halfCapped);
    }

    /** A force on every unit and a step. No unit has a top speed. */
    @Benchmark
    public void uncapped() {
        both(uncapped);
    }

    /** A force on every unit and a step, on a shuffled heap, with the forces in the order of the world. */
    @Benchmark
    public void scattered() {
        push(inOrder);
        scattered.step(DT);
    }

    /** A force on every unit and a step, on a shuffled heap, with the forces in the order of a shuffled list. */
    @Benchmark
    public void shuffled() {
        push(shuffled);
        scattered.step(DT);
    }

    private static void both(World world) {
        push(world);
        world.step(DT);
    }
}
