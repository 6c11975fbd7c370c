package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The server recipe of docs/cookbook.md: an order or a listener that throws does not stop the server. */
class ServerTest {
    private final World world = new World(Integrator.EXACT, Timestep.fixed(100));
    private final Unit tank = world.add(new Unit(40_000).setFriction(8_000));
    private final Queue<Runnable> orders = new ConcurrentLinkedQueue<>();
    private final List<String> reports = new CopyOnWriteArrayList<>();

    private void report(String what, Throwable e) {
        reports.add(what + ": " + e.getClass().getSimpleName());
    }

    /** The task of the recipe. */
    private void period() {
        for (int n = orders.size(); n > 0; n--) {
            try {
                orders.remove().run();
            } catch (Throwable e) {
                report("an order failed", e);
            }
        }
        try {
            world.step();
        } catch (Throwable e) {
            report("a step failed", e);
        }
    }

    private static void throwError() {
        throw new StackOverflowError();
    }

    @Test
    void anOrderThatThrowsIsReportedAndDoesNotStopOtherOrdersOrTheStep() {
        orders.add(() -> world.find(99).setVelocity(1, 0));
        orders.add(() -> tank.setVelocity(Double.NaN, 0));
        orders.add(ServerTest::throwError);
        orders.add(() -> tank.setVelocity(10, 0));
        period();
        assertEquals(1, world.getTick());
        assertTrue(tank.getX() > 0, "the order after them was carried out");
        assertEquals(
                List.of(
                        "an order failed: NullPointerException",
                        "an order failed: IllegalArgumentException",
                        "an order failed: StackOverflowError"),
                reports);
    }

    @Test
    void theStepRunsInEveryPeriodEvenIfManyOrdersThrow() {
        for (int n = 1; n <= 100; n++) {
            for (int i = 0; i < n % 7; i++) orders.add(() -> world.find(99).setVelocity(0, 0));
            period();
            assertEquals(n, world.getTick());
        }
    }

    /** For example, an order that waits for an event, or a network that is faster than the server. */
    @Test
    void anOrderThatAddsOrdersRunsOncePerPeriod() {
        int[] runs = {0};
        Runnable again = new Runnable() {
            @Override
            public void run() {
                runs[0]++;
                orders.add(this);
            }
        };
        orders.add(again);
        for (int n = 1; n <= 10; n++) {
            period();
            assertEquals(n, runs[0]);
            assertEquals(n, world.getTick());
        }
    }

    @Test
    void aFailedStepIsReportedAndTheNextPeriodStepsAgain() {
        int[] failures = {3};
        world.addBeforeStep((w, dt) -> {
            if (failures[0]-- > 0) throw new IllegalStateException();
        });
        orders.add(() -> tank.setVelocity(10, 0));
        for (int n = 0; n < 10; n++) period();
        assertEquals(Collections.nCopies(3, "a step failed: IllegalStateException"), reports);
        assertEquals(7, world.getTick());
        assertEquals(10 * 5 * -Math.expm1(-0.07 / 5), tank.getX(), 1e-12);
    }

    /** The world is the same to the bit as one that received only the good orders. */
    @Test
    void ordersThatThrowHaveNoEffectOnTheWorld() {
        Random random = new Random(1);
        World other = new World(Integrator.EXACT, Timestep.fixed(100));
        Unit same = other.add(new Unit(40_000).setFriction(8_000));
        for (int n = 0; n < 1_000; n++) {
            for (int i = random.nextInt(4); i > 0; i--) {
                double v = random.nextInt(20);
                if (random.nextBoolean()) {
                    orders.add(() -> world.find(99).setVelocity(v, 0));
                } else {
                    orders.add(() -> tank.setVelocity(v, 0));
                    same.setVelocity(v, 0);
                }
            }
            period();
            other.step();
            assertEquals(other.stateHash(), world.stateHash());
        }
    }

    @Test
    void anExecutorContinuesAfterOrdersAndStepsThatThrow() throws InterruptedException {
        CountDownLatch ticks = new CountDownLatch(20);
        int[] calls = {0};
        world.addBeforeStep((w, dt) -> {
            if (calls[0]++ == 5) throw new IllegalStateException();
        });
        world.addAfterStep((w, dt) -> ticks.countDown());
        ScheduledExecutorService server = Executors.newSingleThreadScheduledExecutor();
        try {
            orders.add(() -> world.find(99).setVelocity(0, 0));
            ScheduledFuture<?> task = server.scheduleAtFixedRate(this::period, 0, 1, TimeUnit.MILLISECONDS);
            assertTrue(ticks.await(1, TimeUnit.MINUTES), () -> "stopped at tick " + world.getTick());
            assertFalse(task.isDone());
            assertEquals(
                    List.of("an order failed: NullPointerException", "a step failed: IllegalStateException"), reports);
        } finally {
            server.shutdownNow();
        }
    }
}
