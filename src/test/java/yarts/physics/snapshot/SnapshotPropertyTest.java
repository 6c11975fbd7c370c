package yarts.physics.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/** After any history, a restored world has the saved state, and continues as the saved world did. */
class SnapshotPropertyTest {
    /** One snapshot for worlds of all sizes. */
    private static final Snapshot SAVED = new Snapshot();

    private record Kind(Integrator integrator, Timestep timestep) {}

    private static final class Tank extends Unit {
        final long made;

        Tank(long id) {
            super(7);
            made = id;
        }
    }

    @Property(tries = 1000)
    void aRestoredWorldContinuesAsTheSavedOne(
            @ForAll long seed,
            @ForAll("kinds") Kind kind,
            @ForAll("kinds") Kind otherKind,
            @ForAll @IntRange(max = 40) int before,
            @ForAll @IntRange(max = 20) int between,
            @ForAll @IntRange(max = 20) int after) {
        World world = Churn.world(seed, kind.integrator, kind.timestep, before);
        World undisturbed = Churn.world(seed, kind.integrator, kind.timestep, before);
        if (seed % 2 == 0) world.find(1); // from here on it has an index of ids
        List<Unit> units = List.copyOf(world.units());
        List<Long> bits = Churn.bits(world);
        long hash = world.stateHash();
        world.save(SAVED);
        assertEquals(bits, Churn.bits(world), "save changed the world");

        List<Long> future = new Churn(seed + 2).play(undisturbed, after);
        for (int again = 0; again < 2; again++) {
            new Churn(seed + 1).play(world, between);
            if (seed % 3 == 0)
                world.restore(Saves.snapshot(Churn.world(seed + 3, otherKind.integrator, otherKind.timestep, 5)));
            Map<Unit, List<Long>> added = kept(world);
            units.forEach(added::remove);

            world.restore(SAVED);
            assertEquals(units, world.units());
            assertEquals(bits, Churn.bits(world));
            assertEquals(hash, world.stateHash());
            for (Unit unit : units) assertSame(world, unit.getWorld());
            assertOutside(added);
            assertFound(world);
            assertEquals(future, new Churn(seed + 2).play(world, after));
            assertEquals(Churn.bits(undisturbed), Churn.bits(world));
            assertFound(world);
        }
    }

    @Property(tries = 1000)
    void anotherWorldContinuesAsTheSavedOneAfterARestore(
            @ForAll long seed,
            @ForAll("kinds") Kind kind,
            @ForAll("kinds") Kind otherKind,
            @ForAll @IntRange(max = 40) int before,
            @ForAll @IntRange(max = 20) int otherBefore,
            @ForAll @IntRange(max = 20) int after,
            @ForAll boolean asBytes) {
        World world = Churn.world(seed, kind.integrator, kind.timestep, before);
        List<Long> bits = Churn.bits(world);
        world.save(SAVED);
        byte[] bytes = SAVED.toBytes();

        World other = Churn.world(seed + 1, otherKind.integrator, otherKind.timestep, otherBefore);
        Map<Unit, List<Long>> gone = kept(other);
        Map<Long, Unit> known = new LinkedHashMap<>();
        for (Unit unit : other) known.put(unit.getId(), unit);

        other.restore(asBytes ? Snapshot.fromBytes(bytes) : SAVED, Tank::new);
        assertEquals(bits, Churn.bits(other));
        assertEquals(world.stateHash(), other.stateHash());
        for (Unit unit : other) {
            gone.remove(unit);
            assertSame(other, unit.getWorld());
            Unit had = known.get(unit.getId());
            if (had != null) assertSame(had, unit);
            else assertEquals(unit.getId(), ((Tank) unit).made);
        }
        assertOutside(gone);
        assertFound(other);

        Snapshot again = Saves.snapshot(other);
        assertEquals("", SAVED.difference(again));
        assertArrayEquals(bytes, again.toBytes());
        assertArrayEquals(bytes, Snapshot.fromBytes(bytes).toBytes());
        assertEquals(new Churn(seed + 2).play(world, after), new Churn(seed + 2).play(other, after));
        assertEquals(Churn.bits(world), Churn.bits(other));
    }

    @Property(tries = 5000)
    @Tag("long")
    void bothHoldForLongGames(
            @ForAll long seed,
            @ForAll("kinds") Kind kind,
            @ForAll("kinds") Kind otherKind,
            @ForAll @IntRange(max = 60) int before,
            @ForAll @IntRange(max = 20) int between,
            @ForAll @IntRange(max = 30) int after) {
        aRestoredWorldContinuesAsTheSavedOne(seed, kind, otherKind, before, between, after);
        anotherWorldContinuesAsTheSavedOneAfterARestore(seed, kind, otherKind, before, between, after, seed % 5 < 2);
    }

    @Provide
    Arbitrary<Kind> kinds() {
        Arbitrary<Timestep> steps = Arbitraries.of(
                Timestep.fixed(60),
                Timestep.fixed(1),
                Timestep.fixed(144),
                Timestep.fixed(1_000_000),
                Timestep.variable(0.01),
                Timestep.variable(1e-6),
                Timestep.variable(1e9));
        Arbitrary<Integer> most = Arbitraries.integers().between(1, 8);
        return Combinators.combine(Arbitraries.of(Integrator.class), steps, most)
                .as((integrator, timestep, n) -> new Kind(integrator, timestep.withMaxSteps(n)));
    }

    private static Map<Unit, List<Long>> kept(World world) {
        Map<Unit, List<Long>> states = new LinkedHashMap<>();
        for (Unit unit : world) states.put(unit, Churn.kept(unit));
        return states;
    }

    private static void assertOutside(Map<Unit, List<Long>> states) {
        states.forEach((unit, state) -> {
            assertNull(unit.getWorld());
            assertEquals(state, Churn.kept(unit));
            assertEquals(
                    List.of(0.0, 0.0, 0.0, 0.0),
                    List.of(unit.getFx(), unit.getFy(), unit.getPendingImpulseX(), unit.getPendingImpulseY()),
                    "a unit that left has forces");
        });
    }

    /** Checks that find returns every unit by its id, and null for other ids. */
    private static void assertFound(World world) {
        List<Unit> found = new ArrayList<>();
        long most = 0;
        for (Unit unit : world) most = Math.max(most, unit.getId());
        for (long id = -1; id <= most + 3; id++) if (world.find(id) != null) found.add(world.find(id));
        assertEquals(world.size(), found.size());
        for (Unit unit : world) assertSame(unit, world.find(unit.getId()));
    }
}
