package game

// tag::clash[]
import yarts.physics.Unit
import yarts.physics.World

// Without an alias, Unit is the physics' in this file, with no word from Kotlin: an import by name goes before what Kotlin
// imports by itself. (Not so yarts.physics.*: there the type is Kotlin's still.) What returns nothing is kotlin.Unit then, and
// has to be written so in the types of functions. A return type that is left out, as it mostly is, is not concerned.

fun spawn(world: World, mass: Double): Unit = world.add(Unit(mass))

fun order(world: World, how: (Unit) -> kotlin.Unit) {
    for (unit in world) how(unit)
}
// end::clash[]
