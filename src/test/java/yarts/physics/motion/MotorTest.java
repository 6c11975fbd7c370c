package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Churn;

/** The motor as games use it. {@link MotorPropertyTest} tests its formula for all numbers. */
class MotorTest {
    private static final double DT = 1 / 60.0;

    private static void assertVelocity(double vx, double vy, Unit unit) {
        assertEquals(vx, unit.getVx(), 0, unit::toString);
        assertEquals(vy, unit.getVy(), 0, unit::toString);
    }

    private static void assertMotor(double vx, double vy, double maxForce, Unit unit) {
        assertEquals(vx, unit.getMotorVx());
        assertEquals(vy, unit.getMotorVy());
        assertEquals(maxForce, unit.getMotorForce());
    }

    // Engines and brakes

    /** 40 t, 80 kN, no friction: 2 m/s², so 10 m/s after 5 s, to within a step. */
    @ParameterizedTest
    @EnumSource
    void aTankReachesExactlyItsOrderedVelocityAndKeepsIt(Integrator integrator) {
        Unit tank = new Unit(40_000).setMotor(6, -8, 80_000);
        for (int i = 1; i <= 299; i++) {
            tank.integrate(DT, integrator);
            assertEquals(i / 30.0, tank.getSpeed(), 1e-12);
            assertEquals(-8 / 6.0, tank.getVy() / tank.getVx(), 1e-12, "straight towards it");
        }
        tank.integrate(DT, integrator);
        tank.integrate(DT, integrator);
        for (int i = 0; i < 1000; i++) {
            assertVelocity(6, -8, tank);
            tank.integrate(DT, integrator);
        }
    }

    @ParameterizedTest
    @EnumSource
    void anEngineThatIsStrongEnoughKeepsTheVelocityAgainstFrictionAndWind(Integrator integrator) {
        Unit boat = new Unit(1000).setFriction(200).setMotor(10, 0, 2100); // f·u is 2000 N
        for (int i = 0; i < 3600; i++) {
            boat.applyForce(0, 50);
            boat.integrate(DT, integrator);
            assertTrue(boat.getVx() <= 10, "never above it");
        }
        assertVelocity(10, 0, boat);
    }

    @ParameterizedTest
    @EnumSource
    void anEngineThatIsTooWeakApproachesItsForceOverTheFriction(Integrator integrator) {
        Unit boat = new Unit(1000).setFriction(200).setVelocity(-3, 4).setMotor(30, 40, 2000); // R/f is 10 m/s
        for (int i = 0; i < 60 * 300; i++) boat.integrate(DT, integrator);
        assertEquals(6, boat.getVx(), 1e-12);
        assertEquals(8, boat.getVy(), 1e-12);
    }

    /** For a step of any length: a brake with twice the force needed does not reverse the unit. */
    @ParameterizedTest
    @EnumSource
    void aBrakeStopsAUnitExactlyAndNeverReversesIt(Integrator integrator) {
        for (double dt : new double[] {1e-3, DT, 0.5, 100, 1e9}) {
            Unit car = new Unit(1200).setVelocity(20, -15).setMotor(0, 0, 9600); // 8 m/s²
            double steps = 25 / (8 * dt);
            for (int i = 1; i <= Math.min(steps + 2, 5000); i++) {
                car.integrate(dt, integrator);
                assertTrue(car.getVx() >= 0 && car.getVy() <= 0);
                if (i >= steps + 1e-9) assertVelocity(0, 0, car);
            }
            assertVelocity(0, 0, car);
        }
    }

    /** The motor acts after the force: it needs some of its own force against a push sideways. */
    @Test
    void theMotorWorksAgainstForcesAndFriction() {
        Unit unit = new Unit(2).setFriction(1).setVelocity(4, 0).setMotor(0, 0, 6);
        unit.applyForce(0, 8);
        unit.integrate(1); // w = (4 − 2, 4), |w| = √20, reach 3
        double left = 1 - 3 / Math.sqrt(20);
        assertEquals(2 * left, unit.getVx(), 1e-15);
        assertEquals(4 * left, unit.getVy(), 1e-15);
        assertEquals(4, unit.getX());
    }

