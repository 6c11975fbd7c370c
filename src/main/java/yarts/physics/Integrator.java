package yarts.physics;

/**
 * How a step of {@code dt} seconds is worked out.
 *
 * <p>All three solve the same equation, per axis, for a force F that is constant over the step and a friction f (linear
 * drag):
 *
 * <pre>{@code
 * m dv/dt = F − f v,   z = f dt/m
 *
 * v' = decay(z) v + gain(z) (dt/m) F            then the speed cap on (vx', vy')
 * x' = x + dt ((1 − weight(z)) v + weight(z) v')
 * }</pre>
 *
 * <table>
 * <caption>The three schemes</caption>
 * <tr><th></th><th>decay(z)</th><th>gain(z)</th><th>weight(z)</th><th>order</th></tr>
 * <tr><td>{@link #EULER}</td><td>max(0, 1 − z)</td><td>1 / max(1, z)</td><td>0</td><td>1</td></tr>
 * <tr><td>{@link #MIDPOINT}</td><td>max(0, (1 − z/2)/(1 + z/2))</td><td>1 / max(1 + z/2, z)</td><td>1/2</td>
 * <td>2</td></tr>
 * <tr><td>{@link #EXACT}</td><td>e<sup>−z</sup></td><td>(1 − e<sup>−z</sup>)/z</td>
 * <td>1/(1 − e<sup>−z</sup>) − 1/z</td><td>exact</td></tr>
 * </table>
 *
 * <p>Whatever z is, v' lies between v and the terminal speed F/f, so friction never turns a unit round, nor makes it
 * oscillate about its terminal speed. Friction applied naively, as one more force −f v, does both as soon as z passes
 * 1: the jitters of "Y*A*R*T*S (Yet Another Real Time Strategy game)".
 */
public enum Integrator {
    /**
     * The source's own rule: the position from the velocity the step starts with, then the velocity from F/m. The
     * cheapest. A step with z ≥ 1 goes straight to the terminal speed.
     */
    EULER,

    /**
     * The average velocity over the step moves the unit: the implicit midpoint rule in closed form. Exact for constant
     * forces without friction. A step with z ≥ 2 goes straight to the terminal speed.
     */
    MIDPOINT,

    /**
     * The closed-form solution. While forces are constant and the cap does not bind, a unit's path is the same whatever
     * the length of the steps.
     */
    EXACT
}
