package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.demo.Skirmish;
import yarts.physics.demo.Tank;

/** The skirmish of the demo and of the web page. */
class SkirmishTest {
    /** The hashes are the same on every JVM and in every browser. */
    @ParameterizedTest
    @CsvSource({
        "EULER, a927792f5cb71e36",
        "SEMI_IMPLICIT, 6fc670dc1d290b07",
        "MIDPOINT, 99f889771e4d6a94",
        "EXACT, d34edbfeed0ca8ec"
    })
    void theSameSeedPlaysTheSameSkirmishToTheBit(Integrator integrator, String hash) {
        assertEquals(hash, Long.toHexString(play(integrator, 1).stateHash()));
        assertNotEquals(hash, Long.toHexString(play(integrator, 2).stateHash()));
    }

    private static Skirmish play(Integrator integrator, long seed) {
        Skirmish game = new Skirmish(300, seed);
        game.setIntegrator(integrator);
        play(game, 10); // the armies have met
        assertEquals(600, game.world().getTick());
        return game;
    }

    private static void play(Skirmish game, double until) {
        while (game.time() < until - 1e-9) game.tick();
    }

    /** A tank is 2.8 m broad. Only tanks that a blast has just hit may be closer together. */
    @ParameterizedTest
    @CsvSource({"500, 60", "150, 60", "250, 15", "1000, 60"})
    void tanksKeepTheirDistance(int tanksPerArmy, int ticksPerSecond) {
        Skirmish game = new Skirmish(tanksPerArmy, 3);
        game.setTicksPerSecond(ticksPerSecond);
        Tank[] tanks = game.tanks();
        int samples = 100;
        double touching = 0, near = 0, closest = Double.POSITIVE_INFINITY;
        for (int sample = 1; sample <= samples; sample++) {
            play(game, sample / 2.5);
            for (int i = 0; i < tanks.length; i++) {
                for (int j = 0; j < i; j++) {
                    double distance = distance(tanks[i], tanks[j]);
                    if (distance < Tank.BREADTH) touching++;
                    if (distance < 3.5) near++;
                    if (calm(game, tanks[i]) && calm(game, tanks[j])) closest = Math.min(closest, distance);
                }
            }
        }
        assertTrue(touching / samples < 0.5, touching / samples + " pairs touch");
        assertTrue(near / samples < 5, near / samples + " pairs are near");
        assertTrue(closest > Tank.BREADTH, closest + " m");
    }

    private static boolean calm(Skirmish game, Tank tank) {
        return game.time() - tank.lastHit() > 1.2;
    }

    private static double distance(Tank a, Tank b) {
        double dx = a.getX() - b.getX();
        return Math.abs(dx) > 10 ? 10 : Math.hypot(dx, a.getY() - b.getY());
    }

    /** In every 15 s, each tank reaches its place at least once, although the front moves. */
    @Test
    void eachTankReachesItsPlaceInTheLine() {
        Skirmish game = new Skirmish(500, 2);
        play(game, 10);
        for (int span = 0; span < 4; span++) {
            double[] nearest = nearestToPlace(game, 15);
            Arrays.sort(nearest);
            assertTrue(nearest[nearest.length * 9 / 10] < 0.05, nearest[nearest.length * 9 / 10] + " m");
            assertTrue(nearest[nearest.length - 1] < 0.5, nearest[nearest.length - 1] + " m");
        }
    }

    private static double[] nearestToPlace(Skirmish game, double seconds) {
        Tank[] tanks = game.tanks();
        double[] nearest = new double[tanks.length];
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        for (double until = game.time() + seconds; game.time() < until; ) {
            game.tick();
            for (int i = 0; i < tanks.length; i++) nearest[i] = Math.min(nearest[i], tanks[i].distanceFromPlace());
        }
        return nearest;
    }

    /** At tens of metres per second, over several metres; they are back at their places within seconds. */
    @ParameterizedTest
    @ValueSource(ints = {15, 60})
    void aBlastThrowsTanksAndTheyComeBack(int ticksPerSecond) {
        Skirmish game = new Skirmish(200, 4);
        game.setTicksPerSecond(ticksPerSecond);
        play(game, 9);
        Tank[] tanks = game.tanks();
        double x = tanks[0].getX() + 1, y = tanks[0].getY() + 1, blast = game.time();
        game.blastAt(x, y);
        assertEquals(new Skirmish.Blast(x, y, blast), last(game.blasts()));
        assertTrue(tanks[0].getSpeed() > 40, tanks[0].getSpeed() + " m/s");
        long thrown =
                Arrays.stream(tanks).filter(tank -> tank.lastHit() == blast).count();
        assertTrue(thrown > 10 && thrown < 40, thrown + " thrown");
        play(game, blast + 0.6);
        double way = Math.hypot(tanks[0].getX() - x, tanks[0].getY() - y);
        assertTrue(way > 6 && way < 15, way + " m");
        double[] nearest = nearestToPlace(game, 6);
        assertTrue(Arrays.stream(nearest).max().orElseThrow() < 0.7, Arrays.toString(nearest));
    }

    private static Skirmish.Blast last(Iterable<Skirmish.Blast> blasts) {
        Skirmish.Blast last = null;
        for (Skirmish.Blast blast : blasts) last = blast;
        return last;
    }

