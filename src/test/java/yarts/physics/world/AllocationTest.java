package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** After warm-up, the calls of a frame allocate nothing. The JVM counts the bytes of each thread. */
class AllocationTest {
    private static final int UNITS = 1000;
    private static final int WARM_UP = 300;
    private static final int BATCHES = 20;
    private static final int REPEATS = 50;

    private static ThreadMXBean threads;
    private static volatile Object escape;

    @BeforeAll
    static void allocationsAreCounted() {
        assumeTrue(ManagementFactory.getThreadMXBean() instanceof ThreadMXBean, "this JVM counts no allocations");
        threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        assumeTrue(threads.isThreadAllocatedMemorySupported(), "this JVM counts no allocations");
        threads.setThreadAllocatedMemoryEnabled(true);
    }

    /** The fewest bytes of several batches, because the JVM itself sometimes allocates when it compiles. */
    private static long fewestBytes(Runnable work) {
        for (int i = 0; i < WARM_UP; i++) work.run();
        long id = Thread.currentThread().getId();
        long fewest = Long.MAX_VALUE;
        for (int batch = 0; batch < BATCHES; batch++) {
            long before = threads.getThreadAllocatedBytes(id);
            for (int i = 0; i < REPEATS; i++) work.run();
            fewest = Math.min(fewest, threads.getThreadAllocatedBytes(id) - before);
        }
        return fewest;
    }

    private static World crowd(Integrator integrator, Timestep timestep) {
        World world = new World(integrator, timestep);
        for (int i = 1; i <= UNITS; i++)
            world.add(new Unit(i).setFriction(i % 7).setMaxSpeed(i % 5 == 0 ? 1 : 100))
                    .setMotor(i % 4, i % 3, i % 6);
        world.addBeforeStep((w, dt) -> w.get(0).applyForce(dt, 1));
        return world;
    }

    @Test
    void theCounterDetectsASingleObject() {
        long bytes = fewestBytes(() -> escape = new Object());
        assertTrue(bytes >= 8 * REPEATS, () -> bytes + " bytes");
        World world = crowd(Integrator.EULER, Timestep.fixed(60));
        assertTrue(fewestBytes(() -> escape = world.iterator()) > 0);
        assertTrue(fewestBytes(() -> world.add(world.remove(world.get(0)) ? new Unit(1) : null)) > 0);
    }

    @ParameterizedTest
    @EnumSource
    void stepsOfAnyLengthAllocateNothing(Integrator integrator) {
        World world = crowd(integrator, Timestep.fixed(60));
        int[] i = {0};
        assertEquals(0, fewestBytes(() -> world.step(1 / (60.0 + i[0]++ / 10 % 3))));
        assertTrue(world.getTick() > 1000);
    }

    @ParameterizedTest
    @EnumSource
    void fixedFramesAllocateNothing(Integrator integrator) {
        World world = crowd(integrator, Timestep.fixed(60));
        int[] i = {0};
        assertEquals(0, fewestBytes(() -> frame(world, i[0]++ % 40 == 0 ? 0.5 : 0.004 * (i[0] % 7))));
        assertTrue(world.getTick() > 1000 && world.getDroppedTime() > 0);
    }

    @ParameterizedTest
    @EnumSource
    void variableFramesAllocateNothing(Integrator integrator) {
        World world = crowd(integrator, Timestep.variable(0.01));
        int[] i = {0};
        assertEquals(0, fewestBytes(() -> frame(world, 0.004 * (i[0]++ % 7))));
        assertTrue(world.getTick() > 1000);
    }

    /** A frame of a game: forces on all units by index, setters, and an advance. */
    private static void frame(World world, double elapsed) {
        for (int i = 0; i < world.size(); i++) {
            Unit unit = world.get(i);
            unit.applyForce(10, -i);
            if (i % 10 == 0) unit.applyImpulse(-1, 1);
            if (i % 50 == 0) unit.setFriction(i % 3).setMass(1 + i % 4);
            if (i % 20 == 0) unit.setMotor(i % 8, 1, i % 9);
            if (i % 100 == 0) unit.setPosition(i, -i).setVelocity(0, i).setMaxSpeed(i);
        }
        world.advance(elapsed);
    }

