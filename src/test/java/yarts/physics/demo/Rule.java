package yarts.physics.demo;

import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.source.ArticleUnit;

/**
 * Rules for the velocity after a step of m dv/dt = F − f v: three that games use, and the library's four integrators. In all
 * of them, z = f dt/m.
 */
public enum Rule {
    /** Friction as a force: v' = v + (F − f v) dt/m. */
    NAIVE(Rule::naive),
    /** Add the force, then damp: v' = (v + F dt/m) max(0, 1 − z). */
    PUSH_THEN_DAMP((v, force, friction, mass, dt) -> (v + force * dt / mass) * Math.max(0, 1 - friction * dt / mass)),
    /** Damp, then add the force: v' = v max(0, 1 − z) + F dt/m. */
    DAMP_THEN_PUSH((v, force, friction, mass, dt) -> v * Math.max(0, 1 - friction * dt / mass) + force * dt / mass),

    EULER(library(Integrator.EULER)),
    SEMI_IMPLICIT(library(Integrator.SEMI_IMPLICIT)),
    MIDPOINT(library(Integrator.MIDPOINT)),
    EXACT(library(Integrator.EXACT));

    private interface Step {
        double velocity(double v, double force, double friction, double mass, double dt);
    }

    private final Step step;

    Rule(Step step) {
        this.step = step;
    }

    private static double naive(double v, double force, double friction, double mass, double dt) {
        ArticleUnit unit = new ArticleUnit(mass);
        unit.friction = friction;
        unit.vx = v;
        unit.applyForce(force, 0);
        unit.integrate(dt);
        return unit.vx;
    }

    private static Step library(Integrator integrator) {
        return (v, force, friction, mass, dt) -> {
            Unit unit = new Unit(mass).setFriction(friction).setVelocity(v, 0);
            unit.applyForce(force, 0);
            unit.integrate(dt, integrator);
            return unit.getVx();
        };
    }

    /** The velocities at the start and after each of a number of steps. */
    public double[] velocities(double v, double force, double friction, double mass, double dt, int steps) {
        double[] all = new double[steps + 1];
        all[0] = v;
        for (int i = 1; i <= steps; i++) all[i] = step.velocity(all[i - 1], force, friction, mass, dt);
        return all;
    }
}
