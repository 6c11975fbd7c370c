package yarts.physics;

import java.util.TreeSet;

/** The sizes of tiles, for tests at their borders. */
public final class Tiles {
    /** The number of units in a tile. */
    public static final int TILE = Table.TILE;

    /** The fewest units for a thread. */
    public static final int SHARE = Stepper.MIN_TILES * Table.TILE;

    private Tiles() {}

    /** {@return the sizes of worlds at and beside every border up to the third tile, in order} */
    public static int[] sizes() {
        TreeSet<Integer> sizes = new TreeSet<>();
        for (int border : new int[] {1, Table.LANES, TILE, 2 * TILE, 3 * TILE}) {
            for (int size = border - 1; size <= border + 1; size++) sizes.add(size);
        }
        return sizes.stream().mapToInt(size -> size).toArray();
    }
}
