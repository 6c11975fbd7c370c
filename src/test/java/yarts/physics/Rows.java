package yarts.physics;

import java.util.List;

/** The state of a unit by the names of its columns, also where it has no getter. */
public final class Rows {
    private Rows() {}

    /** {@return the value of a column} */
    public static double get(Unit unit, String name) {
        return unit.table.columns()[List.of(Table.STATE).indexOf(name)][unit.row];
    }
}
