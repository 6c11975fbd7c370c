package yarts.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import yarts.physics.Copies;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * A step omits work that would change nothing: in a tile without forces, the cap and the forces; in a tile in which no
 * unit moves either, everything. Units move in a world as they move alone, to the bit, where a step omits nothing.
 */
class CoastPropertyTest {
    private static final double CALM = Range.REST * 0x1p60;

    /** In a step of any length that this test uses, except 0, this friction stops a mass of 1. */
    private static final double BRAKE = 1e9;

    private static final double FRAME = 0.05; // s: three steps, exactly

    @Property(tries = 150)
    void unitsInPushedCoastingAndSleepingTilesMoveAsAlone(@ForAll Integrator integrator, @ForAll long seed) {
        Random random = new Random(seed);
        int tiles = 1 + random.nextInt(3);
        play(new Coast(integrator, random, tiles * Tiles.TILE - 20 + random.nextInt(40)), 60);
    }

    @Property(tries = 8)
    void unitsInTheLastRowsOfATableMoveAsAlone(@ForAll Integrator integrator, @ForAll long seed) {
        Random random = new Random(seed);
        play(new Coast(integrator, random, 3 * Tiles.TILE - 2 + random.nextInt(5)), 40);
        play(new Coast(integrator, random, 4 * Tiles.TILE - 2 + random.nextInt(5)), 40);
    }

    private static void play(Coast coast, int steps) {
        Random random = coast.random;
        double dt = 1;
        for (int i = 0; i < steps; i++) {
            if (random.nextInt(20) == 0) dt = new double[] {1, 0.5 + random.nextDouble(), 0}[random.nextInt(3)];
            for (int orders = random.nextInt(3); orders > 0 && i % 8 > 4; orders--) coast.order(random.nextInt(17));
            if (i % 3 != 2) coast.push(); // no forces in every third step
            if (random.nextInt(6) == 0) coast.frame();
            else coast.step(dt);
        }
    }

    @Property(tries = 100)
    void aVelocityThatHalvesComesToRestAsAlone(@ForAll Integrator integrator, @ForAll long seed) {
        Random random = new Random(seed);
        Coast coast = new Coast(integrator, random, Tiles.TILE + 44);
        double decay = random.nextBoolean() ? 0.5 : 0.47;
        double v = CALM * (1 + random.nextInt(3)) * (random.nextBoolean() ? 1 : 1 + Math.ulp(1.0));
        double friction = frictionFor(decay, integrator);
        for (Twin twin : coast.twins) {
            twin.change(u -> u.setFrozen(false).setMass(1).setFriction(friction).setMaxSpeed(9));
            twin.change(u -> u.setVelocity(v, -v));
        }
        for (int i = 0; i < 80; i++) coast.step(1);
        for (Twin twin : coast.twins) assertEquals(0, twin.unit.getSpeed());
    }

    /** For a mass of 1 and a dt of 1. */
    private static double frictionFor(double decay, Integrator integrator) {
        if (integrator == Integrator.EULER) return 1 - decay;
        if (integrator == Integrator.SEMI_IMPLICIT) return 1 / decay - 1;
        return integrator == Integrator.MIDPOINT ? 2 * (1 - decay) / (1 + decay) : -Math.log(decay);
    }

    /** A step of a coasting tile omits the cap: a speed that was reduced must not exceed the cap afterwards. */
    @Property(tries = 20)
    void unitsAtTheirTopSpeedMoveAsAlone(@ForAll Integrator integrator, @ForAll long seed) {
        Random random = new Random(seed);
        Coast coast = new Coast(integrator, random, Tiles.TILE + 44);
        for (Twin twin : coast.twins) {
            double vx = random.nextGaussian(), vy = random.nextGaussian(), top = random.nextDouble() / 10;
            twin.change(u -> u.setFriction(0).setMaxSpeed(top).setVelocity(vx, vy));
        }
        for (int i = 0; i < 30; i++) coast.step(1);
    }

    /** A unit in a world, and an equal one outside a world. */
    private static final class Twin {
        Unit unit, alone;
        /** The force that was applied to both. It is applied to the unit outside again for each step of a frame. */
        double fx, fy;
        /** The position before the last step. */
        double previousX, previousY;

