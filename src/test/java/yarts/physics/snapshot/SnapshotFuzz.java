package yarts.physics.snapshot;

import java.util.List;
import yarts.physics.Snapshot;

/**
 * Any bytes as a snapshot: refused, or sound. For a fuzzer, which looks for bytes that take new ways through the library;
 * since it cannot guess a checksum, the bytes are tried with the right one, too.
 */
public final class SnapshotFuzz {
    private SnapshotFuzz() {}

    /** What the fuzzer calls. */
    public static void fuzzerTestOneInput(byte[] bytes) {
        check(bytes);
        if (bytes.length >= Saves.HEADER + Saves.CRC) check(Saves.repair(bytes.clone()));
    }

    private static void check(byte[] bytes) {
        Snapshot snapshot;
        try {
            snapshot = Snapshot.fromBytes(bytes);
        } catch (IllegalArgumentException e) {
            return; // it says what is wrong
        }
        if (!isAtItsEnd(bytes)) Saves.assertSound(snapshot);
    }

    /** So near to the most steps or ids that a save can hold, 2^61, that a few more are past it. */
    private static boolean isAtItsEnd(byte[] bytes) {
        for (String name : List.of("tick", "lastId")) {
            if ((Long) Saves.places(0).get(name).get(bytes) > (1L << 61) - 100) return true;
        }
        return false;
    }
}
