/** A game in a module of its own. */
module game {
    requires yarts.physics;
}
