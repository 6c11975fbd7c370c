package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A world has the same bits with any number of threads, in any state of the pool. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // a step that never ends must fail, not block
class TeamTest {
    /** Enough units for seven threads. */
    private static final int MANY = 7 * Tiles.SHARE + 100;

    private final List<ForkJoinPool> pools = new ArrayList<>();

    private ForkJoinPool pool(int threads) {
        ForkJoinPool pool = new ForkJoinPool(threads);
        pools.add(pool);
        return pool;
    }

    @AfterEach
    void shutDown() {
        pools.forEach(ForkJoinPool::shutdown);
    }

    /** All units differ: some have forces, some are at their cap, some are at rest. */
    private static World crowd(Integrator integrator, int units) {
        World world = new World(integrator, Timestep.fixed(60));
        for (int i = 0; i < units; i++) {
            Unit unit = new Unit(1 + i % 97).setFriction(i % 13).setPosition(i, -i);
            world.add(unit.setVelocity(i % 29, 0.1 * i).setMaxSpeed(i % 7 == 0 ? 5 : 1e4));
        }
        return world;
    }

    /** Runs every kind of step; returns the hash after each. */
    private static List<Long> play(World world) {
        List<Long> hashes = new ArrayList<>();
        double[] lengths = {1 / 60.0, 1 / 60.0, 0.02, 0};
        for (int frame = 0; frame < 8; frame++) {
            for (int i = frame; i < world.size(); i += 3) world.get(i).applyForce(i, -10 * frame);
            if (frame % 2 == 0) world.step(lengths[frame / 2]);
            else world.advance(0.012 * frame); // none, one or more steps
            hashes.add(world.stateHash());
        }
        return hashes;
    }

    private static List<Long> alone(Integrator integrator, int units) {
        return play(crowd(integrator, units));
    }

    @ParameterizedTest
    @EnumSource
    void anyNumberOfThreadsGivesTheSameBits(Integrator integrator) {
        List<Long> expected = alone(integrator, MANY);
        assertEquals(8, expected.stream().distinct().count(), "every frame changes something");
        for (int threads : new int[] {1, 2, 3, 4, 7}) {
            World world = crowd(integrator, MANY);
            world.setPool(pool(threads));
            assertEquals(expected, play(world), threads + " threads");
        }
    }

    /** Numbers of units at the borders of tiles, and of the work of one, two and three threads. */
    static IntStream sizes() {
        int tile = Tiles.TILE, two = 2 * Tiles.SHARE - tile, three = 3 * Tiles.SHARE - tile;
        IntStream ends = IntStream.of(tile / 2, tile, Tiles.SHARE, two, 2 * Tiles.SHARE, three)
                .flatMap(end -> IntStream.of(end - 1, end, end + 1));
        return IntStream.concat(
                IntStream.of(0, 1), IntStream.concat(ends, IntStream.of(three + tile / 2, 3 * Tiles.SHARE + 800)));
    }

    @ParameterizedTest
    @MethodSource("sizes")
    void severalThreadsStepEachUnitOnce(int units) {
        for (Integrator integrator : Integrator.values()) {
            World world = crowd(integrator, units);
            world.setPool(pool(3));
            assertEquals(alone(integrator, units), play(world), integrator.toString());
        }
    }

    /** As many threads as tiles, or fewer, or more. */
    static Stream<Arguments> fewTiles() {
        return IntStream.of(0, 1, Tiles.TILE / 2, Tiles.TILE, 2 * Tiles.TILE, 7 * Tiles.TILE)
                .flatMap(end -> IntStream.of(end - 1, end, end + 1))
                .filter(units -> units >= 0)
                .boxed()
                .flatMap(units -> Stream.of(2, 7).map(threads -> Arguments.of(units, threads)));
    }

    @ParameterizedTest
    @MethodSource("fewTiles")
    void moreThreadsThanTilesGiveTheSameBits(int units, int threads) {
        for (Integrator integrator : Integrator.values()) {
            World world = crowd(integrator, units);
            world.setPool(pool(threads));
            assertEquals(alone(integrator, units), play(world), integrator.toString());
        }
    }

    @Test
    void theCommonPoolGivesTheSameBits() {
        World world = crowd(Integrator.EXACT, MANY);
        world.setPool(ForkJoinPool.commonPool());
        assertEquals(alone(Integrator.EXACT, MANY), play(world));
    }

