package yarts.physics.metamorphic;

import static yarts.physics.metamorphic.View.SAME;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.metamorphic.Play.Layout;

/**
 * A game played again, with something changed that must not matter, leads to the same bits: it needs no other rule for what
 * is right than that. Where the change is a mirror or a measure, to the same bits in the mirror and in the measure.
 */
class MetamorphicPropertyTest {
    private static final int FRAMES = 30;

    private static void same(
            long seed, Integrator integrator, boolean fixed, View view, Layout layout, Layout other, int frames) {
        Play play = new Play(seed, integrator, fixed, SAME, layout);
        Play changed = new Play(seed, integrator, fixed, view, other);
        play.assertSeen(changed, "at the start");
        for (int i = 0; i < frames; i++) {
            play.frame();
            changed.frame();
            play.assertSeen(changed, "frame " + i);
        }
    }

    /** A handful of units, or more than a block's. */
    private static Layout plain(long seed) {
        return Layout.plain(seed % 4 == 0 ? Tiles.TILE + 10 : 20);
    }

    private static void seen(long seed, Integrator integrator, boolean fixed, View view) {
        same(seed, integrator, fixed, view, plain(seed), plain(seed), FRAMES);
    }

    private static void laidOut(long seed, Integrator integrator, boolean fixed, Layout other) {
        same(seed, integrator, fixed, SAME, Layout.plain(other.order().length), other, FRAMES);
    }

    @Property(tries = 100)
    void axesSwapped(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        seen(seed, integrator, fixed, new View(true, 1, 1, 1, 1, 1));
    }

    @Property(tries = 100)
    void mirrored(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed, @ForAll boolean both) {
        seen(seed, integrator, fixed, new View(false, both ? -1 : 1, -1, 1, 1, 1));
    }

    /** Time is scaled with variable steps only: a second of fixed ones has a whole number of steps. */
    @Property(tries = 200)
    void scaledByPowersOfTwo(
            @ForAll long seed,
            @ForAll Integrator integrator,
            @ForAll boolean fixed,
            @ForAll @IntRange(min = -20, max = 20) int length,
            @ForAll @IntRange(min = -20, max = 20) int mass,
            @ForAll @IntRange(min = -9, max = 20) int time) {
        seen(seed, integrator, fixed, new View(false, 1, 1, power(length), power(mass), fixed ? 1 : power(time)));
    }

    private static double power(int exponent) {
        return Math.scalb(1.0, exponent);
    }

    @Property(tries = 100)
    void inAnotherOrder(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        Integer[] order = Arrays.stream(plain(seed).order()).boxed().toArray(Integer[]::new);
        Collections.shuffle(Arrays.asList(order), new Random(seed));
        laidOut(seed, integrator, fixed, new Layout(ints(List.of(order)), 1, 0, null));
    }

    private static int[] ints(List<Integer> list) {
        return list.stream().mapToInt(i -> i).toArray();
    }

    @Property(tries = 100)
    void inSeveralWorlds(
            @ForAll long seed,
            @ForAll Integrator integrator,
            @ForAll boolean fixed,
            @ForAll @IntRange(min = 2, max = 5) int worlds) {
        laidOut(seed, integrator, fixed, new Layout(plain(seed).order(), worlds, 0, null));
    }

    /** As many that sleep after each as leave one in a block, or some blocks between one and the next, or a few. */
    @Property(tries = 30)
    void amongSleepers(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        int[] order = Layout.plain(12).order();
        for (int sleepers : new int[] {1, Tiles.TILE, 2 * Tiles.TILE - 1}) {
            laidOut(seed, integrator, fixed, new Layout(order, 1, sleepers, null));
        }
    }

    /** Three slices, the last of them short of a block. */
    @Property(tries = 4)
    void onSeveralThreads(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        int units = 3 * Tiles.SHARE + 100;
        ForkJoinPool pool = new ForkJoinPool(3);
        try {
            Layout plain = Layout.plain(units);
            same(seed, integrator, fixed, SAME, plain, new Layout(plain.order(), 1, 0, pool), 6);
        } finally {
            pool.shutdown();
        }
    }
}
