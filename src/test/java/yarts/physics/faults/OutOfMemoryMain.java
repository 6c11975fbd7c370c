package yarts.physics.faults;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ForkJoinPool;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Makes calls that allocate memory, first without free memory, and then with slightly more each time until they
 * succeed. So they fail at every possible point. After each failure the world must be unchanged, and the same call with
 * memory must have the same effect as in a world without a failure. It needs a separate JVM with a small heap.
 */
final class OutOfMemoryMain {
    private OutOfMemoryMain() {}

    /** A call. Its result is compared, too. It is not an object, which would need memory after the call. */
    private interface Call {
        long on(World world);
    }

    private static final Map<String, Call> CALLS = new LinkedHashMap<>();

    /** The arguments of some calls, created while there is memory. */
    private static Unit newUnit;

    private static NewUnits newUnits;
    private static Snapshot larger, smaller, used;
    private static byte[] bytes;
    private static ForkJoinPool pool;

    static {
        CALLS.put("add", world -> world.add(newUnit).getId());
        CALLS.put("find", world -> (long) world.find(world.get(0).getId()).getMass());
        CALLS.put("find and add", world -> {
            world.find(1);
            return world.find(world.add(newUnit).getId()).getId();
        });
        CALLS.put("find and remove", world -> {
            world.find(1);
            return world.remove(world.find(2)) ? 1 : 0;
        });
        CALLS.put("remove", world -> world.remove(world.get(0)) ? 1 : 0);
        CALLS.put("clear", world -> {
            world.clear();
            return world.size();
        });
        CALLS.put("remove if", world -> {
            world.removeIf(unit -> unit.getMass() % 3 == 1);
            return world.size();
        });
        CALLS.put("save", world -> world.save().size());
        CALLS.put("save into one that was used", world -> {
            world.save(used);
            return used.size();
        });
        CALLS.put("restore more", world -> {
            world.restore(larger, id -> newUnits.next());
            return world.size();
        });
        CALLS.put("restore fewer", world -> {
            world.restore(smaller);
            return world.size();
        });
        CALLS.put("write", world -> world.save().toBytes().length);
        CALLS.put("read", world -> Snapshot.fromBytes(bytes).size());
        CALLS.put("set a pool", world -> {
            world.setPool(pool);
            return world.size();
        });
        CALLS.put("step", world -> {
            world.step();
            return world.getTick();
        });
        CALLS.put("advance", world -> world.advance(0.05));
    }

    /** Units that were created while there was memory. */
    private static final class NewUnits {
        private final List<Unit> made = new ArrayList<>();
        private int next;

        NewUnits(int n) {
            for (int i = 0; i < n; i++) made.add(new Unit(1));
        }

        Unit next() {
            return made.get(next++);
        }
    }

    /** Occupies all free memory, in pieces. */
    private static final class Ballast {
        private static final int[] SIZES = {1 << 16, 1 << 12, 1 << 8, 1 << 4};
        private final Object[][] pieces = new Object[SIZES.length][1 << 15];
        private final int[] counts = new int[SIZES.length];

        void fill() {
            for (int k = 0; k < SIZES.length; k++) {
                try {
                    while (counts[k] < pieces[k].length) {
                        pieces[k][counts[k]] = new byte[SIZES[k] - 16];
                        counts[k]++;
                    }
                } catch (OutOfMemoryError e) {
                    // No piece of this size is free.
                }
            }
        }

        /** Frees n bytes. */
        void release(int n) {
            for (int k = 0; k < SIZES.length; k++) {
                for (; n >= SIZES[k] && counts[k] > 0; n -= SIZES[k]) pieces[k][--counts[k]] = null;
            }
        }

        void clear() {
            for (int k = 0; k < SIZES.length; k++) while (counts[k] > 0) pieces[k][--counts[k]] = null;
        }
    }

    private static final Ballast BALLAST = new Ballast();

    private static World world(int units) {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 0; i < units; i++) {
            Unit unit = world.add(new Unit(1 + i)).setFriction(i % 3).setVelocity(i, 1);
            unit.applyForce(i, -1);
        }
        world.advance(0.02);
        for (int i = 0; i < units; i += 3) world.get(i).applyForce(1, i);
        return world;
    }

    private static void prepare(World world) {
        int units = world.size();
        newUnit = new Unit(7).setPosition(1, 2);
        newUnit.applyForce(3, 4);
        newUnits = new NewUnits(units + 40);
        used = world(3).save();
        pool = new ForkJoinPool(2);
        World other = world(2 * units + 40);
        larger = Snapshot.fromBytes(other.save().toBytes());
        bytes = world.save().toBytes();
        smaller = Snapshot.fromBytes(world(units / 2 + 1).save().toBytes());
    }

    private static void require(boolean holds, String what) {
        if (!holds) throw new AssertionError(what);
    }

    /** Compares all values of a world: the hash, the order, the ids, and the results of find. */
    private static void requireSame(List<Long> expected, long hash, World world, String when) {
        require(hash == world.stateHash(), "another hash " + when);
        require(expected.equals(Churn.bits(world)), "other values " + when);
        int count = 0;
        for (Unit unit : world) {
            require(unit.getWorld() == world && world.contains(unit), "not a member " + when);
            require(world.units().indexOf(unit) == count, "at another index " + when);
            require(world.find(unit.getId()) == unit, "not found " + when);
            count++;
        }
        require(count == world.size(), "another size " + when);
        World restored = new World();
        restored.restore(world.save());
        require(restored.stateHash() == hash, "another save " + when);
    }

    private static int failures(String name, Call call, int units) {
        World never = world(units);
        prepare(never);
        long result = call.on(never);
        long after = never.stateHash();
        List<Long> afterwards = Churn.bits(never);
        int failures = 0;
        for (int free = 0; free < 1 << 23; free += 16 + free / 3) {
            World world = world(units);
            prepare(world);
            long before = world.stateHash();
            List<Long> values = Churn.bits(world), unitsValues = Churn.bits(newUnit);
            long got = 0;
            boolean failed = false;
            BALLAST.fill();
            BALLAST.release(free);
            try {
                got = call.on(world);
            } catch (OutOfMemoryError e) {
                failed = true;
            }
            BALLAST.clear();
            String when = "after " + name + " with " + units + " units and " + free + " bytes";
            if (failed) {
                failures++;
                // These may have done a part of their work, but that part completely.
                if (name.matches("find and .*|clear|remove if"))
                    requireSame(Churn.bits(world), world.stateHash(), world, when);
                else requireSame(values, before, world, when);
                require(
                        newUnit.getWorld() != null || unitsValues.equals(Churn.bits(newUnit)),
                        "a changed unit " + when);
                Snapshot now = world.save();
                for (World other : new World[] {new World(), world}) {
                    other.restore(used);
                    require(other.stateHash() == world(3).stateHash(), "another snapshot " + when);
                }
                world.restore(now);
                newUnits.next = 0;
                if (newUnit.getWorld() == null) got = call.on(world);
                else got = result;
            }
            require(result == got, "another result " + when + ": " + got);
            requireSame(afterwards, after, world, when + " and success");
            pool.shutdown();
            if (!failed) return failures;
        }
        throw new AssertionError(name + " never succeeds");
    }

    public static void main(String[] args) {
        for (Map.Entry<String, Call> entry : CALLS.entrySet()) {
            StringBuilder line = new StringBuilder(entry.getKey()).append(':');
            for (String units : args) {
                line.append(' ').append(failures(entry.getKey(), entry.getValue(), Integer.parseInt(units)));
            }
            System.out.println(line);
        }
    }
}
