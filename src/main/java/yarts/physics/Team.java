package yarts.physics;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveAction;
import java.util.concurrent.RejectedExecutionException;

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
            Slice slice = slices[i];
            slice.work = work;
            slice.start = (int) ((long) n * i / count);
            slice.end = (int) ((long) n * (i + 1) / count);
            if (i > 0) slice.start();
            else slice.compute();
        }
        for (int i = 1; i < count; i++) {
            slices[i].quietlyJoin();
            if (slices[i].isCancelled()) slices[i].compute(); // the pool was shut down before its turn came
            else slices[i].join();
        }
    }

    private final class Slice extends RecursiveAction {
        private static final long serialVersionUID = 1;
        private transient Work work;
        private int start, end;

        void start() {
            reinitialize();
            try {
                pool.execute(this);
            } catch (RejectedExecutionException e) { // the pool is shut down
                invoke();
            }
        }

        @Override
        protected void compute() {
            work.run(start, end);
        }
    }
}
