package yarts.physics.web;

import java.util.zip.CRC32;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.World;
import yarts.physics.bits.SameBitsMain;
import yarts.physics.support.Churn;

/** Prints results that must have the same bits on the web and on a JVM: the golden game, and saves that are restored. */
public final class Golden {
    /** Several tiles of units, and a few seconds in a browser. */
    private static final int UNITS = 3_000, TICKS = 200;

    private static final int FRAMES = 60;
    /** A save ends with its own checksum, in bytes. Including it, the CRC would be the same for every save. */
    private static final int CHECKSUM = 4;

    private Golden() {}

    public static void main(String[] args) {
        System.out.println(text());
    }

    /** {@return one line for each game} */
    public static String text() {
        StringBuilder text = new StringBuilder(SameBitsMain.play(UNITS, TICKS, world -> {}));
        for (Integrator integrator : Integrator.values()) text.append('\n').append(save(integrator));
        return text.toString();
    }

    /** Saves a world as bytes and continues from them in another world. */
    private static String save(Integrator integrator) {
        World world = new World(integrator, Timestep.fixed(60).withMaxSteps(4));
        Churn game = new Churn(2, UNITS, 200);
        for (int i = 0; i < FRAMES; i++) game.frame(world);
        byte[] bytes = world.save().toBytes();
        World copy = new World();
        copy.restore(Snapshot.fromBytes(bytes));
        if (copy.stateHash() != world.stateHash())
            throw new IllegalStateException("the restored world differs from the saved one");
        copy.advance(0.1);
        CRC32 crc = new CRC32();
        crc.update(bytes, 0, bytes.length - CHECKSUM);
        return integrator + " save " + bytes.length + " bytes, CRC " + Long.toHexString(crc.getValue()) + ", then "
                + Long.toHexString(copy.stateHash());
    }
}
