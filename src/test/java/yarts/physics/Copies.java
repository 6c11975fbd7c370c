package yarts.physics;

/** Copies of units, for models that go back in time. */
public final class Copies {
    private Copies() {}

    /**
     * {@return a unit outside a world with the state and the forces of another} To the bit, which setters would not
     * give below rest.
     */
    public static Unit of(Unit unit) {
        Unit copy = new Unit(1);
        unit.table.copyRow(unit.row, copy.table, copy.row);
        return copy;
    }
}
