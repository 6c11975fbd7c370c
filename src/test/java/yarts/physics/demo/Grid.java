package yarts.physics.demo;

import java.util.Arrays;

/** Finds points that are close to each other: square cells, each with a linked list of its points. Creates no garbage. */
final class Grid {
    /** Takes two points by their indices. */
    interface Pair {
        void accept(int i, int j);
    }

    private static final int NONE = -1;

    private final double cell;
    private final int columns;
    private final int rows;
    private final int[] head;
    private final int[] next;
    private final int[] cellOf;

    Grid(double width, double height, double cell, int points) {
        this.cell = cell;
        columns = (int) (width / cell) + 3; // with an empty column on either side, so that each cell has neighbours
        rows = (int) (height / cell) + 3;
        head = new int[columns * rows];
        next = new int[points];
        cellOf = new int[points];
    }

    /** Sorts the points into cells. Points outside the map go into the cells at its edge. */
    void fill(double[] x, double[] y) {
        Arrays.fill(head, NONE);
        for (int i = 0; i < next.length; i++) {
            int c = clamp(y[i], rows) * columns + clamp(x[i], columns);
            cellOf[i] = c;
            next[i] = head[c];
            head[c] = i;
        }
    }

    private int clamp(double v, int n) {
        return 1 + Math.max(0, Math.min(n - 3, (int) (v / cell)));
    }

    /** Visits all pairs of points on the map that are closer than the width of a cell, and some others, once each. */
    void forEachPair(Pair pair) {
        for (int i = 0; i < next.length; i++) {
            int c = cellOf[i];
            visit(i, next[i], pair);
            visit(i, head[c + 1], pair);
            visit(i, head[c + columns - 1], pair);
            visit(i, head[c + columns], pair);
            visit(i, head[c + columns + 1], pair);
        }
    }

    private void visit(int i, int first, Pair pair) {
        for (int j = first; j != NONE; j = next[j]) pair.accept(i, j);
    }
}
