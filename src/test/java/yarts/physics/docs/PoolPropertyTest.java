package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Snapshot;
import yarts.physics.Unit;
import yarts.physics.World;

/** The recipe of docs/cookbook.md for pooled units, through rollbacks. */
class PoolPropertyTest {
    /** A random game, with a pool or without, that spawns, removes, steps, saves and restores. */
    private static final class Game {
        final World world = new World();
        private final Deque<Unit> pool = new ArrayDeque<>();
        private final Snapshot[] past = new Snapshot[4];
        private final boolean pools;
        private final Random random;
        int reused;

        Game(boolean pools, long seed) {
            this.pools = pools;
            random = new Random(seed);
            for (int i = 0; i < past.length; i++) past[i] = world.save();
        }

        private Unit take() {
            Unit unit = pool.poll();
            while (unit != null && unit.getWorld() != null) unit = pool.poll();
            if (unit == null) return new Unit(10);
            reused++;
            return unit;
        }

        private void spawn() {
            Unit unit = take();
            unit.setFrozen(false).setMass(10).setFriction(3).setMotor(0, 0, 0).setMaxSpeed(900);
            world.add(unit.setPosition(5, 0).setVelocity(800, random.nextInt(9)));
        }

        /** Changes all properties that must be reset before the unit is used again. */
        private void use(Unit unit) {
            unit.setMass(1 + random.nextInt(9)).setFriction(random.nextInt(9)).setMaxSpeed(50 * random.nextInt(9));
            unit.setMotor(random.nextInt(9), 9, random.nextInt(2) * 500).setFrozen(random.nextInt(4) == 0);
            unit.applyForce(1_000, random.nextInt(9));
        }

        private void remove(Unit unit) {
            world.remove(unit);
            if (pools) pool.push(unit);
        }

        void play() {
            switch (random.nextInt(6)) {
                case 0, 1 -> spawn();
                case 2 -> {
                    if (world.size() > 0) remove(world.get(random.nextInt(world.size())));
                }
                case 3 -> {
                    if (world.size() > 0) use(world.get(random.nextInt(world.size())));
                    world.advance(random.nextDouble() / 20);
                }
                case 4 -> world.save(past[random.nextInt(past.length)]);
                default -> world.restore(past[random.nextInt(past.length)]);
            }
        }
    }

    @Property(tries = 300)
    void aGameWithAPoolAndRollbacksIsTheSameToTheBitAsOneWithoutAPool(
            @ForAll long seed, @ForAll @IntRange(min = 1, max = 400) int length) {
        Game pooled = new Game(true, seed), plain = new Game(false, seed);
        for (int i = 0; i < length; i++) {
            pooled.play();
            plain.play();
            assertEquals(
                    plain.world.stateHash(),
                    pooled.world.stateHash(),
                    () -> plain.world.save().difference(pooled.world.save()));
            var objects = Collections.newSetFromMap(new IdentityHashMap<Unit, Boolean>());
            objects.addAll(pooled.world.units());
            assertEquals(pooled.world.size(), objects.size(), "a unit is in the world twice");
        }
        var ids = new HashSet<Long>();
        for (Unit unit : pooled.world) ids.add(unit.getId());
        assertEquals(pooled.world.size(), ids.size());
        assertEquals(0, plain.reused);
    }
}
