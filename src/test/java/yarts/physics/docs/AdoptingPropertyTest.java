package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** The rules of other games on docs/adopting.md, each beside the calls that replace it. */
class AdoptingPropertyTest {
    private static final int TICKS = 200;

    @Provide
    Arbitrary<Double> factors() {
        return Arbitraries.doubles().between(0.05, 0.999).ofScale(9);
    }

    @Provide
    Arbitrary<Double> positive() {
        return Doubles.logUniform(1e-2, 1e5);
    }

    @Property
    void dragPerTickIsFrictionInEachOrderOfMoveDragAndAcceleration(
            @ForAll boolean movesFirst,
            @ForAll boolean acceleratesFirst,
            @ForAll("factors") double keep,
            @ForAll @IntRange(min = 1, max = 240) int rate,
            @ForAll("positive") double mass,
            @ForAll @DoubleRange(min = -50, max = 50) double a,
            @ForAll @DoubleRange(min = -50, max = 50) double start) {
        Integrator integrator = movesFirst ? Integrator.EULER : Integrator.SEMI_IMPLICIT;
        double friction = movesFirst ? mass * (1 - keep) * rate : mass * (1 / keep - 1) * rate;
        double force = mass * a;
        if (movesFirst && acceleratesFirst) force = keep * mass * a;
        if (!movesFirst && !acceleratesFirst) force = mass * a / keep;
        World world = new World(integrator, Timestep.fixed(rate));
        Unit unit = world.add(new Unit(mass).setFriction(friction).setVelocity(start, 0));
        double x = 0, v = start, farthest = (Math.abs(start) + Math.abs(a) / rate) / rate;
        for (int tick = 0; tick < TICKS; tick++) {
            if (movesFirst) x += v / rate;
            v = acceleratesFirst ? (v + a / rate) * keep : v * keep + a / rate;
            if (!movesFirst) x += v / rate;
            unit.applyForce(force, 0);
            world.step();
            farthest = Math.max(farthest, Math.abs(x));
            assertEquals(x, unit.getX(), 1e-12 * farthest);
        }
    }

    /** Mindustry's rule: x += v·delta, then v *= max(0, 1 − drag·delta), with delta in sixtieths of a second. */
    @Property
    void dragWithFramesOfAnyLengthGivesTheSameMotionAsEuler(
            @ForAll @DoubleRange(min = 0, max = 2) double drag,
            @ForAll("positive") double mass,
            @ForAll Random random) {
        World world = new World(Integrator.EULER, Timestep.variable(1));
        Unit unit = world.add(new Unit(mass).setFriction(60 * mass * drag).setVelocity(3 * 60, 0));
        double x = 0, v = 3;
        for (int frame = 0; frame < TICKS; frame++) {
            double delta = 3 * random.nextDouble();
            x += v * delta;
            v *= Math.max(0, 1 - drag * delta);
            assertEquals(1, world.advance(delta / 60));
            assertEquals(x, unit.getX(), 1e-12 * x);
        }
    }

    @Property
    void aHalfLifeIsTheSameAtEveryTickRate(
            @ForAll("positive") double halfLife,
            @ForAll("positive") double mass,
            @ForAll @IntRange(min = 1, max = 240) int rate) {
        World world = new World(Integrator.EXACT, Timestep.fixed(rate));
        Unit unit = world.add(
                new Unit(mass).setFriction(mass * Math.log(2) / halfLife).setVelocity(8, 0));
        for (int tick = 0; tick < 2 * rate; tick++) world.step();
        double v = 8 * Math.pow(0.5, 2 / halfLife);
        assertEquals(v, unit.getVx(), 1e-10 * v);
        assertEquals((8 - v) * halfLife / Math.log(2), unit.getX(), 1e-10);
    }

    @Property
    void setVelocityGivesRobocodesPositionsToTheBit(@ForAll Integrator integrator, @ForAll Random random) {
        World world = new World(integrator, Timestep.fixed(1));
        Unit unit = world.add(new Unit(1));
        double x = 0, y = 0, v = 0, heading = 0, distance = 400, most = 8;
        for (int turn = 0; turn < TICKS; turn++) {
            if (random.nextInt(20) == 0) {
                distance = random.nextInt(5) == 0 ? Double.NEGATIVE_INFINITY : 400 * (random.nextDouble() - 0.5);
                most = 8 * random.nextDouble();
            }
            heading += 0.2 * (random.nextDouble() - 0.5);
            v = robocode(v, distance, most);
            distance -= v;
            x += v * Math.sin(heading);
            y += v * Math.cos(heading);
            unit.setVelocity(v * Math.sin(heading), v * Math.cos(heading));
            world.step();
            assertEquals(x, unit.getX());
            assertEquals(y, unit.getY());
        }
        assertTrue(x != 0 && y != 0);
    }

    @Property
    void aMotorGivesRobocodesVelocityExceptInTurnsInWhichTheRobotReverses(@ForAll Random random) {
        Unit unit = new Unit(1);
        double x = 0, v = 0, order = 0;
        int same = 0;
        for (int turn = 0; turn < TICKS; turn++) {
            if (random.nextInt(10) == 0) order = random.nextInt(17) - 8;
            double old = v;
            v = robocode(v, order == 0 ? 0 : order / 0.0, Math.abs(order));
            x += v;
            unit.setMotor(order, 0, (order - old) * old < 0 ? 2 : 1).integrate(1, Integrator.SEMI_IMPLICIT);
            boolean reverses = old * order < 0 && Math.abs(old) < 2;
            if (!reverses) {
                assertEquals(v, unit.getVx(), 1e-12);
                assertEquals(x, unit.getX(), 1e-9);
                same++;
            }
            unit.setVelocity(v, 0).setPosition(x, 0);
        }
        assertTrue(same > TICKS / 2);
    }

    /**
     * The velocity of a Robocode robot in the next turn: it accelerates by 1 pixel/turn² and brakes by 2, so that it
     * stops at the distance. If it reverses in a turn, it brakes in a part of the turn and accelerates in the rest.
     */
    private static double robocode(double v, double distance, double most) {
        if (distance < 0) return -robocode(-v, -distance, most);
        double goal = most;
        if (distance < Double.POSITIVE_INFINITY) {
            double turns = Math.max(1, Math.ceil((Math.sqrt(4 * distance + 1) - 1) / 2));
            goal = Math.min(2 * (turns - 1) + (distance - turns * (turns - 1)) / turns, most);
        }
        if (v >= 0) return Math.max(v - 2, Math.min(goal, v + 1));
        double braking = Math.min(1, -v / 2); // the part of the turn in which it brakes
        return Math.max(v - 1, Math.min(goal, v + 2 * braking + (1 - braking)));
    }
}
