package yarts.physics.lockstep;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;

/** An answer of the relay. */
record Reply(Kind kind, byte[] body) {
    enum Kind {
        /** The commands of the tick. */
        RUN,
        /** The tick is too old; a save from which to continue. */
        LOAD,
        /** The hashes differ; the player must send the request again with a save. */
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
