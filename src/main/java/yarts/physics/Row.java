package yarts.physics;

/** Where a unit's state is: a block, and a row in it. */
abstract class Row {
    /** Where units outside a world have their rows, so that making one takes no arrays of its own. */
    private static Columns nursery = new Columns(0, Columns.LANES);

    Columns columns;
    int row;

    /** A row outside any world. */
    Row() {
        synchronized (Row.class) {
            Columns room = nursery();
            place(room, room.end++);
        }
    }

    /** The nursery, with a row to spare. */
    private static Columns nursery() {
        if (nursery.end == Columns.LANES)
            nursery = new Columns(0, Columns.LANES); // the old one goes with its last unit
        return nursery;
    }

    /** Is from now on what a row holds. */
    final void place(Columns columns, int row) {
        this.columns = columns;
        this.row = row;
    }

    /** Takes what it holds to another row. */
    final void move(Columns columns, int row) {
        this.columns.copyRow(this.row, columns, row);
        place(columns, row);
    }

    /**
     * Takes what it holds to a row outside any world, but for forces that have yet to act: in a room, or the nursery. It
     * goes last of all: what fails before, for want of memory or of stack, leaves it in its world.
     */
    void leave(Columns room) {
        synchronized (Row.class) {
            Columns to = room == null ? nursery() : room;
            int free = to.end++;
            columns.clearForces(row);
            columns.copyRow(row, to, free);
            columns = to;
            row = free;
        }
    }

    /** Whether it is in a world. */
    abstract boolean isMember();

    /** Its index in the table. */
    final int index() {
        return columns.origin + row;
    }
}