    /** With waiting forces, pending impulses and interpolation; every second call restores. */
    @ParameterizedTest
    @EnumSource
    void savingRestoringAndHashingAllocateNothing(Integrator integrator) {
        for (Timestep timestep : List.of(Timestep.fixed(60), Timestep.variable(0.01))) {
            World world = crowd(integrator, timestep);
            Snapshot before = new Snapshot(), after = new Snapshot();
            long[] count = {0, 0};
            assertEquals(0, fewestBytes(() -> {
                world.get((int) (count[0]++ % UNITS)).applyForce(1, 1);
                world.save(before);
                frame(world, 0.004 * (count[0] % 7));
                world.save(after);
                long hash = world.stateHash();
                world.restore(before);
                if (world.stateHash() != hash) count[1]++;
                if (count[0] % 2 == 0) world.restore(after);
            }));
            assertEquals(count[0], count[1]);
            assertTrue(world.getTick() > 300);
        }
    }

    /** Also if the units fill the arrays exactly. */
    @Test
    void savingAllocatesNothingWithAnyNumberOfUnits() {
        World world = new World();
        Snapshot snapshot = new Snapshot();
        for (int units : new int[] {1, 15, 16, 17, 32, 64, 128}) {
            while (world.size() < units) world.add(new Unit(1));
            assertEquals(0, fewestBytes(() -> world.save(snapshot)), units + " units");
        }
    }

    @Test
    void drawingAllocatesNothing() {
        World world = crowd(Integrator.EULER, Timestep.fixed(60));
        world.advance(0.02);
        float[] buffer = new float[2 * UNITS];
        double[] doubles = new double[2 * UNITS];
        double[] sum = {0};
        assertEquals(0, fewestBytes(() -> {
            world.copyPositions(buffer, 0);
            world.copyPositions(buffer, 0, 0.25);
            world.copyPositions(doubles, 0, 0.25);
            world.copyVelocities(doubles, 0);
            for (int i = 0; i < world.size(); i++) {
                Unit unit = world.units().get(i);
                sum[0] += unit.getInterpolatedX() + unit.getInterpolatedY() + unit.getSpeed() + world.getAlpha();
                sum[0] += unit.getInterpolatedX(0.25) + unit.getInterpolatedY(0.25) + unit.getPendingImpulseX();
            }
        }));
        assertTrue(sum[0] > 0);
    }

    /** Tiles that are pushed, coast or sleep; units that are frozen and released; other integrators and rates. */
    @Test
    void bulkForcesFreezingAndSettingsAllocateNothing() {
        World world = crowd(Integrator.EULER, Timestep.fixed(60));
        world.addAfterStep((w, dt) -> w.get(1).moveTo(1, 1).applyForce(1, 1));
        double[] forces = new double[2 * UNITS];
        Arrays.setAll(forces, i -> i % 11 - 5);
        Integrator[] integrators = Integrator.values();
        Timestep[] timesteps = {Timestep.fixed(60), Timestep.fixed(30), Timestep.variable(0.02)};
        int[] count = {0};
        assertEquals(0, fewestBytes(() -> {
            int i = count[0]++;
            if (i % 3 == 0) world.applyForces(forces, 0);
            world.get(i % UNITS).setFrozen(i % 2 == 0);
            world.setIntegrator(integrators[i / 10 % 4]);
            world.setTimestep(timesteps[i / 20 % 3]);
            world.step();
            world.advance(0.05);
        }));
        assertTrue(world.getTick() > 1000);
    }

    @ParameterizedTest
    @EnumSource
    void aUnitAloneAllocatesNothing(Integrator integrator) {
        Unit unit = new Unit(2).setFriction(0.1).setMaxSpeed(50).setMotor(40, 30, 20);
        assertEquals(0, fewestBytes(() -> {
            unit.applyForce(3, 4);
            unit.integrate(0.01, integrator);
            unit.integrate(0.02);
            unit.setMotor(unit.getMotorVy(), unit.getMotorVx(), unit.getMotorForce());
            unit.clearForces();
        }));
        assertTrue(unit.getSpeed() > 1);
    }
}
