package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.LongFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import yarts.physics.Snapshot;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/** What save, restore and the rest refuse, whereupon nothing is changed. */
class SnapshotRefusalTest {
    private final World world = new World();
    private final Unit a = world.add(new Unit(1)), b = world.add(new Unit(2)), c = world.add(new Unit(3));
    private final Snapshot saved = Saves.snapshot(world);

    @Test
    void anEmptySnapshotIsRefused() {
        Snapshot empty = new Snapshot();
        assertEquals(0, empty.size());
        assertEquals(0, empty.getTick());
        for (Executable use : List.<Executable>of(
                () -> world.restore(empty),
                empty::toBytes,
                () -> empty.difference(saved),
                () -> saved.difference(empty))) {
            refused(IllegalArgumentException.class, "the snapshot is empty: nothing was saved into it", use);
        }
    }

    @Test
    void nullIsRefusedByName() {
        refused(NullPointerException.class, "into must not be null", () -> world.save(null));
        refused(NullPointerException.class, "from must not be null", () -> world.restore(null));
        refused(NullPointerException.class, "factory must not be null", () -> world.restore(saved, null));
        refused(NullPointerException.class, "bytes must not be null", () -> Snapshot.fromBytes(null));
        refused(NullPointerException.class, "other must not be null", () -> saved.difference(null));
    }

    @Test
    void aListenerCannotSaveOrRestore() {
        String message = "a step of this world is running: until it ends, no listener, factory or other thread"
                + " may step, save or restore the world, or set its integrator or timestep";
        byte[] before = saved.toBytes();
        world.addBeforeStep((w, dt) -> {
            refused(IllegalStateException.class, message, () -> w.save(saved));
            refused(IllegalStateException.class, message, w::save);
            refused(IllegalStateException.class, message, () -> w.restore(saved));
            refused(IllegalStateException.class, message, () -> w.restore(saved, id -> new Unit(1)));
        });
        world.step(1);
        assertEquals(2, world.advance(0.04));
        assertEquals(3, world.getTick());
        assertArrayEquals(before, saved.toBytes());
    }

    @Test
    void unitsThatAreInAnotherWorldByNowAreNotTakenBack() {
        World other = new World();
        world.remove(b);
        other.add(b);
        world.remove(a);
        world.add(new Unit(4));
        long hash = other.stateHash();
        refused(
                IllegalStateException.class,
                "unit 2 of the snapshot is now in another world: " + b,
                () -> world.restore(saved));
        assertEquals(1, b.getId());
        assertSame(other, b.getWorld());
        assertEquals(hash, other.stateHash());
        other.remove(b);
        world.restore(saved);
        assertEquals(List.of(a, b, c), world.units());
    }

    @Test
    void whatAFactoryMustNotReturnIsRefused() {
        Snapshot bytes = Snapshot.fromBytes(saved.toBytes());
        world.remove(a);
        world.remove(b);
        world.step(1);
        Unit outside = new Unit(1), elsewhere = new World().add(new Unit(1));
        refusedFactory(NullPointerException.class, "the factory's unit must not be null", bytes, id -> null);
        String must = "the factory must return a new unit for id ";
        refusedFactory(IllegalStateException.class, must + "1, was " + elsewhere, bytes, id -> elsewhere);
        refusedFactory(IllegalStateException.class, must + "1, was " + c, bytes, id -> c);
        refusedFactory(IllegalStateException.class, must + "2, was " + outside, bytes, id -> outside);
        refusedFactory(IllegalStateException.class, "of the game", bytes, id -> {
            if (id == 1) return outside;
            throw new IllegalStateException("of the game");
        });
        assertNull(outside.getWorld());
        assertEquals(1, outside.getMass());
    }

    @Test
    void aFactoryThatChangesTheWorldIsRefused() {
        Snapshot bytes = Snapshot.fromBytes(saved.toBytes());
        for (Runnable change : List.<Runnable>of(
                () -> world.remove(c), () -> world.add(new Unit(5)), world::clear, () -> world.removeIf(u -> true))) {
            world.restore(saved);
            world.remove(a);
            Exception e = assertThrows(
                    IllegalStateException.class,
                    () -> world.restore(bytes, id -> {
                        change.run();
                        return new Unit(1);
                    }));
            assertEquals("the factory must not change the world", e.getMessage());
        }
        world.restore(saved);
        world.remove(a);
        String message = "a restore of this world is running: until it ends, no listener, factory or other thread"
                + " may step, save or restore the world, or set its integrator or timestep";
        for (Runnable change : List.<Runnable>of(world::step, world::save, () -> world.restore(saved))) {
            refusedFactory(IllegalStateException.class, message, bytes, id -> {
                change.run();
                return new Unit(1);
            });
        }
    }

    @Test
    void aFactoryCannotSaveIntoTheSnapshotThatIsRestored() {
        World empty = new World(), larger = new World();
        for (int i = 0; i < 600; i++) larger.add(new Unit(1));
        for (World other : List.of(empty, larger)) {
            Snapshot bytes = Snapshot.fromBytes(saved.toBytes());
            world.restore(saved);
            world.remove(a);
            refusedFactory(
                    IllegalStateException.class,
                    "a restore from this snapshot is running: until it ends, the factory must not save into it",
                    bytes,
                    id -> {
                        other.save(bytes);
                        return new Unit(1);
                    });
            assertArrayEquals(saved.toBytes(), bytes.toBytes());
            world.restore(bytes);
            other.save(bytes);
            assertEquals(other.size(), bytes.size());
        }
    }

    /** Each restore creates its own units. */
    @Test
    void aFactoryMayRestoreAnotherWorldFromTheSameSnapshot() {
        Snapshot bytes = Snapshot.fromBytes(saved.toBytes());
        World outer = new World(), inner = new World();
        outer.restore(bytes, id -> {
            inner.restore(bytes);
            assertThrows(IllegalStateException.class, () -> inner.save(bytes));
            return new Unit(1);
        });
        assertEquals(world.stateHash(), outer.stateHash());
        assertEquals(world.stateHash(), inner.stateHash());
        inner.save(bytes);
    }

    private void refusedFactory(
            Class<? extends Exception> type, String message, Snapshot from, LongFunction<Unit> factory) {
        refused(type, message, () -> world.restore(from, factory));
    }

    /** Refused, and neither the world nor who is in it has changed. */
    private void refused(Class<? extends Exception> type, String message, Executable use) {
        List<Unit> units = List.copyOf(world.units());
        long hash = world.stateHash();
        List<Long> bits = Churn.bits(world);
        assertEquals(message, assertThrows(type, use).getMessage());
        assertEquals(units, world.units());
        assertEquals(hash, world.stateHash());
        assertEquals(bits, Churn.bits(world));
        for (Unit unit : units) assertSame(world, unit.getWorld());
        assertTrue(units.stream().allMatch(unit -> world.find(unit.getId()) == unit));
    }
}
