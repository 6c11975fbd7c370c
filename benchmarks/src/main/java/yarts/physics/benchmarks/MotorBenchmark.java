package yarts.physics.benchmarks;

import java.util.Random;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The cost of motors: steps without motors and with a motor on every unit, compared with the cost of the speed cap
 * alone.
 */
public class MotorBenchmark extends Workload {
    private static final int TILE = 512; // rows

    /**
     * Ordered velocity components of −8 to 8 m/s, forces of 0 to 30 N: some units reach their order, and some are
     * capped.
     */
    private static final double SPEED = 8, FORCE = 30;

    @Param({"1000", "10000", "100000", "1000000"})
    public int units;

    @Param({"EULER", "EXACT"})
    public Integrator integrator;

    private Army army;
    private World plain, motored, parked;
    private double[] forces, vx, vy, cap;

    @Setup
    public void create() {
        Random random = new Random(5);
        army = Army.of(units);
        plain = army.world(integrator);
        motored = army.world(integrator);
        for (Unit unit : motored) unit.setMotor(speed(random), speed(random), FORCE * random.nextDouble());
        parked = army.world(integrator);
        for (Unit unit : parked) unit.setMotor(0, 0, FORCE);
        forces = forces(units);
        vx = new double[units + 8];
        vy = new double[units + 8];
        cap = new double[units + 8];
        for (int i = 0; i < units; i++) {
            vx[i] = army.vx[i];
            vy[i] = army.vy[i];
            cap[i] = army.maxSpeed[i];
        }
        collect();
    }

    private static double speed(Random random) {
        return SPEED * (2 * random.nextDouble() - 1);
    }

    /** No forces and no motors. */
    @Benchmark
    public void step() {
        army.keepMoving(plain);
        plain.step(DT);
    }

    /** A force on every unit and a step, without motors. */
    @Benchmark
    public void both() {
        plain.applyForces(forces, 0);
        plain.step(DT);
    }

    /** The same, and a motor on every unit. */
    @Benchmark
    public void bothWithMotors() {
        motored.applyForces(forces, 0);
        motored.step(DT);
    }

    /** A motor on every unit, and no forces. */
    @Benchmark
    public void stepWithMotors() {
        motored.step(DT);
    }

    /** Every unit stands with its brake on, so all tiles are asleep. */
    @Benchmark
    public void parked() {
        parked.step(DT);
    }

    /** A new order to every unit. */
    @Benchmark
    public void setMotor() {
        for (Unit unit : motored) unit.setMotor(unit.getMotorVy(), unit.getMotorVx(), unit.getMotorForce());
    }

    /** The cost of the speed cap in a step: the loop of the library, over similar arrays and tiles. */
    @Benchmark
    public void cap() {
        for (int start = 0; start < units; start += TILE) cap(vx, vy, cap, start, Math.min(start + TILE, units));
    }

    private static void cap(double[] vx, double[] vy, double[] cap, int start, int end) {
        for (int i = start; i < end; i++) {
            double speed = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]), over = speed - cap[i];
            over = 0.5 * (over + Math.abs(over));
            double left = cap[i] / (over + Math.min(over * 0x1p60, speed * 0x1p-49) + cap[i]);
            vx[i] *= left;
            vy[i] *= left;
        }
    }
}
