package game;

/** What the game sees of its physics, whichever that is. */
interface Scene {
    /** Where something is, in m, and how it moves, in m/s. */
    record Motion(double x, double y, double vx, double vy) {}

    /** Passes the seconds of a frame, with the buggy's engine running. */
    void frame(double elapsed);

    /** Hits the shell with an impulse, in N·s. */
    void hit(double jx, double jy);

    Motion buggy();

    Motion shell();
}
