package yarts.physics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A team does each piece of work once and returns, with any use of its pool. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class TeamSharesTest {
    private static final int THINGS = 64;

    private final ForkJoinPool pool = new ForkJoinPool(4);
    private final Team team = new Team(pool, 8);

    @AfterEach
    void shutDown() {
        pool.shutdownNow();
    }

    private static void shareOnce(Team team) {
        AtomicIntegerArray times = new AtomicIntegerArray(THINGS);
        team.share(times::incrementAndGet, THINGS);
        int[] once = new int[THINGS], done = new int[THINGS];
        Arrays.fill(once, 1);
        for (int i = 0; i < THINGS; i++) done[i] = times.get(i);
        assertArrayEquals(once, done);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 7})
    void everyPieceIsDoneOnceInEachOfManyCalls(int threads) {
        ForkJoinPool own = new ForkJoinPool(threads);
        try {
            Team of = new Team(own, 8);
            for (int i = 0; i < 20_000; i++) shareOnce(of);
        } finally {
            own.shutdown();
        }
    }

    /** The pool is busy, so helpers of earlier calls still wait in it when its threads are free. */
    @Test
    void helpersOfEarlierCallsThatStillWaitChangeNothing() throws Exception {
        CountDownLatch busy = new CountDownLatch(1), begun = new CountDownLatch(4);
        for (int i = 0; i < 4; i++) {
            pool.execute(() -> {
                begun.countDown();
                awaitQuietly(busy);
            });
        }
        begun.await();
        for (int i = 0; i < 100; i++) shareOnce(team);
        assertEquals(4, pool.getQueuedSubmissionCount(), "helpers that have not begun, and no more than threads");
        AtomicLong sum = new AtomicLong();
        team.share(
                i -> {
                    if (i == 0) busy.countDown(); // now they start, in the middle of this call
                    sum.incrementAndGet();
                },
                THINGS);
        assertEquals(THINGS, sum.get());
        for (int i = 0; i < 1000; i++) shareOnce(team);
        assertTrue(pool.awaitQuiescence(1, TimeUnit.MINUTES));
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void anExceptionOfAPieceIsThrownAfterAllOthersAreDone() {
        for (int k = 0; k < 200; k++) {
            int bad = k % THINGS;
            AtomicLong others = new AtomicLong();
            Error error = new AssertionError("thrown by a piece");
            RuntimeException exception = new IllegalStateException("thrown by a piece");
            boolean isError = k % 8 < 4;
            Throwable thrown = assertThrows(
                    Throwable.class,
                    () -> team.share(
                            i -> {
                                if (i == bad && isError) throw error;
                                if (i == bad) throw exception;
                                others.incrementAndGet();
                            },
                            THINGS));
            assertSame(isError ? error : exception, thrown);
            assertEquals(THINGS - 1, others.get());
            shareOnce(team);
        }
    }

    /** The thread of the caller stays interrupted. */
    @Test
    void anInterruptDoesNotStopTheWork() {
        Thread.currentThread().interrupt();
        for (int i = 0; i < 1000; i++) shareOnce(team);
        assertTrue(Thread.interrupted());
    }

    /** The caller is not a thread of the common pool, so it counts in addition. */
    @Test
    void aThreadOfTheCommonPoolHelps() {
        assumeTrue(ForkJoinPool.getCommonPoolParallelism() > 0, "this machine has no common pool");
        CountDownLatch begun = new CountDownLatch(2);
        new Team(ForkJoinPool.commonPool(), 8)
                .share(
                        piece -> {
                            begun.countDown();
                            awaitQuietly(begun);
                        },
                        THINGS);
        assertEquals(0, begun.getCount());
    }

    /** A helper holds the last piece until the caller waits for it, and interrupts the caller then. */
    @Test
    void anInterruptWhileTheCallerWaitsIsPreserved() {
        Thread caller = Thread.currentThread();
        CountDownLatch helped = new CountDownLatch(1);
        AtomicIntegerArray times = new AtomicIntegerArray(THINGS);
        team.share(
                i -> {
                    if (Thread.currentThread() == caller) {
                        while (helped.getCount() > 0) Thread.onSpinWait();
                    } else {
                        helped.countDown();
                        awaitWaiting(caller);
                        caller.interrupt();
                        awaitWaiting(caller); // it has taken note of the interrupt, and waits again
                    }
                    times.incrementAndGet(i);
                },
                THINGS);
        for (int i = 0; i < THINGS; i++) assertEquals(1, times.get(i));
        assertTrue(Thread.interrupted());
    }

    private static void awaitWaiting(Thread thread) {
        while (thread.isInterrupted() || thread.getState() != Thread.State.WAITING) Thread.onSpinWait();
    }

    @Test
    void ifThePoolIsShutDownTheCallerDoesEverything() {
        pool.shutdownNow();
        for (int i = 0; i < 1000; i++) shareOnce(team);
    }

    /** Each piece waits until four threads have begun one. The caller alone would wait permanently. */
    @Test
    void piecesRunAtTheSameTimeInEveryCall() {
        for (int i = 0; i < 100; i++) {
            CountDownLatch begun = new CountDownLatch(4);
            team.share(
                    piece -> {
                        begun.countDown();
                        awaitQuietly(begun);
                    },
                    THINGS);
            assertEquals(0, begun.getCount());
        }
    }
}
