package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import yarts.physics.Snapshot;
import yarts.physics.Unit;
import yarts.physics.World;

/** The recipes of docs/cookbook.md for freezing, spawning and removing units, with other numbers. */
class ComingAndGoingTest {
    private static void release(World world, Unit transport, List<Long> aboard) {
        for (int i = 0; i < aboard.size(); i++) {
            Unit unit = world.find(aboard.get(i));
            if (unit == null) continue;
            double angle = 2 * Math.PI * i / aboard.size();
            unit.setPosition(
                    transport.getX() + 5 * StrictMath.cos(angle), transport.getY() + 5 * StrictMath.sin(angle));
            unit.setFrozen(false).setVelocity(transport.getVx(), transport.getVy());
        }
        aboard.clear();
    }

    /** All combinations of four passengers, after a restore from bytes, which replaces all objects. */
    @Test
    void passengersThatAreStillInTheWorldAreReleasedBesideTheTransport() {
        for (int gone = 0; gone < 16; gone++) {
            World world = new World();
            Unit transport = world.add(new Unit(20_000).setVelocity(10, 5));
            List<Long> aboard = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                aboard.add(world.add(new Unit(100).setVelocity(i, -i))
                        .setFrozen(true)
                        .getId());
            }
            for (int i = 0; i < 4; i++) if ((gone >> i & 1) == 1) world.remove(world.find(aboard.get(i)));
            for (int tick = 0; tick < 60; tick++) world.step();
            Snapshot snapshot = world.save();
            world.clear();
            world.restore(Snapshot.fromBytes(snapshot.toBytes()));
            Unit restored = world.find(transport.getId());
            release(world, restored, aboard);
            assertEquals(5 - Integer.bitCount(gone), world.size());
            assertTrue(aboard.isEmpty());
            for (int tick = 0; tick < 60; tick++) world.step();
            for (Unit unit : world) {
                assertFalse(unit.isFrozen());
                double distance = Math.hypot(unit.getX() - restored.getX(), unit.getY() - restored.getY());
                assertEquals(unit == restored ? 0 : 5, distance, 1e-9, "it moves with the transport");
            }
        }
    }

    private static final class Shell extends Unit {
        final long lastTick;

        Shell(Unit gun, long lastTick) {
            super(10);
            this.lastTick = lastTick;
            setPosition(gun.getX(), gun.getY()).setVelocity(gun.getVx() + 200, gun.getVy());
        }
    }

    /** At the origin and far from it, also for a shell that stops. No gun is removed. */
    @Test
    void eachShellIsRemovedAfterItsTimeAtEveryPositionOfTheGuns() {
        for (double x : new double[] {0, -1e6, 1e6}) {
            World world = new World();
            for (int i = 0; i < 3; i++)
                world.add(new Unit(40_000).setPosition(x, 10 * i).setMaxSpeed(0));
            world.addBeforeStep((w, dt) -> {
                if (w.getTick() % 60 != 0) return;
                for (Unit unit : List.copyOf(w.units())) {
                    if (!(unit instanceof Shell)) w.add(new Shell(unit, w.getTick() + 270));
                }
            });
            world.addAfterStep(
                    (w, dt) -> w.removeIf(unit -> unit instanceof Shell shell && w.getTick() >= shell.lastTick));
            for (int tick = 1; tick <= 600; tick++) {
                world.step();
                if (tick == 30) world.get(3).setVelocity(0, 0);
                int fly = 0;
                for (int spawn = 0; spawn < tick; spawn += 60) if (tick < spawn + 270) fly++;
                assertEquals(3 + 3 * fly, world.size(), "after step " + tick);
            }
            for (int i = 0; i < 3; i++) assertEquals(i + 1, world.get(i).getId());
        }
    }
}
