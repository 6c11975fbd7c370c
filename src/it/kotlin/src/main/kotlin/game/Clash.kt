package game

// tag::clash[]
import yarts.physics.*

// Without an alias, Unit is the physics' in this file, with no word from Kotlin: an import, by name or by *, goes
// before what Kotlin imports by itself. What returns nothing is kotlin.Unit then, and has to be written so in the types of
// functions. A return type that is left out, as it mostly is, is not concerned.

fun spawn(world: World, mass: Double): Unit = world.add(Unit(mass))

fun order(world: World, how: (Unit) -> kotlin.Unit) {
    for (unit in world) how(unit)
}
// end::clash[]
