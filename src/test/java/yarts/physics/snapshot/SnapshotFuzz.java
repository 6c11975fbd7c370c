package yarts.physics.snapshot;

import java.util.List;
import yarts.physics.Snapshot;

/**
 * Reads bytes as a snapshot, which must throw or give a sound one. A fuzzer searches for bytes that lead to new paths
 * through the library. Because it cannot guess a checksum, the bytes are also tried with the right one.
 */
public final class SnapshotFuzz {
    private SnapshotFuzz() {}

    /** The entry point of the fuzzer. */
    public static void fuzzerTestOneInput(byte[] bytes) {
        check(bytes);
        if (bytes.length >= Saves.HEADER + Saves.CRC) check(Saves.repair(bytes.clone()));
    }

    private static void check(byte[] bytes) {
        Snapshot snapshot;
        try {
            snapshot = Snapshot.fromBytes(bytes);
        } catch (IllegalArgumentException e) {
            return; // with a message, as it must
        }
        if (!isAtItsEnd(bytes)) Saves.assertSound(snapshot);
    }

    /** Whether the tick or the last id is so near to the limit, 2^61, that a few more steps or units exceed it. */
    private static boolean isAtItsEnd(byte[] bytes) {
        for (String name : List.of("tick", "lastId")) {
            if ((Long) Saves.places(0).get(name).get(bytes) > (1L << 61) - 100) return true;
        }
        return false;
    }
}
