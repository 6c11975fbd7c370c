package game;

import com.badlogic.gdx.ai.GdxAI;
import com.badlogic.gdx.ai.steer.Limiter;
import com.badlogic.gdx.ai.steer.Steerable;
import com.badlogic.gdx.ai.steer.SteerableAdapter;
import com.badlogic.gdx.ai.steer.SteeringAcceleration;
import com.badlogic.gdx.ai.steer.SteeringBehavior;
import com.badlogic.gdx.ai.steer.behaviors.Arrive;
import com.badlogic.gdx.ai.steer.behaviors.BlendedSteering;
import com.badlogic.gdx.ai.steer.behaviors.Separation;
import com.badlogic.gdx.ai.steer.limiters.FullLimiter;
import com.badlogic.gdx.ai.steer.proximities.RadiusProximity;
import com.badlogic.gdx.math.Vector2;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A company drives to its camp, steered by gdx-ai: all tanks arrive, none overlap, and then all are at rest. */
public final class Game {
    private static final int RATE = 60;
    private static final double MASS = 40_000, FRICTION = 8_000; // kg, N·s/m
    private static final float TOP_SPEED = 15; // m/s
    private static final float SLOW_DOWN = 40; // m: from there on the speed to have is in proportion to the distance
    private static final float REACTION = 0.5f; // s, to get to the speed to have
    private static final float DECAY = 30; // m³/s²: neighbours at the distance r part with DECAY/r²
    private static final Limiter LIMITER = new FullLimiter(12, TOP_SPEED, 0, 0);
    private static final Vector2 CAMP = new Vector2(120, 40); // m

    private final World world = new World(Integrator.EXACT, Timestep.fixed(RATE));
    private final Map<Unit, SteeringBehavior<Vector2>> behaviours = new LinkedHashMap<>();
    private final SteeringAcceleration<Vector2> steering = new SteeringAcceleration<>(new Vector2());
    private int reversals;

    public static void main(String[] args) {
        new Game(1).arrive();
        new Game(12).settle();
    }

    private Game(int tanks) {
        List<Steerable<Vector2>> group = new ArrayList<>();
        for (int i = 0; i < tanks; i++) {
            // Not in a perfect square, whose symmetry would remain.
            Unit unit = new Unit(MASS).setFriction(FRICTION).setPosition(4 * (i % 4), 3 * (i / 4) + 0.5 * (i % 3));
            group.add(Steered.steerable(world.add(unit)));
        }
        for (int i = 0; i < tanks; i++) behaviours.put(world.get(i), behaviour(group.get(i), group));
        world.addBeforeStep((w, dt) -> steer(dt));
    }

    private static SteeringBehavior<Vector2> behaviour(Steerable<Vector2> self, List<Steerable<Vector2>> group) {
        Arrive<Vector2> arrive = new Arrive<>(self, new SteerableAdapter<>() {
            @Override
            public Vector2 getPosition() {
                return CAMP;
            }
        });
        Separation<Vector2> separation = new Separation<>(self, new RadiusProximity<>(self, group, 60));
        arrive.setLimiter(LIMITER).setTimeToTarget(REACTION).setDecelerationRadius(SLOW_DOWN);
        separation.setLimiter(LIMITER).setDecayCoefficient(DECAY);
        return new BlendedSteering<>(self).setLimiter(LIMITER).add(arrive, 1).add(separation, 1);
    }

    private void steer(double dt) {
        GdxAI.getTimepiece().update((float) dt); // gdx-ai looks for neighbours once for each of its times
        behaviours.forEach((unit, behaviour) -> {
            Vector2 a = behaviour.calculateSteering(steering).linear;
            unit.applyForce(MASS * a.x, MASS * a.y);
        });
    }

    /** Advances by whole seconds, and counts the steps in which a tank reverses. */
    private void play(int seconds) {
        double[] vx = new double[world.size()], vy = new double[world.size()];
        for (int tick = 0; tick < seconds * RATE; tick++) {
            for (int i = 0; i < vx.length; i++) {
                vx[i] = world.get(i).getVx();
                vy[i] = world.get(i).getVy();
            }
            require(world.advance(1.0 / RATE) == 1, "a step a frame");
            for (int i = 0; i < vx.length; i++) {
                Unit unit = world.get(i);
                boolean moves = unit.getSpeed() > 1e-3; // less is the rounding of gdx-ai's floats
                if (moves && vx[i] * unit.getVx() + vy[i] * unit.getVy() < 0) reversals++;
            }
        }
    }

    /** dv/dt = (u − v)/τ − f/m v tends to u/(1 + f τ/m): the speed of a tank far from its goal. */
    private void arrive() {
        Unit unit = world.get(0);
        play(6);
        require(distance(unit) > SLOW_DOWN, "it is under way");
        near(TOP_SPEED / (1 + FRICTION / MASS * REACTION), unit.getSpeed(), 1e-2, "its speed on the way");
        play(54);
        near(0, distance(unit), 1e-3, "it arrives");
        near(0, unit.getSpeed(), 1e-4, "it rests");
        require(reversals == 0, "and never drove back");
    }

    /**
     * At rest, arrival and separation balance: k rᵢ = Σ DECAY/rᵢⱼ² along the line between the two, with k = TOP_SPEED /
     * (SLOW_DOWN τ). Summed up, the separations cancel; summed up times where each is, k Σ rᵢ² = Σ DECAY/rᵢⱼ over the pairs.
     */
    private void settle() {
        play(120);
        double x = 0, y = 0, squares = 0, inverses = 0, nearest = Double.POSITIVE_INFINITY, farthest = 0, fastest = 0;
        for (Unit unit : world) {
            x += unit.getX() / world.size();
            y += unit.getY() / world.size();
            squares += distance(unit) * distance(unit);
            farthest = Math.max(farthest, distance(unit));
            fastest = Math.max(fastest, unit.getSpeed());
            for (Unit other : world) {
                if (other.getId() <= unit.getId()) continue;
                double r = Math.hypot(other.getX() - unit.getX(), other.getY() - unit.getY());
                inverses += 1 / r;
                nearest = Math.min(nearest, r);
            }
        }
        require(fastest < 1e-3, "all rest: " + fastest);
        require(reversals == 0, "none ever drove back: " + reversals);
        require(nearest > 4, "they keep their distance: " + nearest);
        require(farthest < 8, "all are there: " + farthest);
        near(CAMP.x, x, 1e-3, "the camp is in their middle");
        near(CAMP.y, y, 1e-3, "the camp is in their middle");
        near(DECAY * inverses, TOP_SPEED / (SLOW_DOWN * REACTION) * squares, 0.01, "arrival and separation balance");
        System.out.printf(
                "gdx-ai: Arrive and Separation bring %d tanks to rest, %.1f m apart and within %.1f m, in balance; not one"
                        + " reversal in %d steps%n",
                world.size(), nearest, farthest, world.getTick());
    }

    private static double distance(Unit unit) {
        return Math.hypot(unit.getX() - CAMP.x, unit.getY() - CAMP.y);
    }

    private static void near(double expected, double actual, double within, String claim) {
        require(Math.abs(actual - expected) <= within, claim + ": expected " + expected + ", was " + actual);
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
