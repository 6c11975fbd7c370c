package yarts.physics.benchmarks;

import java.util.Random;
import java.util.function.Supplier;

/** Makes objects as a running game does: between others, most of which die. */
final class Garbage {
    private static final Random RANDOM = new Random(5);

    /** Some of what is left behind; others overwrite it. */
    private static final Object[] LEFT = new Object[64];

    private Garbage() {}

    static <T> T among(Supplier<T> maker) {
        LEFT[RANDOM.nextInt(LEFT.length)] = new byte[RANDOM.nextInt(256)];
        return maker.get();
    }
}
