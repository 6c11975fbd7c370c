package yarts.physics.benchmarks;

/** An army in another library, or in none. */
interface Peer {
    /** A force of (FX, FY) on every unit, and a step of DT. */
    void step();

    double x(int i);

    double y(int i);

    double vx(int i);

    double vy(int i);
}
