/** Two-dimensional unit physics for real-time strategy games. */
module yarts.physics {
    exports yarts.physics;
}
