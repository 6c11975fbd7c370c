package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/**
 * Without forces, a world leaves out what would change nothing: the cap where nobody is above it, and rest where nobody
 * is slow. Its units move as they do alone, to the bit, where a step leaves nothing out.
 */
class CoastPropertyTest {
    private static final double CALM = Kernel.REST * 0x1p60;

    @Property(tries = 300)
    void leftAloneOrDisturbedItIsAsIfNothingWereLeftOut(@ForAll Integrator how, @ForAll long seed) {
        Random random = new Random(seed);
        Coast coast = new Coast(how, random);
        double dt = random.nextInt(4) == 0 ? 0.9 : 1;
        for (int i = 0; i < 150; i++) {
            if (random.nextInt(40) == 0) dt = random.nextBoolean() ? 1 : 1 + random.nextDouble() / 2;
            if (random.nextInt(30) == 0) coast.disturb(random.nextInt(13));
            coast.step(dt);
        }
    }

    @Property(tries = 100)
    void aVelocityThatHalvesComesToRestAsAlone(@ForAll Integrator how, @ForAll long seed) {
        Random random = new Random(seed);
        Coast coast = new Coast(how, random);
        double decay = random.nextBoolean() ? 0.5 : 0.47;
        double v = CALM * (1 + random.nextInt(3)) * (random.nextBoolean() ? 1 : 1 + Math.ulp(1.0));
        for (Unit[] pair : coast.pairs) {
            for (Unit unit : pair) {
                unit.clearForces();
                unit.setMass(1).setFriction(frictionFor(decay, how)).setVelocity(v, -v);
            }
        }
        for (int i = 0; i < 80; i++) coast.step(1);
        for (Unit[] pair : coast.pairs) assertEquals(0, pair[0].getSpeed());
    }

    /** For a mass of 1 and a dt of 1. */
    private static double frictionFor(double decay, Integrator how) {
        if (how == Integrator.EULER) return 1 - decay;
        return how == Integrator.MIDPOINT ? 2 * (1 - decay) / (1 + decay) : -Math.log(decay);
    }

    /** Rounding may have it that a speed that was capped is above the cap still, and is capped again. */
    @Property(tries = 20)
    void atTopSpeedItMovesAsAlone(@ForAll Integrator how, @ForAll long seed) {
        Random random = new Random(seed);
        Coast coast = new Coast(how, random);
        for (Unit[] pair : coast.pairs) {
            double vx = random.nextGaussian(), vy = random.nextGaussian(), top = random.nextDouble() / 10;
            for (Unit unit : pair) unit.setFriction(0).setMaxSpeed(top).setVelocity(vx, vy);
        }
        for (int i = 0; i < 30; i++) coast.step(1);
    }

    /** A world and its units' twins, which live alone. */
    private static final class Coast {
        private final Integrator how;
        private final Random random;
        private final World world;
        private final Snapshot snapshot = new Snapshot();
        private final List<Unit[]> pairs = new ArrayList<>();

        /** Two blocks of units of which few are odd, or none: else the blocks would never be left in peace. */
        Coast(Integrator how, Random random) {
            this.how = how;
            this.random = random;
            world = new World(how, Timestep.fixed(60));
            double slowest = random.nextBoolean() ? -440 : -20, odd = random.nextInt(4) / 500.0;
            for (int i = 0; i < Columns.BLOCK + 44; i++) {
                double top = 1 + random.nextInt(3);
                double friction = random.nextDouble() / 2;
                double vx = top * velocity(slowest), vy = random.nextInt(5) == 0 ? 0 : top * velocity(slowest);
                boolean isOdd = random.nextDouble() < odd;
                Unit[] pair = {world.add(new Unit(1)), new Unit(1)};
                for (Unit unit : pair)
                    unit.setFriction(friction).setMaxSpeed(top).setVelocity(vx, vy);
                pairs.add(pair);
                if (isOdd) disturb(pair, random.nextInt(9));
            }
        }

        private double velocity(double slowest) {
            return (random.nextBoolean() ? 1 : -1)
                    * Math.scalb(1 + random.nextDouble(), (int) slowest + random.nextInt(20));
        }

        void disturb(int way) {
            Unit[] pair = pairs.get(random.nextInt(pairs.size()));
            if (way < 9) disturb(pair, way);
            else if (way == 9) pair[1].integrate(1, how);
            if (way == 9) pair[0].integrate(1, how);
            if (way == 10) { // an odd one comes to another block, into the gap
                disturb(
                        pairs.stream()
                                .filter(p -> p[0] == world.get(world.size() - 1))
                                .findAny()
                                .get(),
                        random.nextInt(9));
                world.remove(pair[0]);
                world.add(pair[0]);
            }
            if (way == 11) { // as if sent to another machine, with a change
                World other = new World(how, Timestep.fixed(60));
                pairs.replaceAll(each -> new Unit[] {other.add(copy(each[0])), copy(each[0])});
                disturb(random.nextInt(9));
                other.save(snapshot);
                world.clear();
                world.restore(snapshot);
                for (int i = 0; i < pairs.size(); i++) pairs.get(i)[0] = world.get(i);
            }
            if (way == 12) {
                Unit[] made = {world.add(copy(pair[0])), copy(pair[0])};
                pairs.add(made);
                disturb(made, random.nextInt(9));
            }
        }

        private static Unit copy(Unit unit) {
            return new Unit(unit.getMass())
                    .setFriction(unit.getFriction())
                    .setMaxSpeed(unit.getMaxSpeed())
                    .setPosition(unit.getX(), unit.getY())
                    .setVelocity(unit.getVx(), unit.getVy());
        }

        private void disturb(Unit[] pair, int way) {
            double a = random.nextDouble(), vx = velocity(way == 0 ? -500 : 5), vy = velocity(way == 1 ? -500 : 5);
            for (Unit unit : pair) {
                if (way <= 2) unit.setVelocity(vx, vy);
                if (way == 3) unit.setMaxSpeed(a);
                if (way == 4) unit.setFriction(0.4 + a);
                if (way == 5) unit.setMass(0.1 + a);
                if (way == 6) unit.applyForce(vx, vy);
                if (way == 7) unit.applyImpulse(vx, vy);
                if (way == 8)
                    unit.setFriction(0).setVelocity(vx, vy); // over and over at its cap, if rounding has it so
            }
        }

        private static long[] motion(Unit unit) {
            return DoubleStream.of(unit.getX(), unit.getY(), unit.getVx(), unit.getVy())
                    .mapToLong(Double::doubleToRawLongBits)
                    .toArray();
        }

        void step(double dt) {
            world.step(dt);
            for (Unit[] pair : pairs) {
                pair[1].integrate(dt, how);
                assertArrayEquals(motion(pair[1]), motion(pair[0]), () -> pair[1] + " alone, " + pair[0]);
            }
        }
    }
}
