package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The recipe of docs/cookbook.md for drawing from another thread: units come and go, and the simulation may fail. */
@Timeout(120)
class DrawingTest {
    private static final int FRESH = 4;

    private static final class Frame {
        float[] xy = {};
        int size;

        void copy(World world) {
            size = world.size();
            if (xy.length < 2 * size) xy = new float[3 * size];
            world.copyPositions(xy, 0);
        }
    }

    private final World world = new World(Integrator.EXACT, Timestep.fixed(64));
    private final Frame[] frames = {new Frame(), new Frame(), new Frame()};
    private final AtomicInteger between = new AtomicInteger(2);
    private final AtomicReference<Throwable> failure = new AtomicReference<>();
    private int drawn = 1;

    private Thread simulate(int ticks) {
        Thread simulation = new Thread(() -> {
            int mine = 0;
            for (int tick = 0; tick < ticks; tick++) {
                world.step();
                frames[mine].copy(world);
                mine = between.getAndSet(mine | FRESH) & 3;
            }
        });
        simulation.setUncaughtExceptionHandler((thread, e) -> failure.set(e));
        simulation.setDaemon(true);
        simulation.start();
        return simulation;
    }

    private Frame draw() {
        if (failure.get() != null) throw new IllegalStateException("the simulation failed", failure.get());
        if ((between.get() & FRESH) != 0) drawn = between.getAndSet(drawn) & 3;
        return frames[drawn];
    }

    /** The tick determines all positions, so the test detects a frame with parts of two ticks. 1 to 3,000 units. */
    @Test
    void theDrawingThreadGetsWholeFramesInOrderWhileUnitsComeAndGo() throws InterruptedException {
        int ticks = 10_000;
        Random random = new Random(1);
        world.add(new Unit(1).setVelocity(64, 64));
        world.addBeforeStep((w, dt) -> {
            int target = w.getTick() % 500 == 499 ? 1 : w.getTick() % 50 == 25 ? 1 + random.nextInt(3_000) : w.size();
            while (w.size() > target) w.remove(w.get(w.size() - 1));
            while (w.size() < target)
                w.add(new Unit(1)
                        .setPosition((double) w.getTick(), (double) w.getTick())
                        .setVelocity(64, 64));
        });
        Thread simulation = simulate(ticks);
        float last = 0;
        int sizes = 0, size = 0;
        while (last < ticks) {
            boolean over = !simulation.isAlive();
            Frame frame = draw();
            if (frame.size == 0) continue;
            float x = frame.xy[0];
            for (int k = 1; k < 2 * frame.size; k++) if (frame.xy[k] != x) assertEquals(x, frame.xy[k], "two ticks");
            assertTrue(x >= last, "back");
            assertTrue(x == ticks || !over, "the last frame is there");
            if (frame.size != size) sizes++;
            size = frame.size;
            last = x;
        }
        simulation.join();
        assertTrue(sizes > 5, "only " + sizes + " sizes were drawn");
    }

    @Test
    void theDrawingThreadDetectsAFailureOfTheSimulation() {
        RuntimeException broken = new IllegalStateException("broken");
        world.add(new Unit(1));
        world.addBeforeStep((w, dt) -> {
            if (w.getTick() == 100) throw broken;
        });
        simulate(1_000_000);
        IllegalStateException e = assertThrows(IllegalStateException.class, () -> {
            while (true) draw();
        });
        assertSame(broken, e.getCause());
    }
}
