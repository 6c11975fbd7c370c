package yarts.physics.world;

import yarts.physics.Timestep;

/** The values of a {@link Timestep}: rate, or 0 if steps are variable; longest step; and largest number of steps. */
record Pace(int rate, double maxStep, int maxSteps) {
    static Pace fixed(int rate, int maxSteps) {
        return new Pace(rate, 1.0 / rate, maxSteps);
    }

    static Pace variable(double maxStep, int maxSteps) {
        return new Pace(0, maxStep, maxSteps);
    }

    boolean isFixed() {
        return rate > 0;
    }

    Timestep timestep() {
        return (isFixed() ? Timestep.fixed(rate) : Timestep.variable(maxStep)).withMaxSteps(maxSteps);
    }
}
