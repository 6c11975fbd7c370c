package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The calls for all units, with arrays of the game, give the same bits as calls for each unit. */
class BulkTest {
    private static World crowd(Integrator integrator, int units) {
        World world = new World(integrator, Timestep.fixed(60));
        for (int i = 0; i < units; i++) {
            world.add(new Unit(1 + i % 5).setFriction(i % 3).setMaxSpeed(i % 7 == 0 ? 4 : 1000))
                    .setPosition(i, -i)
                    .setVelocity(i % 11, i % 13);
        }
        return world;
    }

    private static double[] forces(int units, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return random.doubles(2L * units, -100, 100).toArray();
    }

    @ParameterizedTest
    @EnumSource
    void applyForcesGivesTheBitsOfApplyForceForEachUnit(Integrator integrator) {
        for (int units : new int[] {0, 1, 31, 32, 33, 511, 512, 513, 5000}) {
            World bulk = crowd(integrator, units), single = crowd(integrator, units);
            for (int frame = 0; frame < 6; frame++) {
                double[] xy = forces(units + 1, frame);
                bulk.applyForces(xy, 2);
                for (int i = 0; i < units; i++) single.get(i).applyForce(xy[2 + 2 * i], xy[3 + 2 * i]);
                assertEquals(single.stateHash(), bulk.stateHash());
                for (World world : new World[] {bulk, single}) {
                    if (frame % 2 == 0) world.step();
                    else world.advance(0.025);
                }
                assertEquals(single.stateHash(), bulk.stateHash(), units + " units, frame " + frame);
            }
        }
    }

    /** At any position of the invalid force: the forces before it are not applied either. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 1023, 1024, 1025, 1199})
    void ifOneForceIsInvalidNoForceIsApplied(int place) {
        World world = crowd(Integrator.EULER, 600);
        world.get(3).applyForce(1, 2);
        long hash = world.stateHash();
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, -1.1e50, Double.MAX_VALUE}) {
            double[] xy = forces(600, 1);
            xy[place] = bad;
            String message = assertThrows(IllegalArgumentException.class, () -> world.applyForces(xy, 0))
                    .getMessage();
            assertTrue(message.startsWith("xy[" + place + "] must be finite"), message);
            assertTrue(message.endsWith("was " + bad), message);
            assertEquals(hash, world.stateHash());
        }
        double[] most = new double[1200];
        Arrays.fill(most, 1e50);
        world.applyForces(most, 0);
        assertEquals(1e50, world.get(599).getFy());
    }

    /** As the Javadoc of {@link World#copyPositions(double[], int, double)} says. */
    @Test
    void positionsInDoubleAtTheAlphaOfTheWorldAreThoseToDrawAt() {
        World world = crowd(Integrator.EXACT, 600);
        double[] xy = new double[1200];
        for (int frame = 0; frame < 20; frame++) {
            if (frame == 7) world.get(5).moveTo(3, 4);
            world.advance(1 / 144.0);
            world.copyPositions(xy, 0, world.getAlpha());
            for (Unit unit : world) {
                assertEquals(unit.getInterpolatedX(), xy[2 * unit.getIndex()]);
                assertEquals(unit.getInterpolatedY(), xy[2 * unit.getIndex() + 1]);
            }
        }
    }

    @Test
    void arraysThatAreTooShortThrowAndStayUnchanged() {
        World world = crowd(Integrator.EULER, 3);
        long hash = world.stateHash();
        double[] six = new double[6];
        float[] floats = new float[6];
        for (int offset : new int[] {1, -1, 6, 7, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
            assertThrows(IndexOutOfBoundsException.class, () -> world.applyForces(six, offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(six, offset, 1));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyVelocities(six, offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(floats, offset));
            assertThrows(IndexOutOfBoundsException.class, () -> world.copyPositions(floats, offset, 1));
        }
        for (double alpha : new double[] {Double.NaN, -0.1, 1.1}) {
            assertThrows(IllegalArgumentException.class, () -> world.copyPositions(six, 0, alpha));
            assertThrows(IllegalArgumentException.class, () -> world.copyPositions(floats, 0, alpha));
        }
        assertArrayEquals(new double[6], six);
        assertArrayEquals(new float[6], floats);
        assertEquals(hash, world.stateHash());
    }

    @Test
    void copiesEqualTheGetters() {
        World world = crowd(Integrator.EXACT, 5000);
        world.advance(0.04);
        double[] xy = new double[2 * 5000 + 3];
        float[] drawn = new float[2 * 5000 + 3];
        for (double alpha : new double[] {0, 0.25, 0.5, 1}) {
            world.copyPositions(xy, 2, alpha);
            world.copyPositions(drawn, 2, alpha);
            for (int i = 0; i < 5000; i++) {
                Unit unit = world.get(i);
                assertEquals(unit.getInterpolatedX(alpha), xy[2 + 2 * i]);
                assertEquals(unit.getInterpolatedY(alpha), xy[3 + 2 * i]);
                assertEquals((float) unit.getInterpolatedX(alpha), drawn[2 + 2 * i]);
                assertEquals((float) unit.getInterpolatedY(alpha), drawn[3 + 2 * i]);
                if (alpha == 1) assertEquals(unit.getX(), xy[2 + 2 * i]);
            }
        }
        world.copyPositions(drawn, 2);
        world.copyPositions(xy, 2, world.getAlpha());
        for (int i = 2; i < 10_002; i++) assertEquals((float) xy[i], drawn[i]);
        world.copyVelocities(xy, 2);
        for (int i = 0; i < 5000; i++) {
            assertEquals(world.get(i).getVx(), xy[2 + 2 * i]);
            assertEquals(world.get(i).getVy(), xy[3 + 2 * i]);
        }
        assertEquals(0, xy[0] + xy[1] + xy[10_002] + drawn[0] + drawn[1] + drawn[10_002], "no other value changes");
    }

    /** As in a lockstep game, which calls step() and passes its own alpha. */
    @Test
    void alphaInterpolatesFromBeforeTheStepToAfterIt() {
        World world = new World();
        Unit tank = world.add(new Unit(1).setPosition(3, 4).setVelocity(10, -20));
        assertEquals(3, tank.getInterpolatedX(0), "no step yet");
        world.step(0.1);
        assertEquals(3, tank.getInterpolatedX(0));
        assertEquals(3.25, tank.getInterpolatedX(0.25), 1e-15);
        assertEquals(3, tank.getInterpolatedY(0.5), 1e-15);
        assertEquals(tank.getX(), tank.getInterpolatedX(1));
        assertEquals(tank.getX(), tank.getInterpolatedX(), "without an alpha, a step(dt) is not interpolated");
        tank.setVelocity(0, 0);
        world.step(0.1);
        for (double alpha : new double[] {0, 0.3, 1}) assertEquals(4, tank.getInterpolatedX(alpha), "it does not move");
        for (double bad : new double[] {Double.NaN, -1e-9, Math.nextUp(1.0), 2}) {
            String message = assertThrows(IllegalArgumentException.class, () -> tank.getInterpolatedX(bad))
                    .getMessage();
            assertEquals("alpha must be from 0 to 1, was " + bad, message);
            assertThrows(IllegalArgumentException.class, () -> tank.getInterpolatedY(bad));
        }
        Unit alone = new Unit(1).setVelocity(1, 1);
        alone.integrate(1);
        assertEquals(1, alone.getInterpolatedX(0), "a unit alone is not interpolated");
    }
}
