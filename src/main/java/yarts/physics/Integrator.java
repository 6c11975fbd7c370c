package yarts.physics;

/**
 * The method that computes a step of {@code dt} seconds: a trade-off between accuracy, stability and cost.
 *
 * <p>All four integrators solve the same equation, for each axis, with a force F in N that is constant during the step,
 * a friction (linear drag) f in N·s/m and a mass m in kg:
 *
 * <pre>{@code
 * m dv/dt = F − f v,   z = f dt/m
 *
 * v' = decay(z) v + gain(z) (dt/m) F            then the speed cap on (vx', vy')
 * x' = x + dt (lag(z) v + (1 − lag(z)) v')
 * }</pre>
 *
 * <table>
 * <caption>The four integrators</caption>
 * <tr><th></th><th>decay(z)</th><th>gain(z)</th><th>lag(z)</th><th>order</th></tr>
 * <tr><td>{@link #EULER}</td><td>max(0, 1 − z)</td><td>1 / max(1, z)</td><td>1</td><td>1</td></tr>
 * <tr><td>{@link #SEMI_IMPLICIT}</td><td>1/(1 + z)</td><td>1/(1 + z)</td><td>0</td><td>1</td></tr>
 * <tr><td>{@link #MIDPOINT}</td><td>max(0, (1 − z/2)/(1 + z/2))</td><td>1 / max(1 + z/2, z)</td><td>1/2</td>
 * <td>2</td></tr>
 * <tr><td>{@link #EXACT}</td><td>e<sup>−z</sup></td><td>(1 − e<sup>−z</sup>)/z</td>
 * <td>1/z − 1/(e<sup>z</sup> − 1)</td><td>exact</td></tr>
 * </table>
 *
 * <p>The lag is the fraction of the step during which the old velocity still moves the unit.
 *
 * <p>For every z, v' lies between v and the terminal speed F/f. So friction never reverses a unit, and the speed never
 * oscillates around F/f. If friction is applied as one more force −f v instead, both happen when z exceeds 1: these are
 * the jitters of "Y*A*R*T*S (Yet Another Real Time Strategy game)".
 */
public enum Integrator {
    /**
     * The rule of "Y*A*R*T*S": the position from the velocity at the start of the step, then the velocity from F/m. A
     * step with z ≥ 1 reaches the terminal speed at once.
     */
    EULER(0),

    /**
     * The velocity first, then the position from the new velocity. Use it for forces that depend on positions: springs,
     * formations, orbits. Springs and orbits do not gain energy while k dt² &lt; 4 m + 2 f dt, where k is the stiffness
     * in N/m; with the other three integrators they do.
     */
    SEMI_IMPLICIT(3),

    /**
     * The implicit midpoint rule in closed form: the position from the average of the old and the new velocity. It is
     * exact for constant forces without friction. A step with z ≥ 2 reaches the terminal speed at once.
     */
    MIDPOINT(1),

    /**
     * The closed-form solution: while forces are constant and a unit is below its top speed, it takes the same path at
     * any step length. This is the default of a {@link World}.
     */
    EXACT(2);

    private static final Integrator[] BY_CODE = {EULER, MIDPOINT, EXACT, SEMI_IMPLICIT};

    /** The number of this integrator in hashes and saved bytes; it never changes. */
    final int code;

    Integrator(int code) {
        this.code = code;
    }

    static final int MAX_CODE = 3;

    static Integrator ofCode(int code) {
        return BY_CODE[code];
    }
}
