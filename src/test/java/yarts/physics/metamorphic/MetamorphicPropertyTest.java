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
 * A game that is played again with an irrelevant change has the same bits. If the change is a mirror or another
 * measure, it has the same bits in the mirror or in that measure. No other reference is necessary.
 */
class MetamorphicPropertyTest {
    private static final int FRAMES = 30;

    private static void assertSame(
            long seed, Integrator integrator, boolean fixed, View view, Layout layout, Layout other, int frames) {
        Play play = new Play(seed, integrator, fixed, SAME, layout);
        Play changed = new Play(seed, integrator, fixed, view, other);
        play.assertEqualInView(changed, "at the start");
        for (int i = 0; i < frames; i++) {
            play.frame();
            changed.frame();
            play.assertEqualInView(changed, "frame " + i);
        }
    }

    /** A few units, or more than a tile has. */
    private static Layout plain(long seed) {
        return Layout.plain(seed % 4 == 0 ? Tiles.TILE + 10 : 20);
    }

    private static void assertSameInView(long seed, Integrator integrator, boolean fixed, View view) {
        assertSame(seed, integrator, fixed, view, plain(seed), plain(seed), FRAMES);
    }

    private static void assertSameWithLayout(long seed, Integrator integrator, boolean fixed, Layout other) {
        assertSame(seed, integrator, fixed, SAME, Layout.plain(other.order().length), other, FRAMES);
    }

    @Property(tries = 100)
    void aGameWithSwappedAxesHasTheSameBits(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        assertSameInView(seed, integrator, fixed, new View(true, 1, 1, 1, 1, 1));
    }

    @Property(tries = 100)
    void aMirroredGameHasTheSameBits(
            @ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed, @ForAll boolean both) {
        assertSameInView(seed, integrator, fixed, new View(false, both ? -1 : 1, -1, 1, 1, 1));
    }

    /** Time is scaled only with variable steps: a second has a whole number of fixed ones. */
    @Property(tries = 200)
    void aGameInMeasuresScaledByPowersOfTwoHasTheSameBits(
            @ForAll long seed,
            @ForAll Integrator integrator,
            @ForAll boolean fixed,
            @ForAll @IntRange(min = -20, max = 20) int length,
            @ForAll @IntRange(min = -20, max = 20) int mass,
            @ForAll @IntRange(min = -9, max = 20) int time) {
        assertSameInView(
                seed, integrator, fixed, new View(false, 1, 1, power(length), power(mass), fixed ? 1 : power(time)));
    }

    private static double power(int exponent) {
        return Math.scalb(1.0, exponent);
    }

    @Property(tries = 100)
    void aGameInAnotherOrderOfUnitsHasTheSameBits(
            @ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        Integer[] order = Arrays.stream(plain(seed).order()).boxed().toArray(Integer[]::new);
        Collections.shuffle(Arrays.asList(order), new Random(seed));
        assertSameWithLayout(seed, integrator, fixed, new Layout(ints(List.of(order)), 1, 0, null));
    }

    private static int[] ints(List<Integer> list) {
        return list.stream().mapToInt(i -> i).toArray();
    }

    @Property(tries = 100)
    void aGameInSeveralWorldsHasTheSameBits(
            @ForAll long seed,
            @ForAll Integrator integrator,
            @ForAll boolean fixed,
            @ForAll @IntRange(min = 2, max = 5) int worlds) {
        assertSameWithLayout(seed, integrator, fixed, new Layout(plain(seed).order(), worlds, 0, null));
    }

    /** Between the units of the game are so many units at rest that each tile has several of the game, one, or none. */
    @Property(tries = 30)
    void aGameAmongUnitsAtRestHasTheSameBits(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        int[] order = Layout.plain(12).order();
        for (int sleepers : new int[] {1, Tiles.TILE, 2 * Tiles.TILE - 1}) {
            assertSameWithLayout(seed, integrator, fixed, new Layout(order, 1, sleepers, null));
        }
    }

    /** Work for three threads, with an incomplete last tile. */
    @Property(tries = 4)
    void aGameOnSeveralThreadsHasTheSameBits(@ForAll long seed, @ForAll Integrator integrator, @ForAll boolean fixed) {
        int units = 3 * Tiles.SHARE + 100;
        ForkJoinPool pool = new ForkJoinPool(3);
        try {
            Layout plain = Layout.plain(units);
            assertSame(seed, integrator, fixed, SAME, plain, new Layout(plain.order(), 1, 0, pool), 6);
        } finally {
            pool.shutdown();
        }
    }
}
