package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.NotSerializableException;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** What games ask of units and their world besides: removal by condition, settings, and no serialisation by accident. */
class UnitsTest {
    @Test
    void removeIfAsksEachOnceAndKeepsTheRestInTheOrderOfTheIterator() {
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
        assertEquals(Integrator.EULER, world.getIntegrator());
        assertEquals(Timestep.fixed(60).toString(), world.getTimestep().toString());
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

    /** A change of the integrator reaches those who coast, too, and those who sleep. */
    @Test
    void aWorldWithItsSettingsChangedIsOneThatWasMadeWithThem() {
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

    private static final class Tank extends Unit implements Serializable {
        private static final long serialVersionUID = 1;
        final int shells = 3;

        Tank() {
            super(40_000);
        }
    }

    @Test
    void unitsRefuseToBeSerialised() throws Exception {
        try (ObjectOutputStream out = new ObjectOutputStream(new ByteArrayOutputStream())) {
            Exception e = assertThrows(NotSerializableException.class, () -> out.writeObject(new Tank()));
            assertTrue(e.getMessage().startsWith(Tank.class.getName()), e.getMessage());
            assertTrue(e.getMessage().contains("save a Snapshot"), e.getMessage());
            assertThrows(NotSerializableException.class, () -> out.writeObject(new Unit(1)));
        }
    }
}
