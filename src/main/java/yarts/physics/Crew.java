package yarts.physics;

/** Divides work among threads. Only its implementation uses threads, so that games without it compile to JavaScript. */
interface Crew {
    /** Independent pieces of work, numbered from 0. */
    interface Work {
        void run(int piece);
    }

    /** Runs pieces 0 to n − 1, each once, and returns when all are done. */
    void share(Work work, int n);
}
