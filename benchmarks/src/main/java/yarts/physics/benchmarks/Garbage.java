package yarts.physics.benchmarks;

import java.util.Random;
import java.util.function.Supplier;

/** Creates objects as in a running game: between other objects, most of which become garbage. */
final class Garbage {
    private static final Random RANDOM = new Random(5);

    /** Other objects that are alive until the next ones overwrite them. */
    private static final Object[] LEFT = new Object[64];

    private Garbage() {}

    static <T> T among(Supplier<T> maker) {
        LEFT[RANDOM.nextInt(LEFT.length)] = new byte[RANDOM.nextInt(256)];
        return maker.get();
    }
}
