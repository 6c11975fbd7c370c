package yarts.physics.demo;

import yarts.physics.support.Churn;

/** Twenty tanks in ranks and files, which keep their places behind their echelon's line as it moves and bends. */
final class Company {
    static final int FILES = 5, RANKS = 4;
    static final int SIZE = FILES * RANKS;
    static final double FILE = 4.3, RANK = 6.4; // m from one tank to the next
    /** From the first rank of a company to that of the one behind it. */
    static final double DEPTH = 30; // m

    /** How far the flanks of every second company hang back, for each file, and every second rank is shifted. */
    private static final double WEDGE = 1.9, STAGGER = FILE / 2; // m

    /** How far behind its place it begins, and how far before it a sally goes. */
    private static final double ASSEMBLY = 30, SALLY = 9; // m

    private static final double SALLY_TIME = 4; // s

    final Front.Line line;
    /** Where its middle file is, from north to south. */
    private final double middle;
    /** When it sets out, and when it turns back from a sally; in s. */
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

    /** Runs out before the others for a while. */
    void sally(double time) {
        until = time + SALLY_TIME;
    }

    void march(double time, double dt) {
        double goal = time < start ? ASSEMBLY : time < until ? -SALLY : 0;
        behind += Skirmish.limit(goal - behind, Front.PACE * dt);
    }

    /** Where a tank's place is, from north to south. */
    double y(int rank, int file) {
        return middle + (file - (FILES - 1) / 2.0) * FILE + STAGGER * (rank % 2 - 0.5);
    }

    /** How far its place is behind the company's first rank. */
    double back(int rank, int file) {
        return rank * RANK + (line.depth % 2 == 1 ? WEDGE * Math.abs(file - (FILES - 1) / 2.0) : 0);
    }

    /** Where a place is, from west to east. */
    double x(double back, double y) {
        double depth = Skirmish.NO_MANS_LAND / 2 + line.depth * DEPTH + behind + back;
        return line.at(y) + Skirmish.WIDTH / 2 + (line.west ? -depth : depth); // a sum first, as in Kernel
    }

    long hash(long hash) {
        return Churn.scramble(
                Churn.scramble(hash + Double.doubleToRawLongBits(behind)) + Double.doubleToRawLongBits(until));
    }
}
