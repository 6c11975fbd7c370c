package game;

import yarts.physics.Unit;

/** What the game adds to a unit is data of its own, which any JSON library can write. */
final class Tank extends Unit {
    record Data(String name, int shells) {}

    Data data;

    Tank(Data data) {
        super(40_000);
        this.data = data;
    }
}