    @ParameterizedTest
    @EnumSource
    void theTopSpeedLimitsTheMotor(Integrator integrator) {
        Unit unit = new Unit(1).setMaxSpeed(5).setMotor(30, 40, 1000);
        for (int i = 0; i < 10; i++) {
            unit.integrate(1, integrator);
            assertEquals(5, unit.getSpeed());
            assertEquals(3, unit.getVx(), 1e-13, "in the ordered direction");
        }
        assertMotor(30, 40, 1000, unit);
        unit.setMotor(-5, 0, 1e6);
        unit.integrate(1, integrator);
        assertVelocity(-5, 0, unit);
        unit.setMaxSpeed(0);
        for (int i = 0; i < 3; i++) unit.integrate(1, integrator);
        assertVelocity(0, 0, unit);
    }

    // Dry friction

    static Stream<Arguments> rates() {
        return Arrays.stream(Integrator.values())
                .flatMap(integrator -> IntStream.of(10, 15, 24, 30, 50, 60, 100, 144, 240, 500, 1000)
                        .mapToObj(rate -> Arguments.of(integrator, rate)));
    }

    /** R = µ m g: at rest after v/(µ g), to within one step, v²/(2 µ g) away, to within v dt. */
    @ParameterizedTest
    @MethodSource("rates")
    void dryFrictionStopsASlidingUnitAtTheExpectedTimeAndPlace(Integrator integrator, int rate) {
        double dt = 1.0 / rate;
        for (double deceleration : new double[] {0.02 * 9.81, 0.6 * 9.81, 30}) {
            for (double v : new double[] {0.1, 3, 12.5, 40}) {
                World world = new World(integrator, Timestep.fixed(rate));
                Unit crate = world.add(new Unit(70)).setVelocity(0.6 * v, -0.8 * v);
                crate.setMotor(0, 0, 70 * deceleration);
                int steps = 0;
                for (; crate.getSpeed() > 0 && steps * dt <= 2 * v / deceleration; steps++) world.step();
                assertEquals(v / deceleration, steps * dt, dt * (1 + 1e-9));
                double distance = Math.hypot(crate.getX(), crate.getY());
                assertEquals(v * v / (2 * deceleration), distance, v * dt * (1 + 1e-9));
                double x = crate.getX(), y = crate.getY();
                for (int i = 0; i < rate; i++) world.step();
                assertEquals(x, crate.getX());
                assertEquals(y, crate.getY());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("rates")
    void aForceBelowDryFrictionMovesNothingAndOneAboveItAcceleratesByTheDifference(Integrator integrator, int rate) {
        double dt = 1.0 / rate, most = 0.6 * 9.81 * 70;
        World world = new World(integrator, Timestep.fixed(rate));
        for (int degrees = 0; degrees < 360; degrees += 15) {
            world.add(new Unit(70)).setPosition(degrees, 1).setMotor(0, 0, most);
        }
        for (int i = 0; i < 100; i++) {
            push(world, most * (1 - 1e-12));
            world.step();
            for (Unit unit : world) {
                assertEquals((unit.getId() - 1) * 15.0, unit.getX());
                assertEquals(1, unit.getY());
                assertVelocity(0, 0, unit);
            }
        }
        for (int i = 1; i <= 100; i++) {
            push(world, 1.001 * most);
            world.step();
            double v = i * dt * 0.001 * most / 70;
            for (Unit unit : world) assertEquals(v, unit.getSpeed(), 1e-12 * v);
        }
    }

    /** Applies a force to each unit, in a direction that depends on its index. */
    private static void push(World world, double force) {
        for (Unit unit : world) {
            double angle = Math.toRadians((unit.getId() - 1) * 15.0);
            unit.applyForce(force * Math.cos(angle), force * Math.sin(angle));
        }
    }

    @ParameterizedTest
    @EnumSource
    void aConveyorMovesACrateAtItsSpeedAndIceBrakesOnlySlightly(Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(60));
        Unit crate = world.add(new Unit(10)).setMotor(2, 0, 0.6 * 9.81 * 10);
        Unit skater = world.add(new Unit(80)).setVelocity(5, 0).setMotor(0, 0, 0.004 * 9.81 * 80);
        for (int i = 0; i < 120; i++) world.step();
        assertVelocity(2, 0, crate);
        assertEquals(5 - 2 * 0.004 * 9.81, skater.getVx(), 1e-12);
    }

    // The motor and the rest of the state

    @Test
    void aMotorIsOffUntilItIsSetAndStaysOnUntilItIsSetAgain() {
        Unit unit = new Unit(1);
        assertMotor(0, 0, 0, unit);
        unit.setVelocity(1, 2).integrate(1);
        assertVelocity(1, 2, unit);
        unit.setMotor(3, -4, 0.5).applyForce(7, 8);
        unit.clearForces();
        assertMotor(3, -4, 0.5, unit);
        assertEquals(0, unit.getFx());
        unit.integrate(0);
        assertVelocity(1, 2, unit);
        unit.setMotor(3, -4, 0);
        unit.integrate(1);
        assertVelocity(1, 2, unit);
        assertMotor(3, -4, 0, unit);
    }

    /** It is treated as by setVelocity, but the top speed does not reduce it. */
    @Test
    void theOrderedVelocityCanBeAnyFiniteOne() {
        Unit unit = new Unit(1).setMaxSpeed(2);
        assertMotor(30, -40, 1e50, unit.setMotor(30, -40, 1e50));
        assertMotor(0, 0, Double.MIN_VALUE, unit.setMotor(-0.0, Math.nextDown(Range.REST), Double.MIN_VALUE));
        assertMotor(Range.REST, -Range.REST, 1, unit.setMotor(Range.REST, -Range.REST, 1));
        assertMotor(0, 0, 0, unit.setMotor(Double.MIN_VALUE, -Double.MIN_NORMAL, -0.0));
        assertMotor(Range.FASTEST, 0, 1, unit.setMotor(Double.MAX_VALUE, 1, 1));
        assertMotor(Range.FASTEST, -Range.FASTEST, 1, unit.setMotor(Double.MAX_VALUE, -Double.MAX_VALUE, 1));
        assertMotor(-Range.FASTEST / 4, Range.FASTEST, 1, unit.setMotor(-0x1p1000, 0x1p1002, 1));
        for (double v :
                new double[] {unit.getMotorVx(), unit.setMotor(-0.0, -0.0, -0.0).getMotorVx()}) {
            assertTrue(v < 0 || Double.doubleToRawLongBits(v) == 0, "not −0.0");
        }
        assertEquals(0, Double.doubleToRawLongBits(unit.getMotorForce()));
    }

    @ParameterizedTest
    @EnumSource
    void theMotorOfAFrozenUnitHasNoEffectUntilItsRelease(Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(60));
        Unit unit = world.add(new Unit(1).setVelocity(1, 2)).setMotor(5, 5, 100).setFrozen(true);
        for (int i = 0; i < 40; i++) world.step();
        unit.setMotor(-5, 5, 1e6);
        unit.integrate(1, integrator);
        world.step();
        assertVelocity(1, 2, unit);
        assertEquals(0, unit.getX());
        unit.setFrozen(false);
        world.step();
        assertVelocity(-5, 5, unit);
    }

    @Test
    void aUnitKeepsItsMotorWhenItJoinsOrLeavesAWorldAndWhenTheWorldIsCleared() {
        World world = new World();
        Unit unit = new Unit(1).setMotor(1, 2, 3), other = world.add(new Unit(1));
        world.add(unit);
        assertMotor(1, 2, 3, unit);
        world.remove(other);
        assertMotor(1, 2, 3, unit);
        world.remove(unit);
        assertMotor(1, 2, 3, unit);
        world.add(other);
        world.add(unit).setMotor(4, 5, 6);
        world.clear();
        assertMotor(4, 5, 6, unit);
        assertMotor(0, 0, 0, other);
        unit.integrate(1);
        assertVelocity(4 * 6 / Math.sqrt(41), 5 * 6 / Math.sqrt(41), unit);
        new World().add(unit).getWorld().step(1);
        assertVelocity(4, 5, unit);
    }

    @Test
    void hashDifferenceBytesSaveAndRestoreIncludeTheMotor() {
        World world = new World();
        Unit unit = world.add(new Unit(1).setVelocity(1, 1)), other = world.add(new Unit(2));
        Set<Long> hashes = new HashSet<>(Set.of(world.stateHash()));
        Snapshot off = world.save();
        unit.setMotor(5, -6, 7);
        assertTrue(hashes.add(world.stateHash()));
        Snapshot on = world.save();
        assertEquals("""
                unit 1 motorVx: 0x0.0p0 (0.0) | 0x1.4p2 (5.0)
                unit 1 motorVy: 0x0.0p0 (0.0) | -0x1.8p2 (-6.0)
                unit 1 motorForce: 0x0.0p0 (0.0) | 0x1.cp2 (7.0)
                """, off.difference(on));
        for (double[] motor : new double[][] {{5, -6, 0}, {5, 0, 7}, {0, -6, 7}, {5, 0, 0}, {0, -6, 0}, {0, 0, 7}}) {
            unit.setMotor(motor[0], motor[1], motor[2]);
            assertTrue(hashes.add(world.stateHash()), () -> Arrays.toString(motor));
        }
        world.step(0.1);
        world.restore(off);
        assertMotor(0, 0, 0, unit);
        world.restore(on);
        assertMotor(5, -6, 7, unit);
        assertMotor(0, 0, 0, other);
        World copy = new World();
        copy.restore(Snapshot.fromBytes(on.toBytes()));
        assertMotor(5, -6, 7, copy.get(0));
        for (int i = 0; i < 50; i++) {
            assertEquals(world.stateHash(), copy.stateHash());
            for (World each : List.of(world, copy)) each.step(0.1);
        }
        assertVelocity(5, -6, copy.get(0));
    }

    /** The table keeps a flag for tiles that may have motors. It must not change any result. */
    @Test
    void aMotorThatWasOnHasNoEffectAfterItIsOff() {
        for (double left : new double[] {0, 3}) {
            World never = new World(), once = new World();
            for (World world : List.of(never, once)) {
                for (int i = 0; i < 3; i++) world.add(new Unit(1)).setMotor(i == 0 ? left : 0, 0, 0);
            }
            once.get(1).setMotor(9, 9, 9).setMotor(0, 0, 0);
            once.remove(once.add(new Unit(1).setMotor(1, 1, 1)));
            never.remove(never.add(new Unit(1)));
            World read = new World();
            for (int i = 0; i < 40; i++) {
                assertEquals(never.stateHash(), once.stateHash(), "step " + i);
                read.restore(Snapshot.fromBytes(never.save().toBytes()));
                assertEquals(never.stateHash(), read.stateHash(), "step " + i);
                for (World world : List.of(never, once)) {
                    if (i % 2 == 0) world.get(2).applyForce(1, 0);
                    world.step();
                }
            }
        }
    }

    // A world

    /** Rows move within and between tiles as units join and leave; the motor must move with its row. */
    @ParameterizedTest
    @EnumSource
    void unitsInAWorldThatOthersJoinAndLeaveHaveTheBitsOfUnitsAlone(Integrator integrator) {
        for (int size : Tiles.sizes()) {
            if (size < 1) continue;
            SplittableRandom random = new SplittableRandom(size);
            World world = new World(integrator, Timestep.variable(0.1));
            List<Unit> alone = new ArrayList<>();
            for (int i = 0; i < 8; i++) {
                while (world.size() < size) {
                    long draw = random.nextLong();
                    world.add(unit(draw));
                    alone.add(unit(draw));
                }
                for (int k = 0; k < size; k += 1 + random.nextInt(9)) {
                    double fx = random.nextDouble(-9, 9),
                            vx = random.nextDouble(-9, 9),
                            most = random.nextDouble(-9, 9);
                    for (Unit unit : List.of(world.get(k), alone.get(k))) {
                        unit.setMotor(vx, unit.getMotorVy(), Math.max(0, most));
                        unit.applyForce(fx, 1);
                    }
                }
                for (int steps = 0; steps < 3; steps++) {
                    world.step(0.05);
                    for (Unit unit : alone) unit.integrate(0.05, integrator);
                }
                for (int k = 0; k < size; k++) assertSameButForId(alone.get(k), world.get(k));
                for (int leave = random.nextInt(4); leave > 0 && world.size() > 0; leave--) {
                    int k = random.nextInt(world.size());
                    world.remove(world.get(k));
                    Unit last = alone.remove(alone.size() - 1);
                    if (k < alone.size()) alone.set(k, last);
                }
            }
        }
    }

    /** The flags of tiles with motors must survive the growth of the arrays and a restore. */
    @Test
    void aMotorActsAfterTheWorldHasGrownAndAfterARestore() {
        World world = new World();
        Unit unit = world.add(new Unit(1)).setMotor(0, 5, 60);
        for (int i = 0; i < 4 * Tiles.TILE; i++) world.add(new Unit(1));
        Snapshot before = world.save();
        world.step();
        assertEquals(1, unit.getVy());
        for (Snapshot snapshot : List.of(before, Snapshot.fromBytes(before.toBytes()))) {
            World other = new World();
            other.restore(snapshot);
            other.step();
            assertEquals(1, other.get(0).getVy());
        }
        Unit last = world.get(world.size() - 1).setMotor(0, -5, 60);
        world.remove(world.get(Tiles.TILE));
        world.step();
        assertEquals(-1, last.getVy(), "in a tile that had no motors before");
    }

    private static Unit unit(long draw) {
        SplittableRandom random = new SplittableRandom(draw);
        Unit unit = new Unit(random.nextDouble(0.1, 9)).setFriction(Math.max(0, random.nextDouble(-1, 9)));
        unit.setVelocity(random.nextDouble(-9, 9), random.nextDouble(-9, 9));
        if (random.nextInt(3) == 0) unit.setMaxSpeed(random.nextDouble(0, 9));
        boolean brake = random.nextInt(3) == 0;
        if (random.nextInt(4) > 0) unit.setMotor(brake ? 0 : random.nextDouble(-9, 9), 0, random.nextDouble(0, 90));
        return unit.setFrozen(random.nextInt(9) == 0);
    }

    private static void assertSameButForId(Unit expected, Unit actual) {
        List<Long> a = Churn.kept(expected), b = Churn.kept(actual);
        assertEquals(a.subList(1, a.size()), b.subList(1, b.size()));
        assertMotor(expected.getMotorVx(), expected.getMotorVy(), expected.getMotorForce(), actual);
    }

    @ParameterizedTest
    @EnumSource
    void severalThreadsGiveTheSameBits(Integrator integrator) {
        ForkJoinPool pool = new ForkJoinPool(3);
        try {
            World one = new World(integrator, Timestep.fixed(60)), several = new World(integrator, Timestep.fixed(60));
            for (int i = 0; i < 3 * Tiles.SHARE + 100; i++) {
                one.add(unit(i));
                several.add(unit(i));
            }
            several.setPool(pool);
            for (int i = 0; i < 6 || (i < 1000 && pool.getStealCount() == 0); i++) {
                for (World world : List.of(one, several)) {
                    for (int k = i; k < world.size(); k += 11) world.get(k).setMotor(i - k % 7, 1, k % 90);
                    world.advance(0.03);
                }
                assertEquals(one.stateHash(), several.stateHash());
            }
            assertTrue(pool.getStealCount() > 0);
        } finally {
            pool.shutdown();
        }
    }

    /** A motor that is set in a listener acts from the next step on, and in every step of a frame. */
    @Test
    void aMotorThatIsSetInAListenerActsInTheNextStep() {
        World world = new World(Integrator.EULER, Timestep.fixed(8)); // so that all numbers are exact
        Unit unit = world.add(new Unit(1));
        world.addBeforeStep((w, dt) -> {
            if (w.getTick() == 0) unit.setMotor(1, 0, 2);
        });
        world.addAfterStep((w, dt) -> {
            if (w.getTick() == 2) unit.setMotor(0, 0, 1);
        });
        for (double vx : new double[] {0.25, 0.5}) {
            assertEquals(1, world.advance(0.125));
            assertVelocity(vx, 0, unit);
        }
        for (double vx : new double[] {0.25, 0}) {
            assertEquals(2, world.advance(0.25));
            assertVelocity(vx, 0, unit);
        }
        assertEquals(0.125 * (0.25 + 0.5 + 0.375 + 0.25 + 0.125), unit.getX());
    }
}
