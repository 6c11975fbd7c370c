package yarts.physics.lockstep;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;

/** What the relay answers. */
record Reply(Kind kind, byte[] body) {
    enum Kind {
        /** Here are the commands of the tick. */
        RUN,
        /** That tick is too long ago: here is a save to go on from. */
        LOAD,
        /** The hashes differ: ask again, with your save. */
        SHOW,
        /** The match is over. */
        END
    }

    Reply(Kind kind) {
        this(kind, new byte[0]);
    }

    void write(DataOutputStream out) throws IOException {
        out.writeByte(kind.ordinal());
        out.writeInt(body.length);
        out.write(body);
        out.flush();
    }

    static Reply read(DataInputStream in) throws IOException {
        Kind kind = Kind.values()[in.readByte()];
        byte[] body = new byte[in.readInt()];
        in.readFully(body);
        return new Reply(kind, body);
    }
}
