package yarts.physics;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.Collections;
import java.util.ConcurrentModificationException;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.ListIterator;
import java.util.NoSuchElementException;
import java.util.RandomAccess;
import java.util.Set;
import java.util.function.LongFunction;

/**
 * The units of a world, by index and by id. Unit i has row i of the world's table. When a unit is removed, the last one
 * takes its index.
 */
final class Members extends AbstractList<Unit> implements RandomAccess {
    /** The minimum number of slots per unit: free slots keep searches short. */
    private static final int SLOTS_PER_UNIT = 2;

    private static final long GOLDEN = 0x9E3779B97F4A7C15L; // distributes the ids over the slots

    private static final Unit[] NONE = {};

    private final State state;
    private Unit[] list = NONE;
    /** The array in which a restore collects its units; empty at other times. */
    private Unit[] spare = NONE;
    /** A hash table from ids to rows, with linear probing: row + 1, or 0 if free. Its length is a power of two. */
    private int[] slots = {0};

    Members(State state) {
        this.state = state;
    }

    Unit[] array() {
        return list;
    }

    boolean has(Unit unit) {
        return unit.table == state.table;
    }

    Unit find(long id) {
        int row = slots[slot(id)] - 1;
        return row < 0 ? null : list[row];
    }

    /** The slot of an id, or the free slot in which to enter it. */
    private int slot(long id) {
        long[] ids = state.table.id;
        int s = home(id);
        while (slots[s] != 0 && ids[slots[s] - 1] != id) s = next(s);
        return s;
    }

    private int home(long id) {
        return (int) ((id * GOLDEN) >>> 32) & (slots.length - 1);
    }

    private int next(int slot) {
        return (slot + 1) & (slots.length - 1);
    }

    /** Frees the slot of an id, and moves later entries that a search would no longer find. */
    private void free(long id) {
        int gap = slot(id), mask = slots.length - 1;
        for (int s = next(gap); slots[s] != 0; s = next(s)) {
            int home = home(state.table.id[slots[s] - 1]);
            if (((s - home) & mask) < ((s - gap) & mask)) continue; // its home is after the gap
            slots[gap] = slots[s];
            gap = s;
        }
        slots[gap] = 0;
    }

    /** Allocates memory for a number of units. If memory runs out, the units are unchanged: call it before changes. */
    private void reserve(int units) {
        if (units > list.length) list = Arrays.copyOf(list, Math.max(units, list.length + list.length / 2 + 8));
        state.table.reserve(units);
        if (slots.length < SLOTS_PER_UNIT * units) {
            slots = new int[Integer.highestOneBit(SLOTS_PER_UNIT * units - 1) * 2];
            index();
        }
    }

    /** Enters all ids into the hash table, which must be empty. */
    private void index() {
        for (int i = 0; i < size(); i++) slots[slot(state.table.id[i])] = i + 1;
    }

    void append(Unit unit, long id) {
        Table t = state.table;
        int row = t.size;
        reserve(row + 1);
        int slot = slot(id);
        unit.table.copyRow(unit.row, t, row);
        t.clearForces(row);
        t.settle(row);
        t.id[row] = id;
        Coefficients.renewRow(t, row);
        t.size++;
        list[row] = unit;
        slots[slot] = row + 1;
        unit.table = t;
        unit.row = row;
        modCount++;
    }

    @Override
    public Unit remove(int i) {
        Table t = state.table;
        Unit unit = get(i), last = list[t.size - 1];
        Table own = new Table(1);
        leave(unit, own, 0);
        free(t.id[i]);
        if (last != unit) {
            slots[slot(last.getId())] = i + 1;
            t.copyRow(last.row, t, i);
            Coefficients.renewRow(t, i);
            last.row = i;
            list[i] = last;
        }
        list[t.size - 1] = null;
        t.truncate(t.size - 1);
        modCount++;
        return unit;
    }

    /** Moves a unit to a table outside a world, and clears its forces. */
    private static void leave(Unit unit, Table to, int row) {
        unit.table.copyRow(unit.row, to, row);
        to.clearForces(row);
        unit.table = to;
        unit.row = row;
    }

    /** Lets the units keep the table, and creates a new one for the world. */
    @Override
    public void clear() {
        if (isEmpty()) return;
        Table old = state.table, table = new Table(0);
        int[] free = {0};
        table.owner = old.owner;
        old.owner = null;
        old.clearForces();
        state.table = table;
        list = spare = NONE;
        slots = free;
        modCount++;
    }

    /**
     * Restores a state. The units of the world become those with the saved ids; the others leave.
     *
     * @param known the saved units, in order, if this world was saved; null to take the present units with the saved
     *     ids, and units of the factory for missing ones
     * @param factory null for {@code new Unit}
     */
    void restore(State saved, Unit[] known, LongFunction<? extends Unit> factory) {
        int n = saved.table.size;
        if (isSame(saved.table, known)) {
            state.copy(saved);
            return;
        }
        if (spare.length < n) spare = new Unit[Math.max(n, list.length)];
        try {
            if (known != null) System.arraycopy(known, 0, spare, 0, n);
            else collect(saved.table, factory);
            check(saved.table);
            reserve(n);
            replace(saved);
        } finally {
            Arrays.fill(spare, null);
        }
    }

    /** Whether the saved units are the present ones, in the same order. */
    private boolean isSame(Table saved, Unit[] known) {
        if (saved.size != size()) return false;
        for (int i = 0; i < saved.size; i++) {
            if (saved.id[i] != state.table.id[i] || (known != null && known[i] != list[i])) return false;
        }
        return true;
    }

