/**
 * Physics of 2D units for strategy games: units accumulate forces, move in steps of time, stay below a top speed, and
 * are slowed by friction that never reverses them.
 *
 * <pre>{@code
 * World world = new World();                         // exact, 60 steps per second
 * Unit tank = world.add(new Unit(40_000).setFriction(8_000).setMaxSpeed(15));
 * tank.applyForce(120_000, 0);                       // N, for the time of the next advance
 * world.advance(1 / 144.0);                          // s, since the last frame
 * draw(tank.getInterpolatedX(), tank.getInterpolatedY());
 * }</pre>
 *
 * <p>All quantities are in SI units: metres, seconds, kilograms, newtons. {@link yarts.physics.Integrator} gives the
 * formulas. The library follows the physics chapter of "Y*A*R*T*S (Yet Another Real Time Strategy game)".
 *
 * <p><b>Range.</b> Every argument must be finite (only a top speed may be infinite). Masses are from 1e-50 to 1e50 kg,
 * friction is at most 1e50 N·s/m, components of forces and impulses are at most 1e50 N and N·s, times are at most 1e9
 * s. Within this range, no number of steps leads to NaN or infinity: no unit is faster than 2<sup>500</sup> (3.3e150)
 * m/s, and velocity components below 2<sup>-500</sup> (3.1e-151) m/s become exactly 0. An argument out of range throws
 * an {@link IllegalArgumentException} with the value and the rule, and changes nothing. A null argument throws a {@link
 * NullPointerException}, unless its description allows null.
 *
 * <p><b>Threads.</b> Worlds, units and snapshots are not thread-safe: use a world and its units from one thread at a
 * time.
 */
package yarts.physics;
