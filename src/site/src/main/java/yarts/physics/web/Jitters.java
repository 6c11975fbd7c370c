package yarts.physics.web;

import java.util.Arrays;
import yarts.physics.World;

/** Which units jitter: each of the last three ticks has turned them round. */
final class Jitters {
    /** One or two may be the game's: an order, a shove, a blast. */
    private static final int TURNS = 3;

    private final double[] last, now;
    private final int[] turns;

    Jitters(int units) {
        last = new double[2 * units];
        now = new double[2 * units];
        turns = new int[units];
    }

    void clear() {
        Arrays.fill(last, 0);
        Arrays.fill(turns, 0);
    }

    /** To be called after every tick. */
    void look(World world) {
        world.copyVelocities(now, 0);
        for (int i = 0; i < turns.length; i++) {
            double vx = now[2 * i], vy = now[2 * i + 1];
            turns[i] = vx * last[2 * i] + vy * last[2 * i + 1] < 0 ? turns[i] + 1 : 0;
        }
        System.arraycopy(now, 0, last, 0, now.length);
    }

    boolean has(int unit) {
        return turns[unit] >= TURNS;
    }

    int count() {
        int count = 0;
        for (int turned : turns) if (turned >= TURNS) count++;
        return count;
    }
}
