package yarts.physics;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * The threads of a pool and the calling thread. All claim pieces of work from one counter. The caller waits only for
 * pieces that a helper has claimed. If the pool is busy, shut down or without threads, the caller does all pieces.
 */
final class Team implements Crew {
    /** The number of times that the caller checks for the end of the last pieces before it sleeps. */
    private static final int SPINS = 1000;

    private final ForkJoinPool pool;
    private final int threads;
    /** The minimum number of pieces for a thread. To wake a thread for fewer takes longer than the work. */
    private final int minPieces;
    /** The number of helpers that were submitted to the pool and have not begun. */
    private final AtomicInteger waiting = new AtomicInteger();

    Team(ForkJoinPool pool, int minPieces) {
        this.pool = pool;
        this.minPieces = minPieces;
        boolean common = pool == ForkJoinPool.commonPool(); // its parallelism excludes the caller
        threads = pool.getParallelism() + (common ? 1 : 0);
    }

    @Override
    public void share(Work work, int n) {
        int helpers = Math.min(threads, n / minPieces) - 1;
        Job job = helpers > 0 ? start(work, n, helpers) : null;
        if (job == null) {
            for (int i = 0; i < n; i++) work.run(i);
        } else {
            job.help();
            job.await();
        }
    }

    /** Submits helpers, before any work is done. Returns null if there is not enough memory for a job. */
    private Job start(Work work, int n, int helpers) {
        Job job;
        try {
            job = new Job(work, n);
        } catch (OutOfMemoryError e) {
            return null;
        }
        try {
            for (int i = 0; i < helpers && waiting.get() < threads; i++) {
                waiting.incrementAndGet();
                pool.execute(() -> {
                    waiting.decrementAndGet();
                    job.help();
                });
            }
        } catch (RuntimeException | Error e) {
            // The pool is shut down or cannot start a thread. It may have accepted the helper before, so the helper
            // still counts.
        }
        return job;
    }

    /** The pieces of one call, and the numbers of those that are claimed and done. */
    private static final class Job {
        private final Work work;
        private final int n;
        private final Thread caller = Thread.currentThread();
        private final AtomicInteger next = new AtomicInteger(), done = new AtomicInteger();
        private volatile Throwable failure;

        Job(Work work, int n) {
            this.work = work;
            this.n = n;
        }

        /** Claims pieces and does them until all are claimed. */
        void help() {
            for (int i = next.getAndIncrement(); i < n; i = next.getAndIncrement()) {
                try {
                    work.run(i);
                } catch (Throwable e) {
                    failure = e;
                }
                if (done.incrementAndGet() == n && Thread.currentThread() != caller) LockSupport.unpark(caller);
            }
        }

        /**
         * Waits until all pieces are done, and preserves an interrupt. Throws the exception that a piece has thrown.
         */
        void await() {
            boolean interrupted = false;
            for (int spins = 0; done.get() < n; spins++) {
                if (spins < SPINS) continue;
                LockSupport.park(this);
                interrupted |= Thread.interrupted();
            }
            if (interrupted) Thread.currentThread().interrupt();
            if (failure instanceof Error) throw (Error) failure;
            if (failure != null) throw (RuntimeException) failure;
        }
    }
}
