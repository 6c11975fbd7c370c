package yarts.physics.bits;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import yarts.physics.Snapshot;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Restores the world of a snapshot, continues to play, and saves it again. The printed hashes and the written bytes are
 * the same on any machine, for a snapshot from any machine.
 *
 * <pre>{@code java -cp … yarts.physics.bits.SnapshotMain <read> <write> <frames>}</pre>
 */
public final class SnapshotMain {
    private SnapshotMain() {}

    public static void main(String[] args) throws IOException {
        World.checkArithmetic();
        World world = new World();
        world.restore(Snapshot.fromBytes(Files.readAllBytes(Paths.get(args[0]))));
        System.out.print(Long.toHexString(world.stateHash()));
        new Churn(1).play(world, Integer.parseInt(args[2]));
        System.out.println(" " + Long.toHexString(world.stateHash()));
        Files.write(Paths.get(args[1]), world.save().toBytes());
    }
}
