package yarts.physics.demo;

import yarts.physics.support.Churn;

/** Twenty tanks in ranks and files. They keep their places behind their echelon's line, which moves and bends. */
final class Company {
    static final int FILES = 5, RANKS = 4;
    static final int SIZE = FILES * RANKS;
    static final double FILE = 4.3, RANK = 6.4; // m from one tank to the next
    /** From the first rank of a company to the first rank of the company behind it. */
    static final double DEPTH = 30; // m

    /** Flanks of every second company are WEDGE back for each file; every second rank is shifted by STAGGER. */
    private static final double WEDGE = 1.9, STAGGER = FILE / 2; // m

    /** Its distance behind its place at the start, and in front of it in a sally. */
    private static final double ASSEMBLY = 30, SALLY = 9; // m

    private static final double SALLY_TIME = 4; // s

    final Front.Line line;
    /** The place of its middle file, from north to south; in m. */
    private final double middle;
    /** The times at which it sets out and at which it returns from a sally; in s. */
    private final double start;

    private double until;
    private double behind = ASSEMBLY; // m

    Company(Front.Line line, double middle, double start) {
        this.line = line;
        this.middle = middle;
        this.start = start;
    }

    boolean isWest() {
        return line.west;
    }

    /** Advances in front of the others for some seconds. */
    void sally(double time) {
        until = time + SALLY_TIME;
    }

    void march(double time, double dt) {
        double goal = time < start ? ASSEMBLY : time < until ? -SALLY : 0;
        behind += Skirmish.limit(goal - behind, Front.PACE * dt);
    }

    /** A tank's place, from north to south; in m. */
    double y(int rank, int file) {
        return middle + (file - (FILES - 1) / 2.0) * FILE + STAGGER * (rank % 2 - 0.5);
    }

    /** The distance of a tank's place from the company's first rank; in m. */
    double back(int rank, int file) {
        return rank * RANK + (line.depth % 2 == 1 ? WEDGE * Math.abs(file - (FILES - 1) / 2.0) : 0);
    }

    /** A tank's place, from west to east; in m. */
    double x(double back, double y) {
        double depth = Skirmish.NO_MANS_LAND / 2 + line.depth * DEPTH + behind + back;
        return line.at(y)
                + Skirmish.WIDTH / 2
                + (line.west ? -depth : depth); // the sum first, as in Kernel: the same bits everywhere
    }

    long hash(long hash) {
        return Churn.scramble(
                Churn.scramble(hash + Double.doubleToRawLongBits(behind)) + Double.doubleToRawLongBits(until));
    }
}
