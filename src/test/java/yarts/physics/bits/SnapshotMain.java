package yarts.physics.bits;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import yarts.physics.Snapshot;
import yarts.physics.World;
import yarts.physics.support.Churn;

/**
 * Restores the world of a saved game, plays on, and saves it again: on any machine the hashes that it prints and the
 * bytes that it writes are the same, whatever machine wrote what it reads.
 *
 * <pre>{@code java -cp … yarts.physics.bits.SnapshotMain <read> <write> <frames>}</pre>
 */
public final class SnapshotMain {
    private SnapshotMain() {}

    public static void main(String[] args) throws IOException {
        World.checkArithmetic();
        World world = new World();
        world.restore(Snapshot.fromBytes(Files.readAllBytes(Path.of(args[0]))));
        System.out.print(Long.toHexString(world.stateHash()));
        new Churn(1).play(world, Integer.parseInt(args[2]));
        System.out.println(" " + Long.toHexString(world.stateHash()));
        Files.write(Path.of(args[1]), world.save().toBytes());
    }
}
