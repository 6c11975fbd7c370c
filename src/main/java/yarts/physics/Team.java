package yarts.physics;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/** The threads of a pool and the caller's, each of which does a slice of the work. */
final class Team implements Crew {
    private final ForkJoinPool pool;
    private final int least;
    private final Slice[] slices;

    /** A slice has no fewer than some least things to do: less is done sooner than a thread wakes. */
    Team(ForkJoinPool pool, int least) {
        this.pool = pool;
        this.least = least;
        boolean common = pool == ForkJoinPool.commonPool(); // its parallelism leaves out the caller
        slices = new Slice[pool.getParallelism() + (common ? 1 : 0)];
        for (int i = 0; i < slices.length; i++) slices[i] = new Slice();
    }

    @Override
    public void share(Work work, int n) {
        int count = Math.max(1, Math.min(slices.length, n / least));
        for (int i = count - 1; i >= 0; i--) {
            slices[i].offer(work, (int) ((long) n * i / count), (int) ((long) n * (i + 1) / count));
            if (i > 0) submit(slices[i]);
        }
        // What no thread of the pool has taken by now, the caller does: it waits for nobody who has yet to begin.
        for (int i = 0; i < count; i++) slices[i].take();
        for (int i = 0; i < count; i++) slices[i].await();
        for (int i = 0; i < count; i++) slices[i].check();
    }

    private void submit(Slice slice) {
        try {
            pool.execute(slice);
        } catch (RuntimeException | Error e) {
            // The pool is shut down, or has no thread and gets none: the caller takes it.
        }
    }

    /**
     * A task that is never done as such, and so can be submitted again and again, even while it still waits in the pool.
     * (To reinitialize one that was done and joined is not safe: the thread that did it may yet wake who waits for it, and
     * so take the waker from the next who waits.) Whoever takes the slice first does it.
     */
    private static final class Slice extends ForkJoinTask<Void> {
        private static final long serialVersionUID = 1;
        private static final int DONE = 0, OFFERED = 1, TAKEN = 2;
        /** How often the caller looks before it sleeps. */
        private static final int LOOKS = 1000;

        private final AtomicInteger state = new AtomicInteger(DONE);
        // Written before it is offered, and read by who has taken it.
        private transient Work work;
        private transient Thread caller;
        private int start, end;
        private transient Throwable failure;

        void offer(Work work, int start, int end) {
            this.work = work;
            this.start = start;
            this.end = end;
            caller = Thread.currentThread();
            failure = null;
            state.set(OFFERED);
        }

        void take() {
            if (!state.compareAndSet(OFFERED, TAKEN)) return;
            Thread caller = this.caller;
            try {
                work.run(start, end);
            } catch (Throwable e) {
                failure = e;
            }
            state.set(DONE);
            if (caller != Thread.currentThread()) LockSupport.unpark(caller);
        }

        void await() {
            for (int looks = 0; state.get() != DONE; looks++) if (looks > LOOKS) LockSupport.park(this);
        }

        /** Throws what the work threw. */
        void check() {
            if (failure instanceof Error) throw (Error) failure;
            if (failure != null) throw (RuntimeException) failure;
        }

        @Override
        protected boolean exec() {
            take();
            return false;
        }

        @Override
        public Void getRawResult() {
            return null;
        }

        @Override
        protected void setRawResult(Void value) {}
    }
}
