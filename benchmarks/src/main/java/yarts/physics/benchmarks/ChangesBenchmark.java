package yarts.physics.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * Ten changes and a step without forces, compared with a step alone. All units move; the changes are scattered over the
 * world. One unit in fifty has so much friction (f·dt/m = 1) that its coefficients require a full exponential.
 */
public class ChangesBenchmark extends Workload {
    static final int WORLD = 5_000; // units
    private static final int CHANGES = 10;

    /** The change that is made ten times before a step. */
    public enum Change {
        NONE("none"),
        SET_FRICTION("`setFriction`"),
        ADD("`add`"),
        REMOVE("`remove`");

        final String label;

        Change(String label) {
            this.label = label;
        }
    }

    @Param("" + WORLD)
    public int units;

    @Param("EXACT")
    public Integrator integrator;

    @Param
    public Change change;

    private final Unit[] outside = new Unit[CHANGES];
    private Army army;
    private World world;
    private int tick;
    private boolean stepped = true;

    @Setup
    public void create() {
        army = Army.of(units);
        world = army.world(integrator);
        for (int i = 0; i < units; i += 50) world.get(i).setFriction(army.mass[i] / DT);
        collect();
    }

    /** Removes the units that the next call adds, or adds those that the last call removed; not measured. */
    @Setup(Level.Invocation)
    public void prepare() {
        tick++;
        if (!stepped) world.step(DT);
        stepped = false;
        if (world.size() < units) for (Unit unit : outside) world.add(unit);
        army.keepMoving(world);
        if (change == Change.ADD) for (int k = 0; k < CHANGES; k++) remove(k, world.size() - 1);
    }

    /** The changes and a step. */
    @Benchmark
    public void tick() {
        change();
        world.step(DT);
        stepped = true;
    }

    /** The changes alone; the step is not measured. */
    @Benchmark
    public void change() {
        for (int k = 0; k < CHANGES; k++) {
            switch (change) {
                case NONE:
                    break;
                case SET_FRICTION:
                    Unit unit = world.get(scattered(k));
                    unit.setFriction(unit.getFriction() * (tick / tenth() % 2 == 0 ? 2 : 0.5));
                    break;
                case ADD:
                    world.add(outside[k]);
                    break;
                case REMOVE:
                    remove(k, scattered(k));
                    break;
            }
        }
    }

    private void remove(int k, int index) {
        outside[k] = world.get(index);
        world.remove(outside[k]);
    }

    /** An index in the k-th tenth of the world, which differs in each tick. */
    private int scattered(int k) {
        return k * tenth() + tick % tenth();
    }

    private int tenth() {
        return (units - CHANGES) / CHANGES;
    }
}
