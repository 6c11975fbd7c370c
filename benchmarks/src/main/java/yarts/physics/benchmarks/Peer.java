package yarts.physics.benchmarks;

/** An army in another library, or without one. */
interface Peer {
    /** Applies the force (FX, FY) to every unit, and steps by DT. */
    void step();

    double x(int i);

    double y(int i);

    double vx(int i);

    double vy(int i);
}
