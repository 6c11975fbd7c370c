package yarts.physics;

/** Copies of units, for models that go back in time. */
public final class Copies {
    private Copies() {}

    /** {@return a unit in no world, in the state of another, with the force on it} To the bit: setters would put it to rest. */
    public static Unit of(Unit unit) {
        Unit copy = new Unit(1);
        for (int k = 0; k < Columns.STATE.length; k++) {
            copy.columns.state()[k][copy.row] = unit.columns.state()[k][unit.row];
        }
        copy.columns.renew();
        copy.columns.still |= unit.columns.still;
        copy.columns.push(copy.row);
        return copy;
    }
}
