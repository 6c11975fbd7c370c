package yarts.physics.lockstep;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** An order of a player. It names units by id, because objects have no meaning on another machine. */
record Command(Kind kind, long unit, double x, double y) {
    enum Kind {
        MOVE,
        SPAWN,
        EXPLODE,
        RETIRE
    }

    static void writeAll(List<Command> commands, DataOutput out) throws IOException {
        out.writeInt(commands.size());
        for (Command command : commands) {
            out.writeByte(command.kind.ordinal());
            out.writeLong(command.unit);
            out.writeDouble(command.x);
            out.writeDouble(command.y);
        }
    }

    static List<Command> readAll(DataInput in) throws IOException {
        List<Command> commands = new ArrayList<>();
        for (int left = in.readInt(); left > 0; left--) {
            Kind kind = Kind.values()[in.readByte()];
            commands.add(new Command(kind, in.readLong(), in.readDouble(), in.readDouble()));
        }
        return commands;
    }
}
