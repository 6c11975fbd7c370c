package yarts.physics;

/** Divides work among threads. All use of threads is behind this interface, so that games without it compile to JavaScript. */
interface Crew {
    /** Independent pieces of work, numbered from 0. */
    interface Work {
        void run(int piece);
    }

    /** Runs the first n pieces, each once, and returns when all are done. */
    void share(Work work, int n);
}
