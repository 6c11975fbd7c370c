package yarts.physics.faults;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinPool.ForkJoinWorkerThreadFactory;
import java.util.concurrent.ForkJoinWorkerThread;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import yarts.physics.Integrator;
import yarts.physics.Tiles;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** With a pool whose threads do not start, die or are interrupted, the step is the same; the caller does the work. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PoolFaultsTest {
    private static World crowd() {
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 0; i < 3 * Tiles.SHARE + 7; i++) {
            world.add(new Unit(1 + i % 9)).setFriction(i % 5).setVelocity(i % 29, -1);
        }
        return world;
    }

    private static long play(World world) {
        for (int i = 0; i < 5; i++) {
            for (int k = i; k < world.size(); k += 3) world.get(k).applyForce(k, -i);
            world.step();
            world.advance(0.04);
        }
        return world.stateHash();
    }

    private static ForkJoinPool of(ForkJoinWorkerThreadFactory factory) {
        return new ForkJoinPool(3, factory, null, false);
    }

    static Stream<Supplier<ForkJoinPool>> pools() {
        return Stream.of(
                () -> of(pool -> null),
                () -> of(pool -> {
                    throw new IllegalStateException("no threads");
                }),
                () -> of(pool -> {
                    throw new OutOfMemoryError("unable to create native thread");
                }),
                () -> of(Stillborn::new),
                () -> of(pool -> {
                    ForkJoinWorkerThread thread = ForkJoinPool.defaultForkJoinWorkerThreadFactory.newThread(pool);
                    thread.interrupt();
                    return thread;
                }));
    }

    /** A thread that throws when it starts. */
    private static final class Stillborn extends ForkJoinWorkerThread {
        Stillborn(ForkJoinPool pool) {
            super(pool);
            setUncaughtExceptionHandler((thread, e) -> {}); // the exception is expected
        }

        @Override
        protected void onStart() {
            throw new IllegalStateException("no start");
        }
    }

    @ParameterizedTest
    @MethodSource("pools")
    void ifThePoolHasNoThreadsTheCallerDoesTheWork(Supplier<ForkJoinPool> pools) {
        long expected = play(crowd());
        World world = crowd();
        ForkJoinPool pool = pools.get();
        try {
            world.setPool(pool);
            assertEquals(expected, play(world));
        } finally {
            pool.shutdownNow();
        }
    }

    /** A game is often stopped by an interrupt of its thread: the step completes, and the thread stays interrupted. */
    @Test
    void anInterruptBeforeOrDuringAStepIsPreservedAndChangesNothing() throws Exception {
        long expected = play(crowd());
        World world = crowd();
        ForkJoinPool pool = new ForkJoinPool(2);
        world.setPool(pool);
        Thread.currentThread().interrupt();
        assertEquals(expected, play(world));
        assertTrue(Thread.interrupted());

        World other = crowd();
        other.setPool(pool);
        Thread player = Thread.currentThread();
        AtomicBoolean over = new AtomicBoolean();
        Thread interrupter = new Thread(() -> {
            while (!over.get()) player.interrupt();
        });
        interrupter.start();
        while (!player.isInterrupted()) Thread.onSpinWait();
        assertEquals(expected, play(other));
        over.set(true);
        assertTrue(Thread.interrupted());
        pool.shutdown();
    }
}
