/** A game that is linked with its runtime. */
module game {
    requires yarts.physics;
}
