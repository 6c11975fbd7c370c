package yarts.physics;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * The threads of a pool and the calling thread. All claim pieces of work from one counter. The caller waits only for
 * pieces that a helper has claimed: if the pool is busy, shut down or without threads, the caller does all of them.
 */
final class Team implements Crew {
    /** How often the caller looks for the end of the last pieces before it sleeps. */
    private static final int LOOKS = 1000;

    private final ForkJoinPool pool;
    private final int threads;
    /** The fewest pieces for a thread: waking it for less takes longer than the work. */
    private final int least;
    /** Helpers that wait in the pool and have not begun. */
    private final AtomicInteger waiting = new AtomicInteger();

    Team(ForkJoinPool pool, int least) {
        this.pool = pool;
        this.least = least;
        boolean common = pool == ForkJoinPool.commonPool(); // its parallelism does not count the caller
        threads = pool.getParallelism() + (common ? 1 : 0);
    }

    @Override
    public void share(Work work, int n) {
        int helpers = Math.min(threads, n / least) - 1;
        Job job = helpers > 0 ? start(work, n, helpers) : null;
        if (job == null) {
            for (int i = 0; i < n; i++) work.run(i);
        } else {
            job.help();
            job.await();
        }
    }

    /** Submits helpers before any work is done. Returns null if there is no memory for a job. */
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
            // The pool is shut down or cannot start a thread. A helper may wait in it all the same, so it stays
            // counted.
        }
        return job;
    }

    /** The pieces of one call, and how far they are done. */
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

        /** Waits until all pieces are done; an interrupt is preserved. Throws what a piece has thrown. */
        void await() {
            boolean interrupted = false;
            for (int looks = 0; done.get() < n; looks++) {
                if (looks < LOOKS) continue;
                LockSupport.park(this);
                interrupted |= Thread.interrupted();
            }
            if (interrupted) Thread.currentThread().interrupt();
            if (failure instanceof Error) throw (Error) failure;
            if (failure != null) throw (RuntimeException) failure;
        }
    }
}