        Twin(Unit unit, Unit alone) {
            this.unit = unit;
            this.alone = alone;
            settle();
        }

        void settle() {
            previousX = alone.getX();
            previousY = alone.getY();
        }

        void change(Consumer<Unit> change) {
            change.accept(unit);
            change.accept(alone);
        }

        void applyForce(double fx, double fy) {
            unit.applyForce(fx, fy);
            note(fx, fy);
        }

        void note(double fx, double fy) {
            this.fx += fx;
            this.fy += fy;
        }

        void forget() {
            fx = fy = 0;
        }

        void step(double dt, Integrator integrator) {
            settle();
            alone.applyForce(fx, fy);
            alone.integrate(dt, integrator);
        }

        void compare() {
            same("x", alone.getX(), unit.getX());
            same("y", alone.getY(), unit.getY());
            same("vx", alone.getVx(), unit.getVx());
            same("vy", alone.getVy(), unit.getVy());
            same("fx", 0, unit.getFx());
            same("fy", 0, unit.getFy());
            same("x before", previousX, unit.getInterpolatedX(0));
            same("y before", previousY, unit.getInterpolatedY(0));
            same("x half way", previousX + (alone.getX() - previousX) * 0.5, unit.getInterpolatedX(0.5));
            same("y half way", previousY + (alone.getY() - previousY) * 0.5, unit.getInterpolatedY(0.5));
            same("x after", alone.getX(), unit.getInterpolatedX(1));
            same("y after", alone.getY(), unit.getInterpolatedY(1));
        }

        private void same(String what, double expected, double actual) {
            if (Double.doubleToRawLongBits(expected) != Double.doubleToRawLongBits(actual)) {
                throw new AssertionError(
                        what + ": alone " + expected + ", in the world " + actual + " of " + unit.getId());
            }
        }

        /** The same unit of the world, with a copy of the unit outside. */
        Twin copy() {
            Twin copy = new Twin(unit, Copies.of(alone));
            copy.previousX = previousX;
            copy.previousY = previousY;
            return copy;
        }
    }

    /** A world, and the twins of its units in the same order. */
    private static final class Coast {
        private final Integrator integrator;
        private final Random random;
        private World world;
        private List<Twin> twins = new ArrayList<>();
        private final Snapshot snapshot = new Snapshot();
        private List<Twin> saved;

        /**
         * In each tile no unit moves, or one, some or all do. In some tiles all units brake, and are soon at rest
         * again.
         */
        Coast(Integrator integrator, Random random, int units) {
            this.integrator = integrator;
            this.random = random;
            world = new World(integrator, Timestep.fixed(60));
            double share = 0;
            boolean brakes = false;
            for (int i = 0; i < units; i++) {
                if (i % Tiles.TILE == 0) share = new double[] {0, 1.0 / Tiles.TILE, 0.5, 1}[random.nextInt(4)];
                if (i % Tiles.TILE == 0) brakes = random.nextBoolean();
                add(random.nextDouble() < share);
                if (brakes) twins.get(i).change(u -> u.setFriction(BRAKE));
            }
            save();
        }

        private void add(boolean moving) {
            double x = coordinate(), y = coordinate(), vx = coordinate(), vy = coordinate();
            double top = 1 + random.nextInt(3), friction = random.nextDouble() / 2, mass = 0.5 + random.nextDouble();
            Twin twin = new Twin(new Unit(mass), new Unit(mass));
            twin.change(u -> u.setPosition(x, y).setFriction(friction).setMaxSpeed(top));
            if (moving) twin.change(u -> u.setVelocity(vx, vy));
            twin.settle();
            world.add(twin.unit);
            twins.add(twin);
        }

        private double coordinate() {
            return 4 * random.nextGaussian();
        }

        private void save() {
            world.save(snapshot);
            saved = copies();
        }

        private List<Twin> copies() {
            List<Twin> copies = new ArrayList<>();
            for (Twin twin : twins) copies.add(twin.copy());
            return copies;
        }

