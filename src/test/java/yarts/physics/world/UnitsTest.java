package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.NotSerializableException;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** Other uses of units and worlds: removal by a filter, settings, toString, and protection from serialisation. */
class UnitsTest {
    @Test
    void removeIfTestsEachUnitOnceAndLeavesTheOrderOfTheIterator() {
        World world = new World(), iterated = new World();
        for (int i = 0; i < 1000; i++) {
            world.add(new Unit(1 + i));
            iterated.add(new Unit(1 + i));
        }
        List<Double> asked = new ArrayList<>();
        assertTrue(world.removeIf(unit -> {
            asked.add(unit.getMass());
            return unit.getMass() % 3 == 0;
        }));
        assertEquals(1000, asked.stream().distinct().count());
        assertEquals(1000, asked.size());
        for (var units = iterated.iterator(); units.hasNext(); )
            if (units.next().getMass() % 3 == 0) units.remove();
        assertEquals(iterated.stateHash(), world.stateHash());
        assertEquals(667, world.size());
        assertFalse(world.removeIf(unit -> unit.getMass() % 3 == 0));
        assertThrows(NullPointerException.class, () -> world.removeIf(null));
    }

    @Test
    void settingsActFromTheNextStepOn() {
        World world = new World();
        assertEquals(Integrator.EXACT, world.getIntegrator());
        assertEquals(Timestep.fixed(60), world.getTimestep());
        world.setIntegrator(Integrator.EULER);
        Unit unit = world.add(new Unit(1));
        unit.applyForce(2, 0);
        world.step(1);
        assertEquals(0, unit.getX());
        world.setIntegrator(Integrator.MIDPOINT);
        unit.applyForce(2, 0);
        world.step(1);
        assertEquals(3, unit.getX());
        assertEquals(Integrator.MIDPOINT, world.getIntegrator());
        assertThrows(NullPointerException.class, () -> world.setIntegrator(null));
        assertThrows(NullPointerException.class, () -> world.setTimestep(null));
        world.setTimestep(Timestep.fixed(4));
        world.step();
        assertEquals(4, unit.getX());
        world.setTimestep(Timestep.variable(0.5));
        world.step();
        assertEquals(6, unit.getX());
    }

    /** A change of the integrator also applies to coasting and sleeping tiles. */
    @Test
    void aWorldWithChangedSettingsEqualsOneCreatedWithThem() {
        World changed = new World(Integrator.EULER, Timestep.fixed(60)),
                made = new World(Integrator.EXACT, Timestep.fixed(25));
        for (World world : List.of(changed, made)) {
            for (int i = 0; i < 600; i++)
                world.add(new Unit(1 + i)).setFriction(i).setVelocity(i % 2, i % 3);
        }
        changed.setIntegrator(Integrator.EXACT);
        changed.setTimestep(Timestep.fixed(25));
        assertEquals(made.stateHash(), changed.stateHash());
        for (World world : List.of(changed, made)) for (int i = 0; i < 100; i++) world.advance(0.033);
        assertEquals(made.stateHash(), changed.stateHash());
    }

    @Test
    void theListOfUnitsContainsOnlyUnitsOfTheWorld() {
        World world = new World();
        Unit first = world.add(new Unit(1)), second = world.add(new Unit(1));
        Unit there = new World().add(new Unit(1));
        assertTrue(world.units().contains(first));
        assertTrue(world.units().contains(second));
        assertEquals(1, world.units().indexOf(second));
        for (Object other : new Object[] {there, new Unit(1), "unit", null}) {
            assertFalse(world.units().contains(other));
            assertEquals(-1, world.units().indexOf(other));
        }
    }

    /** An addition and a removal together are a change, too. */
    @Test
    void anIteratorFailsAfterChangesThatPreserveTheSize() {
        World world = new World();
        for (int i = 0; i < 3; i++) world.add(new Unit(1));
        Snapshot three = world.save();
        assertFailsFast(world, () -> {
            world.add(new Unit(1));
            world.remove(world.get(0));
        });
        assertFailsFast(world, () -> {
            world.restore(three);
            world.remove(world.get(2));
        });
        assertFailsFast(world, () -> {
            world.restore(three);
            world.add(new Unit(1));
        });
        world.clear();
        for (int i = 0; i < 2; i++) world.add(new Unit(1));
        assertFailsFast(world, () -> {
            world.restore(three);
            world.restore(three);
        });
    }

    private static void assertFailsFast(World world, Runnable change) {
        Iterator<Unit> units = world.iterator();
        units.next();
        change.run();
        assertThrows(ConcurrentModificationException.class, units::next);
    }

    @Test
    void toStringOfAUnitHasItsState() {
        Unit unit = new Unit(4).setPosition(1, 2).setVelocity(3, -0.5);
        assertEquals(
                "Unit#0[x=1.0, y=2.0, vx=3.0, vy=-0.5, mass=4.0, friction=0.0, maxSpeed=Infinity]", unit.toString());
        Unit tank = new World().add(new Tank()).setFriction(8).setMaxSpeed(15).setFrozen(true);
        assertEquals(
                "Tank#1[x=0.0, y=0.0, vx=0.0, vy=0.0, mass=40000.0, friction=8.0, maxSpeed=15.0, frozen]",
                tank.toString());
        assertEquals(
                "World[1 units, tick=0, time=0.0, EXACT, Timestep.fixed(60).withMaxSteps(15)]",
                tank.getWorld().toString());
        assertEquals("Snapshot[1 units, tick=0]", tank.getWorld().save().toString());
        assertEquals("Snapshot[empty]", new Snapshot().toString());
    }

    /** Neither the world nor a new table keeps references to units that left by a restore. */
    @Test
    void aUnitThatLeftByARestoreCanBeCollected() throws Exception {
        World world = new World();
        Snapshot empty = world.save();
        List<WeakReference<Unit>> gone = new ArrayList<>();
        for (int i = 0; i < 20; i++) gone.add(new WeakReference<>(world.add(new Unit(1))));
        world.restore(empty);
        for (int i = 0; i < 100 && gone.stream().anyMatch(unit -> unit.get() != null); i++) {
            System.gc();
            Thread.sleep(10);
        }
        assertTrue(gone.stream().allMatch(unit -> unit.get() == null));
        assertEquals(0, world.size());
    }

    private static final class Tank extends Unit implements Serializable {
        private static final long serialVersionUID = 1;

        @SuppressWarnings("unused") // serialisation would write it
        final int shells = 3;

        Tank() {
            super(40_000);
        }
    }

    @Test
    void serialisationOfAUnitThrows() throws Exception {
        try (ObjectOutputStream out = new ObjectOutputStream(new ByteArrayOutputStream())) {
            Exception e = assertThrows(NotSerializableException.class, () -> out.writeObject(new Tank()));
            assertTrue(e.getMessage().startsWith(Tank.class.getName()), e.getMessage());
            assertTrue(e.getMessage().contains("save a Snapshot"), e.getMessage());
            assertThrows(NotSerializableException.class, () -> out.writeObject(new Unit(1)));
        }
    }
}
