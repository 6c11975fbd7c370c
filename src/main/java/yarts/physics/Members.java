package yarts.physics;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.RandomAccess;

/** The handles of the rows. Its iterator fails fast, and its remove moves the last unit into the gap. */
final class Members extends AbstractList<Unit> implements RandomAccess {
    private final Columns columns;
    private Unit[] list = new Unit[16];
    private int size;
    /** By id; null until somebody asks. */
    private Map<Long, Unit> byId;

    /** The rows of a world's table, which nobody else adds or takes away. */
    Members(Columns columns) {
        this.columns = columns;
    }

    Unit[] array() {
        return list;
    }

    Unit find(long id) {
        if (byId == null) {
            byId = new HashMap<>();
            for (int i = 0; i < size; i++) byId.put(columns.id[i], list[i]);
        }
        return byId.get(id);
    }

    void append(Unit unit, long id) {
        reserve(size + 1);
        unit.columns.copyRow(unit.row, columns, size);
        columns.id[size] = id;
        place(unit, columns, size++);
        if (byId != null) byId.put(id, unit);
        modCount++;
    }

    private void reserve(int n) {
        columns.reserve(n);
        if (n > list.length) list = Arrays.copyOf(list, columns.capacity());
    }

    /** The first n of some units become those of this world; their rows are to be filled. */
    void set(Unit[] wanted, long[] ids, int n) {
        if (n == size && begins(wanted, ids, n)) return;
        for (int i = 0; i < n; i++) {
            if (wanted[i].getWorld() != null && wanted[i].columns != columns) {
                throw new IllegalStateException("a unit of the snapshot is in another world by now: " + wanted[i]);
            }
        }
        for (int i = 0; i < n; i++) if (wanted[i].columns == columns) list[wanted[i].row] = null; // it stays
        for (int i = 0; i < size; i++) if (list[i] != null) release(list[i]);
        Arrays.fill(list, 0, size, null);
        reserve(n);
        for (int i = 0; i < n; i++) place(wanted[i], columns, i);
        size = n;
        byId = null;
        modCount++;
    }

    private boolean begins(Unit[] wanted, long[] ids, int n) {
        for (int i = 0; i < n; i++) if (wanted[i] != list[i] || ids[i] != columns.id[i]) return false;
        return true;
    }

    @Override
    public Unit remove(int index) {
        Unit unit = get(index);
        if (byId != null) byId.remove(unit.getId());
        release(unit);
        Unit last = list[--size];
        list[size] = null;
        if (last != unit) {
            columns.copyRow(size, columns, index);
            place(last, columns, index);
        }
        modCount++;
        return unit;
    }

    @Override
    public void clear() {
        for (int i = 0; i < size; i++) release(list[i]);
        Arrays.fill(list, 0, size, null);
        size = 0;
        byId = null;
        modCount++;
    }

    private void release(Unit unit) {
        int row = unit.row;
        Columns.adopt(unit);
        columns.copyRow(row, unit.columns, unit.row);
    }

    private void place(Unit unit, Columns table, int row) {
        list[row] = unit;
        unit.columns = table;
        unit.row = row;
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
        return o instanceof Unit && ((Unit) o).columns == columns ? ((Unit) o).row : -1;
    }
}
