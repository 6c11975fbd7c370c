package yarts.physics.bits;

import yarts.physics.Unit;
import yarts.physics.World;

/**
 * Loads a library and lets it set bits of this thread's floating-point mode. After each of the two, prints the result
 * of {@link World#checkArithmetic} and the hash of a world with tiny numbers.
 *
 * <pre>{@code java -cp … yarts.physics.bits.ArithmeticMain <library> <bits>}</pre>
 */
public final class ArithmeticMain {
    private ArithmeticMain() {}

    public static void main(String[] args) {
        System.load(args[0]);
        System.out.println(verdict());
        set(Integer.parseInt(args[1]));
        System.out.println(verdict());
    }

    /** Implemented by the library. */
    private static native void set(int bits);

    static String verdict() {
        World world = new World();
        world.add(new Unit(1)).setVelocity(1e-150, 0);
        world.step(1e-170); // to x = 1e-320, a subnormal number
        return says() + ' ' + Long.toHexString(world.stateHash());
    }

    private static String says() {
        try {
            World.checkArithmetic();
            return "passes";
        } catch (IllegalStateException e) {
            return e.getMessage();
        }
    }
}
