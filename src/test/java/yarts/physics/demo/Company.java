package yarts.physics.demo;

/** Some ranks of tanks that move as one: their places are counted from the front line, which orders move. */
final class Company {
    static final int FILES = 10, RANKS = 5;
    static final int SIZE = FILES * RANKS;
    static final double FILE = 5.2, RANK = 6; // m from one tank to the next
    /** From the first rank of a company to that of the one behind it. */
    static final double DEPTH = RANKS * RANK + 6; // m

    final boolean west;
    final int lane;
    /** How many companies of the lane are before it. */
    final int depth;
    /** Where the middle of no man's land is, as this company has been told. */
    double front;

    private double next;
    private double when = Double.POSITIVE_INFINITY;

    Company(boolean west, int lane, int depth, double front) {
        this.west = west;
        this.lane = lane;
        this.depth = depth;
        this.front = front;
    }

    /** Goes there at a time. */
    void order(double next, double when) {
        this.next = next;
        this.when = when;
    }

    void obey(double time) {
        if (time < when) return;
        front = next;
        when = Double.POSITIVE_INFINITY;
    }

    /** Where a rank is to stand. */
    double x(int rank) {
        double behind = Skirmish.NO_MANS_LAND / 2 + depth * DEPTH + rank * RANK;
        return west ? front - behind : front + behind;
    }

    double y(int file) {
        double middle = Skirmish.HEIGHT / 2 + (lane - (Skirmish.LANES - 1) / 2.0) * Skirmish.LANE;
        return middle + (file - (FILES - 1) / 2.0) * FILE;
    }
}
