package yarts.physics;

import java.util.Arrays;

/** A list of units as {@link Columns}: blocks of as many rows as one can have, and a last one. */
final class Table {
    private Columns[] blocks = {};
    private int size;

    int size() {
        return size;
    }

    /** How many blocks have rows. */
    int blocks() {
        return (size + Columns.BLOCK - 1) / Columns.BLOCK;
    }

    Columns block(int k) {
        return blocks[k];
    }

    /** The block of the row with an index in the table. */
    Columns at(int index) {
        return blocks[index / Columns.BLOCK];
    }

    /** The row with an index in the table, as its block counts. */
    static int row(int index) {
        return index % Columns.SHARED;
    }

    long id(int index) {
        return at(index).id[row(index)];
    }

    /** Takes the last row away. */
    void removeLast() {
        size--;
        at(size).clear(row(size));
    }

    /** Has n rows, no fewer than now. */
    void resize(int n) {
        reserve(n);
        for (int k = size / Columns.BLOCK; k * Columns.BLOCK < n; k++) blocks[k].end = end(k, n);
        size = n;
    }

    /** Makes room for n rows: all of {@link #resize} that takes memory, and so may fail. */
    void reserve(int n) {
        for (int k = size / Columns.BLOCK; k * Columns.BLOCK < n; k++) {
            if (k == blocks.length) add(n);
            if (end(k, n) > blocks[k].capacity()) grow(k, n - blocks[k].origin);
        }
    }

    /** Where block k ends in a table of n rows. */
    private int end(int k, int n) {
        return Math.min(n - blocks[k].origin, blocks[k].start + Columns.BLOCK);
    }

    /** Adds a block, for a table of n rows. */
    private void add(int n) {
        int k = blocks.length, start = row(k * Columns.BLOCK), origin = k * Columns.BLOCK - start;
        Columns block = start > 0
                ? new Columns(blocks[k - 1], start)
                : new Columns(origin, Columns.lanes(Math.min(n - origin, Columns.SHARED)));
        blocks = Arrays.copyOf(blocks, k + 1);
        blocks[k] = block;
    }

    /** Makes room for some rows in the arrays of block k, the last that shares them. */
    private void grow(int k, int rows) {
        int first = k - blocks[k].start / Columns.BLOCK;
        int capacity = Math.max(Columns.lanes(rows), 2 * blocks[k].capacity());
        blocks[first].grow(Math.min(capacity, Columns.SHARED));
        for (int j = first + 1; j <= k; j++) blocks[j].share(blocks[first]);
    }

    /** The rows of another table become those of this one. */
    void copy(Table other) {
        for (int k = other.blocks(); k < blocks(); k++) blocks[k].clear(blocks[k].start);
        if (other.size > size) resize(other.size);
        size = other.size;
        for (int k = 0; k < blocks(); k++) blocks[k].copy(other.blocks[k]);
    }
}