        /** Pushes no unit, one, two or all of each tile, at random; or all units in one call, some of them with 0 N. */
        void push() {
            if (random.nextInt(12) == 0) {
                pushAll();
                return;
            }
            for (int start = 0; start < twins.size(); start += Tiles.TILE) {
                int rows = Math.min(Tiles.TILE, twins.size() - start);
                int way = random.nextInt(8);
                int pushed = way < 5 ? 0 : way < 6 ? 1 : way < 7 ? 2 : rows;
                for (int i = 0; i < pushed; i++) {
                    int row = pushed == rows ? i : random.nextInt(4) == 0 ? rows - 1 : random.nextInt(rows);
                    twins.get(start + row).applyForce(coordinate(), coordinate());
                }
            }
        }

        private void pushAll() {
            double[] xy = new double[2 * twins.size()];
            boolean all = random.nextBoolean();
            for (int i = 0; i < twins.size(); i++) {
                if (!all && i % 7 != 0) continue;
                xy[2 * i] = coordinate();
                xy[2 * i + 1] = coordinate();
                twins.get(i).note(xy[2 * i], xy[2 * i + 1]);
            }
            world.applyForces(xy, 0);
        }

        /** Makes one of the changes that may wake a tile or change its coefficients. */
        void order(int way) {
            if (twins.isEmpty()) return;
            int i = random.nextInt(5) == 0 ? twins.size() - 1 : random.nextInt(twins.size());
            Twin twin = twins.get(i);
            double a = coordinate(), b = coordinate();
            switch (way) {
                case 0:
                    twin.change(u -> u.setVelocity(a, b));
                    break;
                case 1:
                    twin.change(u -> u.setPosition(a, b));
                    twin.settle();
                    break;
                case 2:
                    twin.change(u -> u.setMass(0.5 + Math.abs(a)));
                    break;
                case 3:
                    twin.change(u -> u.setFriction(0.2 * Math.abs(a)));
                    break;
                case 4:
                    twin.change(u -> u.setMaxSpeed(a < -4 ? 0 : Math.abs(a)));
                    break;
                case 5:
                    twin.change(u -> u.applyImpulse(a, b));
                    break;
                case 6:
                    twin.change(u -> u.setFrozen(true));
                    break;
                case 7:
                    for (Twin each : twins) each.change(u -> u.setFrozen(false));
                    break;
                case 8:
                case 9:
                    remove(i);
                    break;
                case 10:
                    add(random.nextBoolean());
                    break;
                case 11: // removed, and added again as the last
                    remove(i);
                    world.add(twin.unit);
                    twin.settle();
                    twins.add(twin);
                    break;
                case 12:
                    save();
                    break;
                case 13:
                    twins = saved;
                    world.restore(snapshot);
                    saved = copies();
                    break;
                case 14:
                    moveByBytes();
                    break;
                case 15:
                    twin.change(u -> u.integrate(1, integrator));
                    twin.settle();
                    break;
                default: // a tile brakes, and sleeps in the next step
                    int start = i / Tiles.TILE * Tiles.TILE;
                    for (int k = start; k < Math.min(twins.size(), start + Tiles.TILE); k++) {
                        twins.get(k).change(u -> u.setMass(1).setFriction(BRAKE));
                    }
            }
        }

        /** The last unit takes the row, from another tile if there are several. */
        private void remove(int i) {
            world.remove(twins.get(i).unit);
            Twin last = twins.remove(twins.size() - 1);
            if (i < twins.size()) twins.set(i, last);
        }

        /** Restores the world from bytes, as on another machine. */
        private void moveByBytes() {
            byte[] bytes = world.save().toBytes();
            world = new World();
            world.restore(Snapshot.fromBytes(bytes));
            for (int i = 0; i < twins.size(); i++) twins.get(i).unit = world.get(i);
            save();
        }

        void step(double dt) {
            world.step(dt);
            for (Twin twin : twins) twin.step(dt, integrator);
            compare();
        }

        /** Several steps with the same forces. */
        void frame() {
            int n = world.advance(FRAME);
            assertEquals(3, n);
            for (Twin twin : twins) for (int i = 0; i < n; i++) twin.step(1.0 / 60, integrator);
            compare();
        }

        private void compare() {
            for (Twin twin : twins) {
                twin.forget();
                twin.compare();
            }
        }
    }
}
