package yarts.physics;

import java.util.TreeSet;

/** Where one block of a world ends and the next begins, for tests that try the borders. */
public final class Blocks {
    /** Most units of a block. */
    public static final int BLOCK = Columns.BLOCK;

    /** Most units of blocks that share their arrays. */
    public static final int SHARED = Columns.SHARED;

    /** The fewest units of a thread's slice. */
    public static final int SLICE = Stepper.LEAST * Columns.BLOCK;

    private Blocks() {}

    /** {@return the sizes of worlds at and beside every border up to the second block of other arrays, in order} */
    public static int[] sizes() {
        TreeSet<Integer> sizes = new TreeSet<>();
        for (int border : new int[] {1, Columns.LANES, BLOCK, 2 * BLOCK, SHARED, SHARED + BLOCK}) {
            for (int size = border - 1; size <= border + 1; size++) sizes.add(size);
        }
        return sizes.stream().mapToInt(size -> size).toArray();
    }

    /** The next unit that is made, or leaves a world, needs arrays of its own. */
    public static void fillNursery() {
        int row = 0;
        while (row != Columns.LANES - 1) row = new Unit(1).row;
    }
}
