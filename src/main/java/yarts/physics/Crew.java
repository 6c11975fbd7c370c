package yarts.physics;

/** Shares work out among threads. What needs threads is behind this, so that a game without them compiles without. */
interface Crew {
    /** Work on things that are numbered from 0. */
    interface Work {
        /** Does those from one to another, exclusively. */
        void run(int start, int end);
    }

    /** Has the first n done, each once, and returns when they are. */
    void share(Work work, int n);
}
