package yarts.physics;

import java.util.HashMap;
import java.util.Map;

/** The differences between two states as text: a line for each value that differs, up to a hundred. */
final strictfp class Difference {
    private static final int MAX_LINES = 100;

    private final StringBuilder text = new StringBuilder();
    private int count;

    private Difference() {}

    static String of(State mine, State theirs) {
        Difference difference = new Difference();
        difference.compare(mine, theirs);
        int count = difference.count;
        return difference.text + (count > MAX_LINES ? "and " + (count - MAX_LINES) + " more\n" : "");
    }

    private void compare(State mine, State theirs) {
        add("integrator", mine.integrator, theirs.integrator);
        add(
                "timestep",
                mine.clock.timestep().toString(),
                theirs.clock.timestep().toString());
        long[] time = mine.clock.state(), theirTime = theirs.clock.state();
        for (int i = 0; i < time.length; i++) {
            if (i < Clock.DOUBLES) add(Clock.STATE[i], time[i], theirTime[i]);
            else add(Clock.STATE[i], Double.longBitsToDouble(time[i]), Double.longBitsToDouble(theirTime[i]));
        }
        add("lastId", mine.lastId, theirs.lastId);
        add("lastSteppedId", mine.lastSteppedId, theirs.lastSteppedId);
        add("interpolating", mine.interpolating, theirs.interpolating);
        compare(mine.table, theirs.table);
    }

    private void compare(Table mine, Table theirs) {
        add("size", mine.size, theirs.size);
        double[][] columns = mine.columns(), theirColumns = theirs.columns();
        Map<Long, Integer> rows = new HashMap<>();
        for (int j = 0; j < theirs.size; j++) rows.put(theirs.id[j], j);
        for (int i = 0; i < mine.size; i++) {
            String unit = "unit " + mine.id[i];
            Integer j = rows.remove(mine.id[i]);
            add(unit, "index " + i, j == null ? "missing" : "index " + j);
            if (j == null) continue;
            for (int k = 0; k < columns.length; k++) {
                add(unit + ' ' + Table.STATE[k], columns[k][i] + 0.0, theirColumns[k][j] + 0.0);
            }
        }
        for (int j = 0; j < theirs.size; j++) {
            if (rows.containsKey(theirs.id[j])) add("unit " + theirs.id[j], "missing", "index " + j);
        }
    }

    private void add(String name, Object mine, Object theirs) {
        if (mine.equals(theirs) || ++count > MAX_LINES) return;
        text.append(name).append(": ").append(show(mine)).append(" | ");
        text.append(show(theirs)).append('\n');
    }

    private static String show(Object value) {
        return value instanceof Double ? Double.toHexString((Double) value) + " (" + value + ")" : value.toString();
    }
}
