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

/** What else a game does in a frame, by EULER: time, drawing, and the coming and going of units. */
public class GameBenchmark extends Workload {
    /** At 144 frames and 60 steps a second, this many frames are that many steps. */
    static final int FRAMES = 12, STEPS = 5;

    private static final double FRAME = 1 / 144.0; // s

    /** The steps that are repeated by a rollback. */
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

    /** A force on every unit in every frame, held over its steps and in part carried to later ones. */
    @Benchmark
    public void advance() {
        for (int i = 0; i < FRAMES; i++) {
            push(world);
            world.advance(FRAME);
        }
    }

    /** The same at 60 frames a second: a step in every frame, and half of the frame's forces wait for the next. */
    @Benchmark
    public void advanceAt60() {
        push(world);
        world.advance(DT);
    }

    /** As many forces and steps as in advance. */
    @Benchmark
    public void steps() {
        for (int i = 0; i < FRAMES; i++) {
            push(world);
            if (endsStep(i)) world.step(DT);
        }
    }

    /** As advance, but with a force on one unit, not to measure the applying of forces. */
    @Benchmark
    public void advanceAlone() {
        for (int i = 0; i < FRAMES; i++) {
            world.get(0).applyForce(FX, FY);
            world.advance(FRAME);
        }
    }

    /** As many forces and steps as in advanceAlone. */
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

    /** A step, and before it one in a hundred units dies and another one is born. */
    @Benchmark
    public void churn() {
        for (int i = 0; i < units / 100; i++) {
            next = (next + 1) % units;
            world.remove(world.get(victims[next]));
            world.add(army.unit(next));
        }
        world.step(DT);
    }

    /** All units leave the world, in random order, and come back; on a heap that the warm-up has been through. */
    @Benchmark
    @Fork(
            value = 3,
            jvmArgsAppend = {"-Xms1g", "-Xmx1g"})
    public void removeAndAdd() {
        for (Unit unit : shuffled) world.remove(unit);
        for (Unit unit : shuffled) world.add(unit);
    }

    /** Units that are in no world, one after another. */
    @Benchmark
    public void create(Blackhole sink) {
        for (int i = 0; i < units; i++) sink.consume(new Unit(army.mass[i]));
    }

    /** Removes as many units as there are, in random order, and adds a new one after each. */
    @Benchmark
    public void replace() {
        for (int i = 0; i < units; i++) {
            world.remove(world.get(victims[i]));
            world.add(new Unit(army.mass[i]));
        }
    }

    /** The whole world into a snapshot. */
    @Benchmark
    public void save() {
        world.save(snapshot);
    }

    /** And back. */
    @Benchmark
    public void restore() {
        world.restore(snapshot);
    }

    /** What a lockstep game with rollback does in a frame: save, 8 steps with forces on all units, restore, find. */
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

    /** A hash of all of the world. */
    @Benchmark
    public long stateHash() {
        return world.stateHash();
    }

    /** Every unit's interpolated position into a renderer's buffer, unit by unit. */
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

    /** Every unit's velocity, in one call. */
    @Benchmark
    public double[] copyVelocities() {
        world.copyVelocities(inFull, 0);
        return inFull;
    }
}
