package yarts.physics.faults;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Iterator;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.StepListener;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * After any fault of a listener, before or after any step of a frame, the state of the world is valid and complete: the
 * world continues as another one that was restored from its snapshot.
 */
class FaultsPropertyTest {
    /** Faults of a listener, and valid calls at an unusual moment. */
    enum Fault {
        THROWS_AN_EXCEPTION,
        THROWS_AN_ERROR,
        THROWS_WHAT_IT_DOES_NOT_DECLARE,
        ADDS,
        REMOVES_THE_FIRST,
        REMOVES_THE_LAST,
        REMOVES_ALL_WHILE_IT_LOOKS_AT_THEM,
        REMOVES_IF,
        CLEARS,
        CHANGES_WHAT_IT_LOOKS_AT,
        STEPS,
        ADVANCES,
        SAVES,
        RESTORES,
        SETS_THE_INTEGRATOR,
        SETS_THE_TIMESTEP,
        GOES;

        boolean stops() {
            return !name().matches("ADDS|REMOVES.*|CLEARS|GOES");
        }

        void happen(World world, Snapshot snapshot, StepListener listener) {
            if (world.size() > 0) world.get(world.size() / 2).applyForce(3, 4);
            switch (this) {
                case THROWS_AN_EXCEPTION -> throw new IllegalStateException("an exception of a listener");
                case THROWS_AN_ERROR -> throw new AssertionError("an error of a listener");
                case THROWS_WHAT_IT_DOES_NOT_DECLARE ->
                    FaultsPropertyTest.<RuntimeException>throwUnchecked(new Exception("sneaked"));
                case ADDS -> {
                    for (int i = 0; i < 600; i++)
                        world.add(new Unit(2)).setVelocity(i, 1).applyForce(i, 2);
                }
                case REMOVES_THE_FIRST -> world.remove(world.size() > 0 ? world.get(0) : null);
                case REMOVES_THE_LAST -> world.remove(world.size() > 0 ? world.get(world.size() - 1) : null);
                case REMOVES_ALL_WHILE_IT_LOOKS_AT_THEM -> {
                    for (Iterator<Unit> i = world.iterator(); i.hasNext(); i.remove()) i.next();
                }
                case REMOVES_IF -> world.removeIf(unit -> unit.getId() % 3 == 1);
                case CLEARS -> world.clear();
                case CHANGES_WHAT_IT_LOOKS_AT -> {
                    world.add(new Unit(1));
                    for (Unit unit : world) world.add(new Unit(unit.getMass()));
                }
                case STEPS -> world.step(1);
                case ADVANCES -> world.advance(1);
                case SAVES -> world.save(snapshot);
                case RESTORES -> world.restore(snapshot);
                case SETS_THE_INTEGRATOR -> world.setIntegrator(Integrator.MIDPOINT);
                case SETS_THE_TIMESTEP -> world.setTimestep(Timestep.fixed(30));
                case GOES -> world.removeStepListener(listener);
            }
        }
    }

    @SuppressWarnings("unchecked")
    private static <T extends Throwable> void throwUnchecked(Throwable e) throws T {
        throw (T) e;
    }

    @Property(tries = 1500)
    void theWorldContinuesAsOneRestoredFromItsSnapshot(
            @ForAll long seed,
            @ForAll Fault fault,
            @ForAll Integrator integrator,
            @ForAll boolean fixed,
            @ForAll boolean after,
            @ForAll @IntRange(min = 0, max = 3) int when) {
        Timestep timestep = (fixed ? Timestep.fixed(50) : Timestep.variable(0.02)).withMaxSteps(4);
        World world = new World(integrator, timestep);
        SplittableRandom random = new SplittableRandom(seed);
        int units = random.nextInt(3) == 0 ? Tiles.TILE + 3 : random.nextInt(1, 20);
        for (int i = 0; i < units; i++) {
            world.add(new Unit(1 + i)).setFriction(random.nextInt(5)).setVelocity(i, -i);
            if (random.nextInt(8) == 0) world.get(i).setMotor(random.nextInt(3), i, 1 + i);
        }
        push(world, random);
        world.advance(0.03);
        push(world, random);
        Snapshot snapshot = world.save();
        long tick = world.getTick();
        double time = world.getTime(), dropped = world.getDroppedTime(), waits = fixed ? world.getAlpha() * 0.02 : 0;

        int[] calls = {0};
        StepListener listener = new StepListener() {
            @Override
            public void onStep(World w, double dt) {
                if (calls[0]++ == when) fault.happen(w, snapshot, this);
            }
        };
        if (after) world.addAfterStep(listener);
        else world.addBeforeStep(listener);
        boolean frame = when > 0 || random.nextBoolean();
        if (fault.stops()) assertThrows(Throwable.class, () -> pass(world, frame));
        else pass(world, frame);
        world.removeStepListener(listener);

        int ran = fault.stops() ? when + (after ? 1 : 0) : frame ? 4 : 1;
        assertEquals(tick + ran, world.getTick());
        if (fault.stops() && !after) {
            for (Unit unit : world)
                assertEquals(0, Math.abs(unit.getFx()) + Math.abs(unit.getFy()), "forces of a step that did not run");
        }
        if (frame) {
            double waited = (fixed ? world.getAlpha() * 0.02 : 0) - waits;
            assertEquals(0.08, world.getTime() - time + world.getDroppedTime() - dropped + waited, 1e-12);
        }
        World other = new World();
        other.restore(Snapshot.fromBytes(world.save().toBytes()));
        assertEquals(Churn.bits(world), Churn.bits(other));
        for (int i = 0; i < 6; i++) {
            push(world, new SplittableRandom(seed + i));
            push(other, new SplittableRandom(seed + i));
            world.advance(0.013 * i);
            other.advance(0.013 * i);
            world.step(0.01);
            other.step(0.01);
            assertEquals(world.stateHash(), other.stateHash());
        }
        assertEquals(Churn.bits(world), Churn.bits(other));
    }

    private static void pass(World world, boolean frame) {
        if (frame) world.advance(0.08);
        else world.step(0.02);
    }

    private static void push(World world, SplittableRandom random) {
        for (int i = random.nextInt(3); i < world.size(); i += 3) world.get(i).applyForce(random.nextInt(-9, 9), i);
    }
}
