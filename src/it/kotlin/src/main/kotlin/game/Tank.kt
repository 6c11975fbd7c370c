package game

// tag::tank[]
import yarts.physics.Unit as Body // Kotlin has its own Unit

class Tank(val engine: Double) : Body(40_000.0) { // kg
    init {
        friction = 8_000.0 // N·s/m
        maxSpeed = 15.0 // m/s
    }

    fun drive() = applyForce(engine, 0.0)
}
// end::tank[]
