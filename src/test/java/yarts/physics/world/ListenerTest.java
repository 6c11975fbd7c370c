package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Listeners;

/** The calls of listeners before and after each step, and the effects of their exceptions. */
class ListenerTest {
    private static final class Stop extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    private static void stop() {
        throw new Stop();
    }

    private final World world = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(9));
    private final Listeners listeners = new Listeners(world);
    private final Unit unit = world.add(new Unit(1));

    @Test
    void bothListenersAreCalledForEveryStepWithItsLength() {
        List<String> calls = new ArrayList<>();
        world.addBeforeStep((w, dt) -> calls.add("before " + w.getTick() + " " + dt));
        world.addAfterStep((w, dt) -> calls.add("after " + w.getTick() + " " + dt));
        world.advance(0.2);
        world.step(0.5);
        world.step();
        assertEquals(
                List.of(
                        "before 0 0.1",
                        "after 1 0.1",
                        "before 1 0.1",
                        "after 2 0.1",
                        "before 2 0.5",
                        "after 3 0.5",
                        "before 3 0.1",
                        "after 4 0.1"),
                calls);
    }

    /** A unit is drawn at its position after the last completed step. */
    @Test
    void aCancelledStepDoesNotChangeTheDrawnPosition() {
        unit.setVelocity(10, 0);
        for (int i = 0; i < 100; i++) world.step(0.1);
        assertEquals(100, unit.getX(), 1e-12);
        listeners.setBefore((w, dt) -> stop());
        assertThrows(Stop.class, () -> world.advance(0.15));
        assertEquals(100, unit.getInterpolatedX(), 1e-12);
        assertEquals(unit.getX(), unit.getInterpolatedX());
        float[] xy = new float[2];
        world.copyPositions(xy, 0);
        assertEquals(100, xy[0]);
        assertEquals(100, world.getTick());
        assertEquals(0.1, world.getDroppedTime(), 1e-15);
        listeners.clear();
        world.advance(0.05);
        assertEquals(100, unit.getInterpolatedX(), 1e-12, "the next step begins here");
        world.advance(0.05);
        assertEquals(100.5, unit.getInterpolatedX(), 1e-12);
    }

    /** As after a frame without a step; in a later step of a frame, as if the frame had ended before. */
    @Test
    void aCancelledStepDoesNotChangeHashAndSnapshot() {
        for (int good = 0; good < 3; good++) {
            World stopped = new World(Integrator.EXACT, Timestep.fixed(10).withMaxSteps(9)),
                    quiet = new World(Integrator.EXACT, Timestep.fixed(10).withMaxSteps(9));
            for (World w : List.of(stopped, quiet)) {
                w.add(new Unit(1).setVelocity(10, 0).setFriction(1));
                w.add(new Unit(2));
                w.step(0.3);
            }
            int last = good;
            int[] calls = {0};
            stopped.get(0).applyForce(5, 6);
            stopped.addBeforeStep((w, dt) -> {
                w.get(1).applyForce(7, 8);
                if (calls[0]++ == last) stop();
            });
            assertThrows(Stop.class, () -> stopped.advance(0.05 + 0.1 * (last + 1)));
            for (int i = 0; i < good; i++) {
                // 5 N for 0.15 s or more: the impulse of the remainder is pending, the rest acts in the steps.
                double steps = good + 1, share = (0.05 + 0.1 * steps - 0.05) / (0.1 * steps);
                quiet.get(0).applyForce(5 * share, 6 * share);
                quiet.get(1).applyForce(7, 8);
                quiet.step(0.1);
            }
            assertEquals(quiet.get(0).getX(), stopped.get(0).getX(), 1e-13);
            assertEquals(quiet.get(1).getVx(), stopped.get(1).getVx(), 1e-13);
            for (Unit each : stopped) assertEquals(0, each.getFx());
            assertEquals(1 + good, stopped.getTick());
            assertEquals(5 * 0.05, stopped.get(0).getPendingImpulseX(), 1e-13, "the remainder still waits");
            assertEquals(0, stopped.get(1).getPendingImpulseX());
            Snapshot saved = stopped.save();
            World restored = new World();
            restored.restore(saved);
            assertEquals(stopped.stateHash(), restored.stateHash());
        }
    }

    @Test
    void stepAndAdvanceBothDiscardTheForcesOfACancelledStep() {
        for (boolean advance : new boolean[] {false, true}) {
            World w = new World(Integrator.EULER, Timestep.fixed(10).withMaxSteps(9));
            Unit pushed = w.add(new Unit(1)), other = w.add(new Unit(1));
            long before = w.stateHash();
            Listeners own = new Listeners(w);
            own.setBefore((x, dt) -> {
                other.applyForce(3, 3);
                stop();
            });
            pushed.applyForce(1, 2);
            assertThrows(Stop.class, () -> {
                if (advance) w.advance(0.1);
                else w.step(0.1);
            });
            assertEquals(0, pushed.getFx());
            assertEquals(0, other.getFy());
            own.clear();
            if (!advance) assertEquals(before, w.stateHash(), "as before the call");
            w.step(0.1);
            assertEquals(0, pushed.getVx());
            assertEquals(0, other.getVy());
        }
    }

    @Test
    void aStepIsCompleteEvenIfAListenerAfterItThrows() {
        unit.setVelocity(10, 0);
        listeners.setAfter((w, dt) -> stop());
        assertThrows(Stop.class, () -> world.advance(0.25));
        assertEquals(1, world.getTick());
        assertEquals(1, unit.getX());
        assertEquals(0.5, unit.getInterpolatedX(), 1e-15, "half of the next step waits");
        assertEquals(0.1, world.getDroppedTime(), 1e-15);
        listeners.clear();
        assertEquals(1, world.advance(0.05), "the world continues");
        assertThrows(Stop.class, () -> {
            listeners.setAfter((w, dt) -> stop());
            world.step(0.1);
        });
        assertEquals(3, world.getTick());
        unit.setPosition(50, 0);
        assertEquals(50, unit.getInterpolatedX(0), "a teleport, not a correction");
    }

    @Test
    void aForceAfterAStepActsForTheNextStep() {
        listeners.setAfter((w, dt) -> {
            if (world.getTick() == 1) unit.applyForce(10, 0);
        });
        unit.applyForce(0, 10);
        assertEquals(2, world.advance(0.2));
        assertEquals(1, unit.getVx(), 1e-15, "in the next step of the frame");
        assertEquals(2, unit.getVy(), 1e-15, "in addition to the force of the frame");
        assertEquals(0, unit.getFx());
        listeners.setAfter((w, dt) -> {
            if (world.getTick() == 3) unit.applyForce(10, 0);
        });
        world.advance(0.1);
        assertEquals(10, unit.getFx(), "it waits");
        assertEquals(0, world.advance(0.05));
        assertEquals(10, unit.getFx(), "it waits on in a frame without a step");
        assertEquals(0, unit.getPendingImpulseX());
        assertEquals(2, world.advance(0.15));
        assertEquals(2, unit.getVx(), 1e-15, "the first of the two steps");
    }

    @Test
    void aListenerAfterAStepMayAddAndRemoveUnits() {
        Unit second = world.add(new Unit(1).setVelocity(0, 10));
        Unit late = new Unit(1).setVelocity(5, 0);
        listeners.setAfter((w, dt) -> {
            if (world.getTick() != 1) return;
            world.remove(unit);
            world.add(late).setPosition(100, 200);
            assertEquals(100, late.getInterpolatedX(0), "it is drawn at its new position at once");
        });
        unit.applyForce(10, 0);
        second.applyForce(10, 0);
        assertEquals(3, world.advance(0.3));
        assertEquals(List.of(second, late), world.units());
        assertEquals(1, unit.getVx(), 1e-15);
        assertEquals(3, second.getVx(), 1e-15, "its forces moved with it to the first row");
        assertEquals(101, late.getX(), 1e-13);
        assertEquals(100.5, late.getInterpolatedX(0), 1e-13);
    }

    @Test
    void aListenerCannotStepSaveRestoreOrSetTheWorld() {
        Snapshot saved = world.save();
        int[] refused = {0};
        Runnable makeInvalidCalls = () -> {
            for (Runnable call : List.<Runnable>of(
                    () -> world.step(1),
                    world::step,
                    () -> world.advance(0),
                    world::save,
                    () -> world.save(saved),
                    () -> world.restore(saved),
                    () -> world.setIntegrator(Integrator.EXACT),
                    () -> world.setTimestep(Timestep.fixed(1)))) {
                String message =
                        assertThrows(IllegalStateException.class, call::run).getMessage();
                assertEquals(
                        "a step of this world is running: until it ends, no listener, factory or other thread"
                                + " may step, save or restore the world, or set its integrator or timestep",
                        message);
                refused[0]++;
            }
        };
        listeners.set((w, dt) -> makeInvalidCalls.run(), (w, dt) -> makeInvalidCalls.run());
        world.step(1);
        assertEquals(16, refused[0]);
        assertEquals(1, world.getTick());
        assertEquals(Integrator.EULER, world.getIntegrator());
        assertNotEquals(0, world.stateHash());
    }
}
