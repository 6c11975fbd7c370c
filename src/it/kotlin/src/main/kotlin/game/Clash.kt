package game

// tag::clash[]
import yarts.physics.Unit
import yarts.physics.World

// Without an alias, Unit is yarts.physics.Unit in this file, without a warning: an import by name precedes Kotlin's default
// imports. (With an import of yarts.physics.*, Unit is still Kotlin's.) The type of a function that returns nothing must then
// contain kotlin.Unit. An omitted return type is not affected.

fun spawn(world: World, mass: Double): Unit = world.add(Unit(mass))

fun order(world: World, how: (Unit) -> kotlin.Unit) {
    for (unit in world) how(unit)
}
// end::clash[]
