/**
 * Physics of 2D units: they accumulate forces, step through time, stay below a top speed, and are slowed by friction that
 * never reverses them.
 *
 * <pre>{@code
 * World world = new World();                         // exact, 60 steps per second
 * Unit tank = world.add(new Unit(40_000).setFriction(8_000).setMaxSpeed(15));
 * tank.applyForce(120_000, 0);                       // newtons, for the time of the next advance
 * world.advance(1 / 144.0);                          // the seconds that the last frame took
 * draw(tank.getInterpolatedX(), tank.getInterpolatedY());
 * }</pre>
 *
 * <p>Quantities are in SI units: metres, seconds, kilograms, newtons. {@link yarts.physics.Integrator} has the mathematics.
 * The library follows the physics chapter of "Y*A*R*T*S (Yet Another Real Time Strategy game)".
 *
 * <p><b>Range.</b> Every argument must be finite (only a top speed may be infinite). Masses lie in [1e-50, 1e50] kg;
 * friction is at most 1e50 N·s/m, the components of forces and impulses at most 1e50 N and N·s, times at most 1e9 s.
 * Within that range no number of steps leads to NaN or infinity: no unit is faster than 2<sup>500</sup> (3.3e150) m/s, and
 * velocity components below 2<sup>-500</sup> (3.1e-151) m/s become exactly 0. An argument out of range causes an
 * {@link IllegalArgumentException} that names the value and the rule, and changes nothing.
 *
 * <p><b>Threads.</b> Nothing here is safe for use by several threads at once: a world and its units belong to one thread at
 * a time.
 */
package yarts.physics;
