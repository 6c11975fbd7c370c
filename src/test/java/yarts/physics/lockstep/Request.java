package yarts.physics.lockstep;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;

/**
 * The message that a player sends for each tick. It has all information for the relay, so it can be sent again on
 * another connection.
 *
 * @param player the sender's number
 * @param tick the tick of the sender's game; −1 if there is no game yet
 * @param hash the hash of that game
 * @param orders the orders for the next tick
 * @param save the game's save, or empty
 */
record Request(int player, long tick, long hash, List<Command> orders, byte[] save) {
    byte[] toBytes() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeInt(player);
            out.writeLong(tick);
            out.writeLong(hash);
            Command.writeAll(orders, out);
            out.writeInt(save.length);
            out.write(save);
        }
        return bytes.toByteArray();
    }

    static Request read(DataInputStream in) throws IOException {
        int player = in.readInt();
        long tick = in.readLong(), hash = in.readLong();
        List<Command> orders = Command.readAll(in);
        byte[] save = new byte[in.readInt()];
        in.readFully(save);
        return new Request(player, tick, hash, orders, save);
    }
}