    /** For three minutes, each part of the front moves, and no tank passes the first rank of the enemy. */
    @Test
    void theFrontMovesAndNoTankBreaksThrough() {
        int parts = 12;
        Skirmish game = new Skirmish(250, 5);
        for (int half = 0; half < 6; half++) {
            double[] least = new double[parts], most = new double[parts];
            Arrays.fill(least, Skirmish.WIDTH);
            for (int sample = 0; sample < 300; sample++) {
                play(game, game.time() + 0.1);
                double[] west = new double[parts], east = new double[parts];
                Arrays.fill(east, Skirmish.WIDTH);
                for (Tank tank : game.tanks()) {
                    int part = (int) (tank.getY() / Skirmish.HEIGHT * parts);
                    if (tank.isWest()) west[part] = Math.max(west[part], tank.getX());
                    else east[part] = Math.min(east[part], tank.getX());
                }
                for (int part = 0; part < parts; part++) {
                    double gap = east[part] - west[part];
                    assertTrue(gap > Tank.LENGTH, game.time() + " s: " + gap + " m");
                    least[part] = Math.min(least[part], west[part]);
                    most[part] = Math.max(most[part], west[part]);
                }
            }
            for (int part = 0; part < parts; part++) {
                double moved = most[part] - least[part];
                assertTrue(moved > 5, "half a minute " + half + ", part " + part + ": " + moved + " m");
            }
        }
    }

    /** z = f·dt/m is 40/15 = 2.7 and 40/18 = 2.2: with the naive rule, tanks oscillate. */
    @ParameterizedTest
    @ValueSource(ints = {15, 18})
    void naiveFrictionJittersAndTheLibraryDoesNot(int ticksPerSecond) {
        double naive = jitters(ticksPerSecond, true), library = jitters(ticksPerSecond, false);
        assertTrue(naive > 0.5, naive + " of all tanks at each tick");
        assertTrue(library < 0.001, library + " of all tanks at each tick");
    }

    private static double jitters(int ticksPerSecond, boolean naive) {
        Skirmish game = new Skirmish(250, 1);
        game.setTicksPerSecond(ticksPerSecond);
        game.setNaive(naive);
        double turned = 0;
        while (game.time() < 20) {
            game.tick();
            turned += game.jittering();
        }
        return turned / game.world().getTick() / game.tanks().length;
    }

    /** In the naive game, the units of the library have no friction. A tank that slides after a blast has less. */
    @Test
    void eitherTheLibraryOrTheNaiveRuleAppliesFriction() {
        Skirmish game = new Skirmish(100, 1);
        game.setFriction(30);
        game.blastAt(game.tanks()[0].getX() + 1, game.tanks()[0].getY());
        game.tick();
        Tank thrown = game.tanks()[0], other = game.tanks()[199];
        assertTrue(thrown.isSliding(game.time()) && !other.isSliding(game.time()));
        assertEquals(30 * Tank.MASS, other.getFriction());
        assertTrue(thrown.getFriction() < 10 * Tank.MASS);
        game.setNaive(true);
        game.tick();
        assertEquals(0, thrown.getFriction());
        assertEquals(0, other.getFriction());
        game.setNaive(false);
        play(game, 1);
        assertEquals(30 * Tank.MASS, thrown.getFriction());
    }

    /** Also if the last company is not full. */
    @ParameterizedTest
    @ValueSource(ints = {1, 19, 20, 21, 137, 240, 241, 1000})
    void armiesMayHaveAnySize(int n) {
        Skirmish game = new Skirmish(n, 1);
        play(game, 8);
        assertEquals(2 * n, game.world().size());
        assertEquals(n, Arrays.stream(game.tanks()).filter(Tank::isWest).count());
        for (int i = 0; i < 2 * n; i++) {
            Tank tank = game.tanks()[i];
            assertEquals(tank, game.world().get(i));
            assertTrue(tank.getX() > 0 && tank.getX() < Skirmish.WIDTH, tank.getX() + " m");
            assertTrue(tank.getY() > 0 && tank.getY() < Skirmish.HEIGHT, tank.getY() + " m");
        }
    }

    @Test
    void framesRunTheSameTicksAsSeparateCalls() {
        Skirmish frames = new Skirmish(50, 1), ticks = new Skirmish(50, 1);
        int played = 0;
        for (int frame = 0; frame < 144 * 10; frame++) played += frames.advance(1 / 144.0);
        for (int tick = 0; tick < 600; tick++) ticks.tick();
        assertEquals(600, played);
        assertEquals(10, frames.time(), 1e-9);
        for (int i = 0; i < 100; i++) assertEquals(ticks.tanks()[i].getX(), frames.tanks()[i].getX());
    }

    /** A restored world has its old hash, but the game has more state than its world. */
    @Test
    void theHashOfTheGameIncludesStateOutsideTheWorld() {
        Skirmish game = new Skirmish(50, 1);
        play(game, 10);
        Snapshot snapshot = game.world().save();
        long world = game.world().stateHash(), all = game.stateHash();
        assertEquals(all, game.stateHash());
        play(game, 12);
        game.world().restore(snapshot);
        assertEquals(world, game.world().stateHash());
        assertNotEquals(all, game.stateHash());
    }

    /** Except for shells and blasts: some dozen bytes each. */
    @Test
    void aTickAllocatesAlmostNoMemory() {
        assumeTrue(ManagementFactory.getThreadMXBean() instanceof ThreadMXBean, "this JVM counts no allocations");
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        Skirmish game = new Skirmish(200, 1);
        play(game, 20);
        long least = Long.MAX_VALUE, id = Thread.currentThread().getId();
        for (int batch = 0; batch < 20; batch++) {
            long before = threads.getThreadAllocatedBytes(id);
            for (int tick = 0; tick < 60; tick++) game.tick();
            least = Math.min(least, threads.getThreadAllocatedBytes(id) - before);
        }
        assertTrue(least < 60 * 40, least + " bytes a second");
    }
}
