package yarts.physics.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.infra.Blackhole;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Unit;
import yarts.physics.World;

/** Other work of a game in a frame, by EULER: time, drawing, adding and removing units, snapshots. */
public class GameBenchmark extends Workload {
    /** At 144 frames and 60 steps per second, 12 frames take 5 steps. */
    static final int FRAMES = 12, STEPS = 5;

    private static final double FRAME = 1 / 144.0; // s

    /** The number of steps that a rollback repeats. */
    private static final int ROLLED_BACK = 8;

    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    private Army army;
    private World world;
    private Unit[] shuffled;
    private int[] victims;
    private int next;
    private float[] xy;
    private double[] inFull, forces;
    private long id;
    private final Snapshot snapshot = new Snapshot();

    @Setup
    public void create() {
        army = Army.of(units);
        world = army.world(Integrator.EULER);
        world.advance(1.5 * DT); // something to interpolate
        shuffled = Army.shuffled(units).stream().map(world::get).toArray(Unit[]::new);
        victims = Army.shuffled(units).stream().mapToInt(i -> i).toArray();
        xy = new float[2 * units];
        inFull = new double[2 * units];
        forces = forces(units + ROLLED_BACK);
        id = world.get(units / 2).getId();
        world.save(snapshot);
        collect();
    }

    /** A force on every unit in every frame; it is distributed over the steps of this frame and of later ones. */
    @Benchmark
    public void advance() {
        for (int i = 0; i < FRAMES; i++) {
            push(world);
            world.advance(FRAME);
        }
    }

    /** The same at 60 frames per second: a step in every frame, and half of the impulse waits for the next frame. */
    @Benchmark
    public void advanceAt60() {
        push(world);
        world.advance(DT);
    }

    /** The same number of forces and steps as in advance. */
    @Benchmark
    public void steps() {
        for (int i = 0; i < FRAMES; i++) {
            push(world);
            if (endsStep(i)) world.step(DT);
        }
    }

    /** As advance, but with a force on only one unit, to exclude the cost of applying forces. */
    @Benchmark
    public void advanceAlone() {
        for (int i = 0; i < FRAMES; i++) {
            world.get(0).applyForce(FX, FY);
            world.advance(FRAME);
        }
    }

    /** The same number of forces and steps as in advanceAlone. */
    @Benchmark
    public void stepsAlone() {
        for (int i = 0; i < FRAMES; i++) {
            world.get(0).applyForce(FX, FY);
            if (endsStep(i)) world.step(DT);
        }
    }

    private static boolean endsStep(int frame) {
        return frame * STEPS / FRAMES != (frame + 1) * STEPS / FRAMES;
    }

    /** A step; before it, one unit in a hundred is removed and another is created and added. */
    @Benchmark
    public void churn() {
        for (int i = 0; i < units / 100; i++) {
            next = (next + 1) % units;
            world.remove(world.get(victims[next]));
            world.add(army.unit(next));
        }
        world.step(DT);
    }

    /** Removes all units in random order, then adds them again, with a fixed heap size that the warm-up has used. */
    @Benchmark
    @Fork(
            value = 3,
            jvmArgsAppend = {"-Xms3g", "-Xmx3g"})
    public void removeAndAdd() {
        for (Unit unit : shuffled) world.remove(unit);
        for (Unit unit : shuffled) world.add(unit);
    }

    /** Creates units outside a world, one after another. */
    @Benchmark
    public void create(Blackhole blackhole) {
        for (int i = 0; i < units; i++) blackhole.consume(new Unit(army.mass[i]));
    }

    /** Removes all units in random order, and adds a new one after each removal. */
    @Benchmark
    public void replace() {
        for (int i = 0; i < units; i++) {
            world.remove(world.get(victims[i]));
            world.add(new Unit(army.mass[i]));
        }
    }

    /** Saves the whole world into a snapshot. */
    @Benchmark
    public void save() {
        world.save(snapshot);
    }

    /** Restores the whole world from a snapshot. */
    @Benchmark
    public void restore() {
        world.restore(snapshot);
    }

    /** A frame of a game with rollback: save, 8 steps with forces on all units, restore, find. */
    @Benchmark
    public Unit rollback() {
        world.save(snapshot);
        for (int i = 0; i < ROLLED_BACK; i++) {
            world.applyForces(forces, 0);
            world.step(DT);
        }
        world.restore(snapshot);
        return world.find(id);
    }

    /** The same, and a unit is added after each step; the restore removes these units. */
    @Benchmark
    public Unit rollbackWithSpawns() {
        world.save(snapshot);
        for (int i = 0; i < ROLLED_BACK; i++) {
            world.applyForces(forces, 0);
            world.step(DT);
            world.add(new Unit(1));
        }
        world.restore(snapshot);
        return world.find(id);
    }

    /** A hash of the whole world. */
    @Benchmark
    public long stateHash() {
        return world.stateHash();
    }

    /** Copies the interpolated positions to the buffer of a renderer, unit by unit. */
    @Benchmark
    public float[] getters() {
        int i = 0;
        for (Unit unit : world) {
            xy[i++] = (float) unit.getInterpolatedX();
            xy[i++] = (float) unit.getInterpolatedY();
        }
        return xy;
    }

    /** The same in one call. */
    @Benchmark
    public float[] copyPositions() {
        world.copyPositions(xy, 0);
        return xy;
    }

    /** The same in full precision. */
    @Benchmark
    public double[] copyPositionsInFull() {
        world.copyPositions(inFull, 0, 0.5);
        return inFull;
    }

    /** Copies all velocities in one call. */
    @Benchmark
    public double[] copyVelocities() {
        world.copyVelocities(inFull, 0);
        return inFull;
    }
}
