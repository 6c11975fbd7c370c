package yarts.physics;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.RandomAccess;
import java.util.Set;
import java.util.function.LongFunction;

/** The handles of a table's rows. Its iterator fails fast, and its remove moves the last unit into the gap. */
final class Members extends AbstractList<Unit> implements RandomAccess {
    private final Table table;
    private Unit[] list = new Unit[16];
    private int size;
    /** By id; null until somebody asks. */
    private Map<Long, Unit> byId;

    /** The rows of a table to which nobody else adds, and from which nobody else takes away. */
    Members(Table table) {
        this.table = table;
    }

    Unit[] array() {
        return list;
    }

    Unit find(long id) {
        if (byId == null) {
            Map<Long, Unit> all = new HashMap<>();
            for (int i = 0; i < size; i++) all.put(list[i].getId(), list[i]);
            byId = all;
        }
        return byId.get(id);
    }

    void append(Unit unit, long id) {
        reserve(size + 1);
        Map<Long, Unit> index = byId;
        byId = null; // until it is right again: what follows may fail
        if (index != null) index.put(id, unit);
        unit.clearForces();
        table.resize(size + 1);
        Columns end = table.at(size);
        int row = Table.row(size);
        unit.columns.copyRow(unit.row, end, row);
        end.settle(row);
        end.id[row] = id;
        unit.place(end, row); // the last that may fail
        list[size++] = unit;
        byId = index;
        modCount++;
    }

    /** The units with the ids of another table; a factory makes those that are missing here. */
    Unit[] wanted(Table saved, LongFunction<? extends Unit> factory) {
        Unit[] wanted = new Unit[saved.size()];
        Set<Unit> made = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int i = 0; i < wanted.length; i++) {
            long id = saved.id(i);
            wanted[i] = find(id);
            if (wanted[i] != null) continue;
            wanted[i] = Check.notNull("the factory's unit", factory.apply(id));
            if (wanted[i].isMember() || !made.add(wanted[i])) {
                throw new IllegalStateException("the factory must make a new unit for id " + id + ", not " + wanted[i]);
            }
        }
        return wanted;
    }

    /** Makes room for n units. What changes them comes after this, as it may fail for want of memory. */
    private void reserve(int n) {
        if (n > list.length) list = Arrays.copyOf(list, Math.max(n, 2 * list.length));
        table.reserve(n);
    }

    /** Some units become those of the table, which is about to become another. */
    void set(Unit[] wanted, Table saved) {
        int n = saved.size();
        for (int i = 0; i < n; i++) {
            if (wanted[i].isMember() && !has(wanted[i])) {
                throw new IllegalStateException("a unit of the snapshot is in another world by now: " + wanted[i]);
            }
        }
        if (n == size && are(wanted, saved)) return;
        reserve(n);
        int leaving = size;
        for (int i = 0; i < n; i++) if (has(wanted[i])) leaving--;
        Columns[] rooms = rooms(leaving);
        for (int i = 0; i < n; i++) if (has(wanted[i])) list[wanted[i].index()] = null; // it stays
        for (int i = 0; i < size; i++) if (list[i] != null) list[i].leave(rooms[--leaving / Columns.LANES]);
        Arrays.fill(list, 0, size, null);
        System.arraycopy(wanted, 0, list, 0, n);
        size = n;
        byId = null;
        modCount++;
    }

    /** Blocks outside any world for so many units. */
    private static Columns[] rooms(int units) {
        Columns[] rooms = new Columns[Columns.lanes(units) / Columns.LANES];
        for (int k = 0; k < rooms.length; k++) rooms[k] = new Columns(0, Columns.LANES);
        return rooms;
    }

    private boolean are(Unit[] wanted, Table saved) {
        for (int i = 0; i < size; i++) if (wanted[i] != list[i] || saved.id(i) != list[i].getId()) return false;
        return true;
    }

    /** Places each at its row. */
    void place() {
        for (int i = 0; i < size; i++) list[i].place(table.at(i), Table.row(i));
    }

    boolean has(Unit unit) {
        int i = unit.index();
        return i < size && list[i] == unit;
    }

    @Override
    public Unit remove(int i) {
        Unit unit = get(i);
        Columns gap = unit.columns;
        Map<Long, Unit> index = byId;
        byId = null; // until it is right again: what follows may fail
        if (index != null) index.remove(unit.getId());
        unit.leave(null);
        Unit last = list[size - 1];
        if (last != unit) {
            last.move(gap, Table.row(i));
            list[i] = last;
        }
        list[--size] = null;
        table.removeLast();
        byId = index;
        modCount++;
        return unit;
    }

    @Override
    public void clear() {
        while (size > 0) remove(size - 1);
    }

    @Override
    public Unit get(int index) {
        Objects.checkIndex(index, size);
        return list[index];
    }

    @Override
    public int size() {
        return size;
    }

    @Override
    public boolean contains(Object o) {
        return indexOf(o) >= 0;
    }

    @Override
    public int indexOf(Object o) {
        return o instanceof Unit unit && has(unit) ? unit.index() : -1;
    }
}
