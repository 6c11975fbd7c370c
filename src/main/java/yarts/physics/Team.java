package yarts.physics;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveAction;
import java.util.concurrent.RejectedExecutionException;

/** Several threads that step a table together, each a slice of its rows. Rows do not depend on one another. */
final class Team {
    /** Fewer rows are stepped sooner than a thread wakes. */
    static final int LEAST = 16 * 1024;

    private final ForkJoinPool pool;
    private final int least;
    private final Slice[] slices;

    /** A thread gets no fewer than some least rows. */
    Team(ForkJoinPool pool, int least) {
        this.pool = pool;
        this.least = least;
        boolean common = pool == ForkJoinPool.commonPool(); // its parallelism leaves out the caller
        slices = new Slice[pool.getParallelism() + (common ? 1 : 0)];
        for (int i = 0; i < slices.length; i++) slices[i] = new Slice();
    }

    void step(Columns table, int rows) {
        int count = Math.max(1, Math.min(slices.length, rows / least));
        int blocks = (rows + Columns.BLOCK - 1) / Columns.BLOCK;
        for (int i = count - 1; i >= 0; i--) {
            Slice slice = slices[i];
            slice.table = table;
            slice.from = (int) ((long) blocks * i / count) * Columns.BLOCK;
            slice.to = Math.min((int) ((long) blocks * (i + 1) / count) * Columns.BLOCK, rows);
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
        private transient Columns table;
        private int from, to;

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
            table.stepRows(from, to);
        }
    }
}
