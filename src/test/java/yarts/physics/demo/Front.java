package yarts.physics.demo;

import yarts.physics.support.Churn;

/**
 * The line between the armies: a curve from north to south through some points, which orders move west and east. Each echelon
 * of an army receives an order after its own delay, and follows with a line of its own.
 */
final class Front {
    private static final int POINTS = 9;
    private static final double SPACING = Skirmish.HEIGHT / (POINTS - 1); // m

    static final double PACE = 7; // m/s
    /** The maximum distance of the front from the middle of the map, and of a point from its neighbours, from west to east. */
    private static final double FARTHEST = 34, STEEPEST = 17; // m

    private static final double SHORTEST = 12; // m: shorter moves are not ordered
    /** The army that withdraws moves first, its rear before its front; the other army follows after a delay. */
    private static final double ECHELON_DELAY = 0.5, ATTACK_DELAY = 2.6; // s

    /** The ordered places of the points, east of the middle of the map; in m. */
    private final double[] ordered = new double[POINTS];

    private final Line[] lines;

    /** The line of one echelon: where it is, and the places that it was ordered to. */
    final class Line {
        final boolean west;
        final int depth;
        private final double[] at = new double[POINTS], goal = new double[POINTS];
        /** The times at which it receives the last orders; in s. */
        private final double[] when = new double[POINTS];

        Line(boolean west, int depth) {
            this.west = west;
            this.depth = depth;
        }

        private void march(double time, double dt) {
            for (int k = 0; k < POINTS; k++) {
                if (time >= when[k]) goal[k] = ordered[k];
                at[k] += Skirmish.limit(goal[k] - at[k], PACE * dt);
            }
        }

        /** The line's distance east of the middle of the map at a given y, smooth between two points; in m. */
        double at(double y) {
            double s = Math.max(0, Math.min(POINTS - 1, y / SPACING));
            int k = Math.min((int) s, POINTS - 2);
            double w = s - k;
            return at[k] + (at[k + 1] - at[k]) * w * w * (3 - 2 * w);
        }
    }

    Front(int echelons) {
        lines = new Line[2 * echelons];
        for (int i = 0; i < lines.length; i++) lines[i] = new Line(i % 2 == 0, i / 2);
    }

    Line line(boolean west, int depth) {
        return lines[2 * depth + (west ? 0 : 1)];
    }

    void march(double time, double dt) {
        for (Line line : lines) line.march(time, dt);
    }

    /** Orders a point to a new place. Its neighbours follow where they would be too far away. */
    void order(Dice dice, double time) {
        int point = dice.below(POINTS);
        double next = dice.within(FARTHEST);
        if (Math.abs(next - ordered[point]) < SHORTEST) return;
        for (int k = 0; k < POINTS; k++) {
            double bulge = STEEPEST * Math.abs(k - point);
            double goal = next + Skirmish.limit(ordered[k] - next, bulge);
            if (goal != ordered[k]) order(k, goal, time);
        }
    }

    private void order(int point, double goal, double time) {
        ordered[point] = goal;
        int last = lines.length / 2 - 1;
        for (Line line : lines) {
            boolean eastwards = goal > line(line.west, 0).at[point], follows = line.west == eastwards;
            line.when[point] =
                    time + (follows ? ATTACK_DELAY + line.depth * ECHELON_DELAY : (last - line.depth) * ECHELON_DELAY);
        }
    }

    long hash(long hash) {
        for (double goal : ordered) hash = Churn.scramble(hash + Double.doubleToRawLongBits(goal));
        for (Line line : lines) {
            for (int k = 0; k < POINTS; k++) {
                hash = Churn.scramble(hash + Double.doubleToRawLongBits(line.at[k]));
                hash = Churn.scramble(hash + Double.doubleToRawLongBits(line.goal[k]));
                hash = Churn.scramble(hash + Double.doubleToRawLongBits(line.when[k]));
            }
        }
        return hash;
    }
}
