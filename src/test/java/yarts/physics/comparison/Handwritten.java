package yarts.physics.comparison;

import java.util.ArrayList;
import java.util.List;
import yarts.physics.demo.Rule;
import yarts.physics.source.ArticleUnit;

/** A rule that games write by hand. The force is used up by the next step. */
final class Handwritten implements Engine {
    /** How a unit moves in a step; its velocity and its position. */
    interface Step {
        void move(ArticleUnit unit, double dt);
    }

    private final Step step;
    private final List<ArticleUnit> units = new ArrayList<>();

    private Handwritten(Step step) {
        this.step = step;
    }

    /** Friction as one more force, which is {@link ArticleUnit}. */
    static Engine naive() {
        return new Handwritten(ArticleUnit::integrate);
    }

    /** One of the demo's rules for the velocity; the new one moves the position, as in the engines that have them. */
    static Engine of(Rule rule) {
        return new Handwritten((unit, dt) -> {
            unit.vx = rule.velocities(unit.vx, unit.fx, unit.friction, unit.mass, dt, 1)[1];
            unit.x += unit.vx * dt;
            unit.fx = 0;
        });
    }

    /** The friction that the velocity has half a step on: v' = v + dt (F − f u)/m, u = v + dt/2 (F − f v)/m. */
    static Engine explicitMidpoint() {
        return new Handwritten((unit, dt) -> {
            double half = unit.vx + dt / 2 * (unit.fx - unit.friction * unit.vx) / unit.mass;
            unit.vx += dt * (unit.fx - unit.friction * half) / unit.mass;
            unit.x += dt * half;
            unit.fx = 0;
        });
    }

    @Override
    public Body add(double mass, double friction, double x, double v) {
        ArticleUnit unit = new ArticleUnit(mass);
        unit.friction = friction;
        unit.x = x;
        unit.vx = v;
        units.add(unit);
        return new Body() {
            @Override
            public void push(double force) {
                unit.applyForce(force, 0);
            }

            @Override
            public double x() {
                return unit.x;
            }

            @Override
            public double v() {
                return unit.vx;
            }

            @Override
            public void stop() {
                unit.vx = 0;
            }
        };
    }

    @Override
    public void step(double dt) {
        for (ArticleUnit unit : units) step.move(unit, dt);
    }
}