    /** Fills the spare array with the units that have the saved ids. */
    private void collect(Table saved, LongFunction<? extends Unit> factory) {
        int changes = modCount;
        Set<Unit> made = null;
        for (int i = 0; i < saved.size; i++) {
            long id = saved.id[i];
            Unit unit = find(id);
            if (unit == null) {
                unit = factory == null ? new Unit(1) : Check.notNull("the factory's unit", factory.apply(id));
                if (made == null) made = Collections.newSetFromMap(new IdentityHashMap<>());
                if (unit.table.owner != null || !made.add(unit)) {
                    throw new IllegalStateException(
                            "the factory must return a new unit for id " + id + ", was " + unit);
                }
                if (modCount != changes) throw new IllegalStateException("the factory must not change the world");
            }
            spare[i] = unit;
        }
    }

    private void check(Table saved) {
        for (int i = 0; i < saved.size; i++) {
            if (spare[i].table.owner != null && !has(spare[i])) {
                throw new IllegalStateException(
                        "unit " + saved.id[i] + " of the snapshot is now in another world: " + spare[i]);
            }
        }
    }

    /** Replaces the units by those in the spare array, and the state by a saved one. */
    private void replace(State saved) {
        int n = saved.table.size, leaving = size();
        for (int i = 0; i < n; i++) if (has(spare[i])) leaving--;
        Table left = leaving > 0 ? new Table(leaving) : null;
        for (int i = 0; i < n; i++) if (has(spare[i])) list[spare[i].row] = null; // does not leave
        for (int i = 0; i < size(); i++) if (list[i] != null) leave(list[i], left, --leaving);
        Unit[] old = list;
        list = spare;
        spare = old;
        state.copy(saved);
        for (int i = 0; i < n; i++) {
            list[i].table = state.table;
            list[i].row = i;
        }
        Arrays.fill(slots, 0);
        index();
        modCount++;
    }

    @Override
    public Unit get(int index) {
        checkIndex(index, size() - 1);
        return list[index];
    }

    private static void checkIndex(int index, int most) {
        if (index < 0 || index > most) {
            throw new IndexOutOfBoundsException("index must be from 0 to " + most + ", was " + index);
        }
    }

    @Override
    public int size() {
        return state.table.size;
    }

    @Override
    public boolean contains(Object o) {
        return indexOf(o) >= 0;
    }

    @Override
    public int indexOf(Object o) {
        return o instanceof Unit && has((Unit) o) ? ((Unit) o).row : -1;
    }

    @Override
    public int lastIndexOf(Object o) {
        return indexOf(o);
    }

    @Override
    public Iterator<Unit> iterator() {
        return new Cursor(0, size(), 0);
    }

    @Override
    public ListIterator<Unit> listIterator(int index) {
        return new Part(0, size()).listIterator(index);
    }

    @Override
    public List<Unit> subList(int from, int to) {
        return new Part(0, size()).subList(from, to);
    }

    private void checkUnchanged(int changes) {
        if (modCount == changes) return;
        throw new ConcurrentModificationException(
                "units were added, removed or reordered since this iterator or sublist was created");
    }

    /** The units from one index to another. After any addition or removal, its methods throw an exception. */
    private final class Part extends AbstractList<Unit> implements RandomAccess {
        private final int start, end, changes = Members.this.modCount;

        Part(int start, int end) {
            this.start = start;
            this.end = end;
        }

        @Override
        public Unit get(int index) {
            checkIndex(index, size() - 1);
            return list[start + index];
        }

        @Override
        public int size() {
            checkUnchanged(changes);
            return end - start;
        }

        @Override
        public Iterator<Unit> iterator() {
            return listIterator(0);
        }

        @Override
        public ListIterator<Unit> listIterator(int index) {
            checkIndex(index, size());
            return new Cursor(start, end, start + index);
        }

        @Override
        public List<Unit> subList(int from, int to) {
            checkIndex(to, size());
            checkIndex(from, to);
            return new Part(start + from, start + to);
        }
    }

    /**
     * An iterator over the units from one index to another. Every method detects an addition or removal of any unit.
     */
    private final class Cursor implements ListIterator<Unit> {
        private final int start;
        private int end, next, last = -1, changes = modCount;

        Cursor(int start, int end, int next) {
            this.start = start;
            this.end = end;
            this.next = next;
        }

        @Override
        public boolean hasNext() {
            checkUnchanged(changes);
            return next < end;
        }

        @Override
        public Unit next() {
            if (!hasNext()) throw new NoSuchElementException("there is no next unit");
            last = next++;
            return list[last];
        }

        @Override
        public boolean hasPrevious() {
            checkUnchanged(changes);
            return next > start;
        }

        @Override
        public Unit previous() {
            if (!hasPrevious()) throw new NoSuchElementException("there is no previous unit");
            last = --next;
            return list[last];
        }

        @Override
        public int nextIndex() {
            checkUnchanged(changes);
            return next - start;
        }

        @Override
        public int previousIndex() {
            return nextIndex() - 1;
        }

        /** Removes the unit that was returned last. The last unit of the world takes its index and is returned next. */
        @Override
        public void remove() {
            checkUnchanged(changes);
            if (last < 0) throw new IllegalStateException("next or previous must be called before each remove");
            Members.this.remove(last);
            next = last;
            last = -1;
            end--;
            changes = modCount;
        }

        @Override
        public void set(Unit unit) {
            throw new UnsupportedOperationException("units can be added only by World.add");
        }

        @Override
        public void add(Unit unit) {
            throw new UnsupportedOperationException("units can be added only by World.add");
        }
    }
}
