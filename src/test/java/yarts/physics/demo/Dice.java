package yarts.physics.demo;

import yarts.physics.support.Churn;

/** Random numbers: SplitMix64. Its state is part of the game's hash. */
final class Dice {
    long state;

    Dice(long seed) {
        state = Churn.scramble(seed);
    }

    /** From 0 to 1. */
    double next() {
        return (Churn.scramble(state += Churn.GOLDEN) >>> 11) * 0x1p-53;
    }

    /** From 0 to n − 1. */
    int below(int n) {
        return (int) (next() * n);
    }

    /** From −most to most. */
    double within(double most) {
        return most * (2 * next() - 1);
    }
}
