package yarts.physics.world;

import java.nio.ByteBuffer;
import java.util.function.Consumer;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Unit;

/**
 * Reads bytes as calls of a world and its units, and compares these with the model {@link Twins} after each call, or
 * less often if there are many units. A fuzzer searches for bytes that lead to new paths through the library.
 */
public final class WorldFuzz {
    private static final int MOST_CALLS = 200, MOST_UNITS = 1200, FEW = 32;

    /** Limits, and usual values to start with. */
    private static final double[] REALS = {
        0, 1, -1, 0.5, 1 / 60.0, 0.02, 3, -7, 100, 1e3, -1e6, 1e-9, 1e9, 1e38, -1e38, 0x1p-500, 0x1p-501, 1e-160, 1e160
    };

    private final ByteBuffer bytes;
    private final Twins twins = new Twins();
    private int units;

    private WorldFuzz(byte[] bytes) {
        this.bytes = ByteBuffer.wrap(bytes);
    }

    /** The entry point of the fuzzer. */
    public static void fuzzerTestOneInput(byte[] bytes) {
        new WorldFuzz(bytes).run();
    }

    private void run() {
        for (int calls = 0; bytes.hasRemaining() && calls < MOST_CALLS; calls++) {
            call(octet() % 30);
            if (units <= FEW || calls % 16 == 0) twins.compare();
        }
        twins.compare();
    }

    private int octet() {
        return bytes.hasRemaining() ? bytes.get() & 0xFF : 0;
    }

    /** One of these values, or any bits. */
    private double real() {
        int k = octet() % 32;
        if (k < REALS.length) return REALS[k];
        long bits = 0;
        for (int i = 0; i < (k < 26 ? 2 : 8); i++) bits = bits << 8 | octet();
        return k < 26 ? (short) bits / 16.0 : Double.longBitsToDouble(bits);
    }

    private double real(double least, double most) {
        double v = real();
        return v >= least && v <= most ? v : Math.max(least, Math.min(most, Double.isNaN(v) ? 1 : Math.abs(v)));
    }

    private double force() {
        return real(-1e38, 1e38);
    }

    private double finite() {
        return real(-Double.MAX_VALUE, Double.MAX_VALUE);
    }

    private Integrator integrator() {
        return Integrator.values()[octet() % 4];
    }

    private Pace pace() {
        int[] rates = {60, 1, 30, 64, 144, 1_000_000};
        int k = octet() % 9, most = 1 + octet() % 8;
        return k < rates.length ? Pace.fixed(rates[k], most) : Pace.variable(real(1e-3, 10), most);
    }

    private long nanoseconds() {
        return (long) (real(0, 2) * 1e9);
    }

    private void add(int n, double mass, double friction) {
        for (; n > 0 && units < MOST_UNITS; n--, units++) twins.addNew(mass, friction);
    }

    private void change(Consumer<Unit> change) {
        twins.change(octet(), change);
    }

    private void call(int call) {
        switch (call) {
            case 0 -> twins.move(integrator(), pace());
            case 1 -> twins.setIntegrator(integrator());
            case 2 -> twins.setPace(pace());
            case 3 -> add(octet() % 8, real(1e-50, 1e50), real(0, 1e50));
            case 4 -> add(Tiles.TILE - 1 + octet() % 3, 1 + octet(), octet());
            case 5 -> twins.add(octet());
            case 6 -> twins.remove(octet());
            case 7 -> twins.removeHeavierThan(real());
            case 8 -> twins.removeIfHeavierThan(real());
            case 9 -> twins.save();
            case 10 -> twins.restore(octet());
            case 11 -> twins.load(octet());
            case 12 -> {
                int pick = octet();
                if (pick < 128) twins.find(pick);
                else twins.changeListeners(pick);
            }
            case 13 -> twins.makeInvalidCalls(octet());
            case 14 -> twins.setFrozen(octet(), octet() % 2 == 0);
            case 15 -> twins.clearForces(octet());
            case 16 -> twins.clear();
            case 17 -> {
                double mass = real(1e-50, 1e50);
                change(unit -> unit.setMass(mass));
            }
            case 18 -> {
                double friction = real(0, 1e50);
                change(unit -> unit.setFriction(friction));
            }
            case 19 -> {
                double top = real(0, Double.POSITIVE_INFINITY);
                change(unit -> unit.setMaxSpeed(top));
            }
            case 20 -> {
                double vx = finite(), vy = finite();
                change(unit -> unit.setVelocity(vx, vy));
            }
            case 21 -> {
                double jx = force(), jy = force();
                change(unit -> unit.applyImpulse(jx, jy));
            }
            case 22 -> {
                double vx = finite(), vy = finite(), most = real(0, 1e50);
                change(unit -> unit.setMotor(vx, vy, most));
            }
            case 23 -> {
                double fx = force(), fy = force();
                change(unit -> unit.applyForce(fx, fy));
            }
            case 24 -> {
                int pick = octet();
                if (pick < 128) twins.teleport(pick, finite(), finite());
                else twins.moveTo(pick - 128, finite(), finite());
            }
            case 25 -> twins.integrateOne(octet(), real(0, 1e9), integrator());
            case 26 -> twins.applyForces(force() / 1e6, force() / 1e6);
            case 27 -> twins.step(real(0, 1e9));
            case 28 -> twins.advance(nanoseconds());
            default -> twins.advanceWithOrders(nanoseconds(), octet());
        }
    }
}
