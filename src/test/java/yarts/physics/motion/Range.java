package yarts.physics.motion;

/** The range of velocities, as in the package description. */
final class Range {
    /** No unit is faster; in m/s. */
    static final double FASTEST = 0x1p500;

    /** Velocity components below this are rest; in m/s. */
    static final double REST = 0x1p-500;

    private Range() {}
}
