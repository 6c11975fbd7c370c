package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The hash includes everything on which the future of a world depends. Bits are changed at the offsets in the document.
 */
class StateHashTest {
    private static final int UNITS = 20;

    private final World world = world();
    private final long hash = world.stateHash();

    /** Interpolated units with waiting forces and pending impulses; in some units no value is 0. */
    private static World world() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 1; i <= UNITS; i++) {
            world.add(new Unit(i).setFriction(i).setMaxSpeed(i % 5 == 0 ? 1 : 1000))
                    .applyForce(i, -i);
        }
        world.advance(0.04);
        for (int i = 0; i < UNITS; i++) world.get(i).setMotor(i - 4.5, 7, 1 + i);
        for (int i = 0; i < UNITS; i += 4) world.get(i).setFrozen(true);
        for (Unit unit : world) unit.applyForce((double) unit.getId(), 2);
        return world;
    }

    /** A changed bit gives a new hash, or bytes that cause an exception. */
    @Test
    void everyBitChangesTheHash() {
        byte[] save = Saves.of(world);
        Saves.places(0).get("lastId").put(save, (1L << 61) - 1);
        World target = Saves.restored(Snapshot.fromBytes(Saves.repair(save)));
        Set<Long> hashes = new HashSet<>(Set.of(target.stateHash()));
        Map<String, Integer> shown = new HashMap<>();
        for (int i = 0; i < UNITS; i++) {
            for (Map.Entry<String, Saves.Place> entry : Saves.places(i).entrySet()) {
                Saves.Place place = entry.getValue();
                if (i > 0 && place.offset() < Saves.HEADER) continue;
                for (int bit = 8 * place.offset(); bit < 8 * (place.offset() + place.size()); bit++) {
                    save[bit / 8] ^= (byte) (1 << bit % 8);
                    if (isAccepted(target, Saves.repair(save))) {
                        shown.merge(entry.getKey(), 1, Integer::sum);
                        boolean zero = place.get(save).equals(-0.0);
                        assertEquals(!zero, hashes.add(target.stateHash()), entry.getKey() + " of " + i);
                    }
                    save[bit / 8] ^= (byte) (1 << bit % 8);
                }
            }
        }
        for (String name : Saves.STATE) {
            if (name.equals("frozen")) continue; // 0.0 and 1.0 differ in ten bits: see SnapshotFieldsTest
            int least = name.matches("mass|v[xy]|f[xy]|waiting.|pending.|motor.+") ? 54 : 60;
            assertTrue(shown.get(name) >= UNITS * least, name + ": " + shown);
        }
        assertEquals(UNITS * (61 - 5), shown.get("id"), 2.0 * UNITS, "ids up to 2^61 that no other unit has");
        for (String name : List.of("tick", "droppedTicks", "lastId")) assertTrue(shown.get(name) > 55, name + shown);
        for (String name : List.of("time", "timeError", "droppedTime", "droppedTimeError", "remainderError")) {
            assertTrue(shown.get(name) > 55, name + ": " + shown);
        }
        assertTrue(shown.get("remainder") > 25 && shown.get("regularTicks") >= 1, shown::toString);
        assertTrue(shown.get("integrator") > 0 && shown.get("interpolating") > 0, shown::toString);
        assertTrue(shown.get("maxSteps") > 20, shown::toString);
    }

    private static boolean isAccepted(World target, byte[] save) {
        try {
            target.restore(Snapshot.fromBytes(save));
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    /** Positions on a grid: numbers with few digits, as in games. */
    @Test
    void wholeNumbersChangeTheHash() {
        Map<Long, String> hashes = new HashMap<>();
        List<String> same = new ArrayList<>();
        Unit unit = new Unit(1);
        World grid = new World();
        grid.add(unit);
        for (int x = 0; x < 300; x++) {
            for (int y = 0; y < 300; y++) {
                unit.setPosition(x, y);
                String here = "(" + x + ", " + y + ")", other = hashes.put(grid.stateHash(), here);
                if (other != null) same.add(other + " and " + here);
            }
        }
        assertEquals(0, same.size(), () -> same.size() + " of 90,000, such as " + same.get(0));
    }

    @Test
    void integratorAndTimestepChangeTheHash() {
        Set<Long> hashes = new HashSet<>();
        for (Integrator integrator : Integrator.values()) {
            for (Timestep timestep : List.of(
                    Timestep.fixed(60),
                    Timestep.fixed(61),
                    Timestep.fixed(60).withMaxSteps(14),
                    Timestep.fixed(60).withMaxSteps(16),
                    Timestep.variable(1 / 60.0),
                    Timestep.variable(Math.nextUp(1 / 60.0)),
                    Timestep.variable(1 / 60.0).withMaxSteps(14))) {
                long made = new World(integrator, timestep).stateHash();
                assertTrue(hashes.add(made), integrator + " " + timestep);
                World set = new World();
                set.setIntegrator(integrator);
                set.setTimestep(timestep);
                assertEquals(made, set.stateHash());
            }
        }
    }

    @Test
    void orderTimeAndForcesChangeTheHash() {
        Set<Long> hashes = new HashSet<>(Set.of(hash));
        byte[] save = Saves.of(world), swapped = save.clone();
        int third = Saves.HEADER + 3 * Saves.RECORD, last = Saves.HEADER + (UNITS - 1) * Saves.RECORD;
        System.arraycopy(save, third, swapped, last, Saves.RECORD);
        System.arraycopy(save, last, swapped, third, Saves.RECORD);
        world.restore(Snapshot.fromBytes(Saves.repair(swapped)));
        assertTrue(hashes.add(world.stateHash()), "order");
        world.restore(Snapshot.fromBytes(save));
        assertEquals(hash, world.stateHash());
        Unit unit = world.get(5);
        unit.applyForce(1e-9, 0);
        assertTrue(hashes.add(world.stateHash()), "a force");
        world.remove(world.add(new Unit(1)));
        assertTrue(hashes.add(world.stateHash()), "a used id");
        world.step(0);
        assertTrue(hashes.add(world.stateHash()), "a step of 0 s");
        world.advance(1e-9);
        assertTrue(hashes.add(world.stateHash()), "a nanosecond");
        world.advance(0x1p-60);
        assertTrue(hashes.add(world.stateHash()), "its rounding error");
        world.clear();
        assertTrue(hashes.add(world.stateHash()), "no units");
    }

    /** Neither discarded forces, though flags of the table stay set, nor a freeze and a release change the hash. */
    @Test
    void discardedForcesDoNotChangeTheHash() {
        World other = world();
        for (World each : List.of(world, other)) {
            for (Unit unit : each) unit.clearForces();
            for (Unit unit : each) unit.setFrozen(false);
            each.step();
        }
        for (Unit unit : world) unit.applyForce(3, 4);
        for (World each : List.of(world, other)) assertEquals(0, each.advance(1e-6)); // pending
        assertNotEquals(world.stateHash(), other.stateHash());
        for (Unit unit : world) unit.clearForces();
        world.get(7).applyForce(1, 1);
        world.get(7).clearForces();
        world.get(9).setFrozen(true);
        assertNotEquals(world.stateHash(), other.stateHash());
        world.get(9).applyForce(1, 1);
        world.get(9).setFrozen(false);
        for (int i = 0; i < 3; i++) {
            assertEquals(world.stateHash(), other.stateHash());
            for (World each : List.of(world, other)) each.advance(0.02);
        }
    }
}
