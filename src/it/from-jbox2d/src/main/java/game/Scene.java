package game;

/** The physics of the game, which two libraries implement. */
interface Scene {
    /** A position in m, and a velocity in m/s. */
    record Motion(double x, double y, double vx, double vy) {}

    /** Advances by the seconds of a frame, with the buggy's engine on. */
    void frame(double elapsed);

    /** Hits the shell with an impulse, in N·s. */
    void hit(double jx, double jy);

    Motion buggy();

    Motion shell();
}
