package game

import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.expm1
import yarts.physics.Integrator
import yarts.physics.Snapshot
import yarts.physics.StepListener
import yarts.physics.Timestep
import yarts.physics.Unit as Body
import yarts.physics.World

private const val DT = 1 / 60.0 // s, the world's step
private val engines = List(20) { 10_000.0 * (it + 1) } // N

/** A game in Kotlin: it uses units by properties, and worlds in loops. */
fun main() {
    properties()
    race()
    listen()
    find()
    restore()
    brake()
    clash()
    println(
        "kotlin: ${engines.size} tanks drove as the closed form says, alone as in a world to the bit; properties, loops," +
            " lambdas and nulls are Kotlin's, and friction at z = 1.5 stops a unit that the naive rule throws to and fro"
    )
}

/** A getter with a setter is a property, though the setters return the unit. Two values at once are set by a function. */
private fun properties() {
    val body = Body(1.0)
    body.friction = 2.0
    body.friction += 0.5
    body.mass *= 4
    body.maxSpeed = 5.0
    require(body.friction == 2.5 && body.mass == 4.0) { "properties can be set: $body" }
    body.setPosition(1.0, 2.0).setVelocity(30.0, 40.0)
    require(body.x == 1.0 && body.y == 2.0) { "it is there: $body" }
    near(3.0, body.vx)
    near(4.0, body.vy)
    require(body.speed == body.maxSpeed) { "at top speed" }
    body.isFrozen = true
    body.applyImpulse(-1e3, 0.0)
    near(3.0, body.vx)
    require(body.isFrozen) { "a frozen unit takes no impulse" }
    require(body.setFriction(0.0) === body) { "the setters of Java are there as well" }
}

private fun race() {
    // tag::race[]
    val world = World()
    val tanks = engines.map { world.add(Tank(it)) } // a List<Tank>
    repeat(600) {
        for (tank in tanks) tank.drive()
        world.advance(1 / 60.0)
    }
    val leader = world.maxBy { it.x } // an Iterable<Body>
    // end::race[]
    require(leader === tanks.last()) { "the strongest leads" }
    require(world.tick == 600L && world.size() == tanks.size) { "a step a frame" }
    for (tank in tanks) {
        compare(tank, 600)
        val alone = Tank(tank.engine)
        repeat(600) {
            alone.drive()
            alone.integrate(DT, world.integrator)
        }
        require(alone.x.toRawBits() == tank.x.toRawBits()) { "alone as in the world, to the bit" }
        require(alone.vx.toRawBits() == tank.vx.toRawBits()) { "alone as in the world, to the bit" }
    }
}

/** n steps from rest: v = F/f (1 − e^(−f t/m)), x = (F t − m v)/f; or the top speed, if F/f is more. */
private fun compare(tank: Tank, n: Int) {
    val terminal = tank.engine / tank.friction
    val v = -terminal * expm1(-tank.friction * n * DT / tank.mass)
    near(minOf(v, tank.maxSpeed), tank.vx)
    if (terminal <= tank.maxSpeed) near((tank.engine * n * DT - tank.mass * v) / tank.friction, tank.x)
    require(tank.y == 0.0) { "it drove straight on" }
}

/** A lambda is a step listener. Each use of it is another object, so a listener that will be removed is kept. */
private fun listen() {
    val world = World(Integrator.EXACT, Timestep.fixed(60))
    val body = world.add(Body(2.0).apply { friction = 3.0 })
    var steps = 0
    world.addAfterStep { _, _ -> steps++ }
    val push = StepListener { w, _ -> for (u in w) u.applyForce(6.0, 0.0) }
    world.addBeforeStep(push)
    repeat(60) { world.advance(DT) }
    near(-2 * expm1(-1.5), body.vx) // F/f (1 − e^(−f t/m)) after a second
    require(world.removeStepListener(push)) { "it was there" }
    repeat(60) { world.advance(DT) }
    near(-2 * expm1(-1.5) * exp(-1.5), body.vx) // and a second without it
    require(steps == 120) { "called after each step: $steps" }
}

/** To Kotlin what find returns may be null or not, as the caller says: to say `Body?` makes Kotlin check it. */
private fun find() {
    val world = World()
    val id = world.add(Body(1.0)).id
    // tag::find[]
    val target: Body? = world.find(id)
    target?.applyImpulse(5.0, 0.0)
    // end::find[]
    require(target?.vx == 5.0) { "found, and hit" }
    require(world.remove(target)) { "it was there" }
    val gone: Body? = world.find(id)
    gone?.applyImpulse(5.0, 0.0)
    require(gone == null && target.world == null) { "it is not there any more" }
    require(runCatching { world.find(id).applyImpulse(5.0, 0.0) }.exceptionOrNull() is NullPointerException) {
        "without the question mark, Kotlin does not check it"
    }
}

private fun restore() {
    val world = World()
    for (engine in engines) world.add(Tank(engine))
    for (unit in world) (unit as Tank).drive()
    world.step(DT)
    val bytes = world.save().toBytes()
    val other = World()
    other.restore(Snapshot.fromBytes(bytes)) { id -> Tank(engines[id.toInt() - 1]) }
    require(other.stateHash() == world.stateHash()) { "restored to the bit" }
    require(other.all { it is Tank && it.engine == engines[it.id.toInt() - 1] }) { "as tanks, each with its engine" }
}

/** Braking at z = f dt/m = 1.5. */
private fun brake() {
    val body = Body(1.0).apply { friction = 90.0 }.setVelocity(10.0, 0.0)
    val z = body.friction * DT / body.mass
    val kept = generateSequence(body.vx) { body.integrate(DT); body.vx }.take(60).toList()
    val naive = generateSequence(10.0) { v -> v - z * v }.take(60).toList()
    require(reversals(kept) == 0 && kept.last() == 0.0) { "it stops, and stays: $kept" }
    require(reversals(naive) == 59) { "the naive rule turns it round at every step: $naive" }
}

private fun reversals(v: List<Double>) = v.zipWithNext().count { (a, b) -> a * b < 0 }

private fun clash() {
    val world = World()
    val body: Body = spawn(world, 2.0)
    order(world) { it.applyImpulse(4.0, 0.0) }
    require(body.vx == 2.0) { "the physics' Unit under its own name, in Clash.kt" }
    require(Body::class.qualifiedName == "yarts.physics.Unit") { "Body is the physics'" }
    val nothing: Unit = body.clearForces()
    require(nothing === kotlin.Unit) { "Unit is Kotlin's" }
}

private fun near(expected: Double, actual: Double) =
    require(abs(actual - expected) <= 1e-9 * abs(expected)) { "expected $expected, was $actual" }