    @Test
    void theThreadsOfThePoolTakePart() {
        ForkJoinPool pool = pool(4);
        World world = crowd(Integrator.EULER, MANY);
        play(world);
        assertEquals(0, pool.getPoolSize());
        world.setPool(pool);
        play(world);
        assertTrue(pool.getPoolSize() > 0);
    }

    @Test
    void aSmallWorldUsesNoThreads() {
        ForkJoinPool pool = pool(4);
        World world = crowd(Integrator.EULER, 2 * Tiles.SHARE - Tiles.TILE);
        world.setPool(pool);
        play(world);
        assertEquals(0, pool.getPoolSize());
        world.add(new Unit(1));
        play(world);
        assertTrue(pool.getPoolSize() > 0);
    }

    @Test
    void ifThePoolIsShutDownTheCallerDoesTheWork() throws Exception {
        ForkJoinPool never = pool(4), used = pool(4);
        never.shutdown();
        World world = crowd(Integrator.MIDPOINT, MANY);
        world.setPool(never);
        assertEquals(alone(Integrator.MIDPOINT, MANY), play(world));

        World other = crowd(Integrator.MIDPOINT, MANY);
        other.setPool(used);
        World alone = crowd(Integrator.MIDPOINT, MANY);
        assertEquals(play(alone), play(other));
        used.shutdownNow();
        assertTrue(used.awaitTermination(1, TimeUnit.MINUTES));
        assertEquals(play(alone), play(other));
    }

    /** Both workers are busy, so the helper still waits when the pool discards waiting tasks. */
    @Test
    void aShutdownOfThePoolDuringAStepLosesNoWork() throws Exception {
        World alone = crowd(Integrator.EULER, MANY), world = crowd(Integrator.EULER, MANY);
        ForkJoinPool pool = pool(2), caller = pool(1);
        for (int i = 0; i < 2; i++) pool.execute(() -> LockSupport.parkNanos(Long.MAX_VALUE));
        while (pool.hasQueuedSubmissions()) Thread.onSpinWait();
        world.setPool(pool);
        ForkJoinTask<?> step = caller.submit(() -> world.step(0.1));
        while (!pool.hasQueuedSubmissions()) Thread.onSpinWait();
        pool.shutdownNow();
        step.get();
        alone.step(0.1);
        assertEquals(alone.stateHash(), world.stateHash());
        assertEquals(play(alone), play(world));
    }

    @Test
    void aListenerMaySetThePoolForTheStepAfterIt() {
        ForkJoinPool[] inTurn = {pool(2), null, pool(5), ForkJoinPool.commonPool()};
        World world = crowd(Integrator.EXACT, MANY);
        int[] step = {0};
        world.addBeforeStep((w, dt) -> w.setPool(inTurn[step[0]++ % inTurn.length]));
        assertEquals(alone(Integrator.EXACT, MANY), play(world));
        assertTrue(step[0] > 8 && inTurn[0].getPoolSize() > 0 && inTurn[2].getPoolSize() > 0);
    }

    @Test
    void afterSetPoolNullTheCallerStepsAlone() {
        ForkJoinPool pool = pool(2);
        World world = crowd(Integrator.EULER, MANY);
        world.setPool(pool);
        world.setPool(null);
        assertEquals(alone(Integrator.EULER, MANY), play(world));
        assertEquals(0, pool.getPoolSize());
    }

    /** One worker, or all at the same time, so that no thread of the pool is free to help. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void threadsOfThePoolMayStepWorlds(int worlds) throws Exception {
        ForkJoinPool pool = pool(3);
        List<Long> expected = alone(Integrator.EXACT, MANY);
        List<ForkJoinTask<List<Long>>> games = new ArrayList<>();
        for (int i = 0; i < worlds; i++) {
            World world = crowd(Integrator.EXACT, MANY);
            world.setPool(pool);
            games.add(pool.submit(() -> play(world)));
        }
        for (ForkJoinTask<List<Long>> game : games) assertEquals(expected, game.get());
    }

    @Test
    void twoWorldsOnTwoThreadsMayShareAPool() throws Exception {
        ForkJoinPool shared = pool(3), callers = pool(2);
        List<Callable<List<Long>>> games = new ArrayList<>();
        for (Integrator integrator : new Integrator[] {Integrator.EULER, Integrator.EXACT}) {
            World world = crowd(integrator, MANY);
            world.setPool(shared);
            games.add(() -> play(world));
        }
        List<Future<List<Long>>> played = callers.invokeAll(games);
        assertEquals(alone(Integrator.EULER, MANY), played.get(0).get());
        assertEquals(alone(Integrator.EXACT, MANY), played.get(1).get());
    }
}
