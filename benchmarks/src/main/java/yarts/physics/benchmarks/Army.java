package yarts.physics.benchmarks;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * The initial units of every benchmark and every peer: masses of 1 to 11 kg, frictions of 0 to 5 N·s/m, top speeds of 5
 * to 6 m/s, velocity components of −5 to 5 m/s, positions (0, 0). The numbers are the same in every run.
 */
final class Army {
    final int size;
    final double[] mass, friction, maxSpeed, vx, vy;

    private Army(int size) {
        this.size = size;
        mass = new double[size];
        friction = new double[size];
        maxSpeed = new double[size];
        vx = new double[size];
        vy = new double[size];
    }

    static Army of(int size) {
        Army army = new Army(size);
        Random random = new Random(1);
        for (int i = 0; i < size; i++) {
            army.mass[i] = 1 + 10 * random.nextDouble();
            army.friction[i] = 5 * random.nextDouble();
            army.maxSpeed[i] = 5 + random.nextDouble();
            army.vx[i] = 10 * random.nextDouble() - 5;
            army.vy[i] = 10 * random.nextDouble() - 5;
        }
        return army;
    }

    /** The same units without a top speed, for peers that have none. */
    Army uncapped() {
        Army army = Army.of(size);
        Arrays.fill(army.maxSpeed, Double.POSITIVE_INFINITY);
        return army;
    }

    Unit unit(int i) {
        return new Unit(mass[i])
                .setFriction(friction[i])
                .setMaxSpeed(maxSpeed[i])
                .setVelocity(vx[i], vy[i]);
    }

    World world(Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(60));
        for (int i = 0; i < size; i++) world.add(unit(i));
        return world;
    }

    /**
     * Restores the initial velocity of every unit once in 1,000 steps. Call it before each step with few forces or
     * none: otherwise friction stops the units during a benchmark, which simulates hours of a game.
     */
    void keepMoving(World world) {
        if (world.getTick() % 1000 != 0) return;
        for (int i = 0; i < size; i++) world.get(i).setVelocity(vx[i], vy[i]);
    }

    /** One in a thousand of a world's units, but at least one. They are scattered, and the same in every run. */
    static List<Unit> oneInAThousand(World world) {
        return shuffled(world.size()).stream()
                .limit(Math.max(1, world.size() / 1000))
                .map(world::get)
                .collect(Collectors.toList());
    }

    /** The numbers 0 to size − 1 in random order, which is the same in every run. */
    static List<Integer> shuffled(int size) {
        List<Integer> order = new ArrayList<>(size);
        for (int i = 0; i < size; i++) order.add(i);
        Collections.shuffle(order, new Random(2));
        return order;
    }
}
