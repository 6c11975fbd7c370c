package yarts.physics;

import java.util.HashMap;
import java.util.Map;

/** In what two states differ: a line for each value, this one's and the other's, up to a hundred. */
final class Difference {
    private static final int MOST = 100;

    private final StringBuilder text = new StringBuilder();
    private int count;

    private Difference() {}

    static String of(State mine, State theirs) {
        Difference difference = new Difference();
        difference.compare(mine, theirs);
        int count = difference.count;
        return difference.text + (count > MOST ? "and " + (count - MOST) + " more\n" : "");
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
        add("interpolating", mine.interpolating, theirs.interpolating);
        compare(mine.table, theirs.table);
    }

    private void compare(Table mine, Table theirs) {
        add("size", mine.size(), theirs.size());
        Map<Long, Integer> indices = new HashMap<>();
        for (int j = 0; j < theirs.size(); j++) indices.put(theirs.id(j), j);
        for (int i = 0; i < mine.size(); i++) {
            String unit = "unit " + mine.id(i);
            Integer j = indices.remove(mine.id(i));
            add(unit, "index " + i, j == null ? "missing" : "index " + j);
            if (j == null) continue;
            double[][] columns = mine.at(i).state(), theirColumns = theirs.at(j).state();
            for (int k = 0; k < columns.length; k++) {
                double v = columns[k][Table.row(i)], their = theirColumns[k][Table.row(j)];
                add(unit + ' ' + Columns.STATE[k], v + 0.0, their + 0.0);
            }
        }
        for (int j = 0; j < theirs.size(); j++) {
            if (indices.containsKey(theirs.id(j))) add("unit " + theirs.id(j), "missing", "index " + j);
        }
    }

    private void add(String name, Object mine, Object theirs) {
        if (mine.equals(theirs) || ++count > MOST) return;
        text.append(name).append(": ").append(show(mine)).append(" | ");
        text.append(show(theirs)).append('\n');
    }

    private static String show(Object value) {
        return value instanceof Double v ? Double.toHexString(v) + " (" + value + ")" : value.toString();
    }
}
