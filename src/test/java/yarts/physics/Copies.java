package yarts.physics;

/** Copies of units, for models that go back in time. */
public final class Copies {
    private Copies() {}

    /** {@return a unit in no world, in the state of another, with its forces} To the bit: setters would round to rest. */
    public static Unit of(Unit unit) {
        Unit copy = new Unit(1);
        unit.table.copyRow(unit.row, copy.table, copy.row);
        return copy;
    }
}
