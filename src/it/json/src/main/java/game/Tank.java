package game;

import yarts.physics.Unit;

/** A unit with data of the game, which any JSON library can write. */
final class Tank extends Unit {
    record Data(String name, int shells) {}

    Data data;

    Tank(Data data) {
        super(40_000);
        this.data = data;
    }
}
