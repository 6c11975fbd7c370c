package yarts.physics.lockstep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import yarts.physics.Unit;

/**
 * Matches over loopback TCP connections with delays and failures. In every tick, all games must have the bits of the
 * same match without a network, and a game with other bits must be detected at once.
 */
@Timeout(120)
class LockstepTest {
    /** Three players from the start, two of whom are away for a time, the second for longer. A fourth joins late. */
    private static final Plan MATCH = new Plan(
            7,
            4,
            400,
            List.of(
                    new Plan.Absence(1, 70, 90, 100),
                    new Plan.Absence(2, 120, 180, 200),
                    new Plan.Absence(3, 0, 230, 240),
                    new Plan.Absence(0, 251, 270, 290)));

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void allGamesAgreeAtEveryTick(long noise) throws Exception {
        Game alone = Game.start(MATCH.seed());
        List<Long> expected = play(alone);
        assertEquals(MATCH.ticks(), new HashSet<>(expected).size());
        long added = alone.world.get(alone.world.size() - 1).getId(); // or more
        assertTrue(added > 300 && added - alone.world.size() > 200, added + " tanks, now " + alone.world.size());

        try (Relay relay = new Relay(MATCH)) {
            List<Player> players = play(MATCH, relay, noise, -1, game -> {});
            assertEquals(expected, relay.hashes());
            assertNull(relay.desync());
            for (Player player : players) assertEquals(alone.hash(), player.game.hash());
            int drops = players.stream().mapToInt(p -> p.drops).sum();
            assertTrue(drops >= 20, "connections failed only " + drops + " times"); // 50 are likely
            int[] loads = players.stream().mapToInt(p -> p.loads).toArray();
            int[] caughtUp = players.stream().mapToInt(p -> p.caughtUp).toArray();
            assertEquals("[0, 0, 1, 1]", Arrays.toString(loads));
            assertEquals("[39, 30, 50, 40]", Arrays.toString(caughtUp));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30})
    @Tag("long")
    void allGamesAgreeOverManyBadConnections(long noise) throws Exception {
        allGamesAgreeAtEveryTick(noise);
    }

    /** The match without a network. */
    private static List<Long> play(Game game) {
        List<Long> hashes = new ArrayList<>();
        while (game.tick() < MATCH.ticks()) {
            hashes.add(game.hash());
            List<Command> orders = new ArrayList<>();
            for (int i = 0; i < MATCH.players(); i++) orders.addAll(MATCH.orders(i, game));
            game.run(orders);
        }
        return hashes;
    }

    /** The fault: the last bit of a value. */
    enum Wrong {
        X("x", Unit::getX, u -> u.setPosition(Math.nextUp(u.getX()), u.getY())),
        Y("y", Unit::getY, u -> u.setPosition(u.getX(), Math.nextUp(u.getY()))),
        VX("vx", Unit::getVx, u -> u.setVelocity(Math.nextUp(u.getVx()), u.getVy())),
        VY("vy", Unit::getVy, u -> u.setVelocity(u.getVx(), Math.nextUp(u.getVy()))),
        MASS("mass", Unit::getMass, u -> u.setMass(Math.nextUp(u.getMass()))),
        FRICTION("friction", Unit::getFriction, u -> u.setFriction(Math.nextUp(u.getFriction()))),
        MAX_SPEED("maxSpeed", Unit::getMaxSpeed, u -> u.setMaxSpeed(Math.nextUp(u.getMaxSpeed()))),
        FX("fx", Unit::getFx, u -> u.applyForce(Double.MIN_VALUE, 0)),
        FY("fy", Unit::getFy, u -> u.applyForce(0, Double.MIN_VALUE)),
        FROZEN("frozen", u -> u.isFrozen() ? 1 : 0, u -> u.setFrozen(true));

        private final String field;
        private final ToDoubleFunction<Unit> value;
        private final Consumer<Unit> change;

        Wrong(String field, ToDoubleFunction<Unit> value, Consumer<Unit> change) {
            this.field = field;
            this.value = value;
            this.change = change;
        }

        String show(Unit unit) {
            double v = value.applyAsDouble(unit);
            return Double.toHexString(v) + " (" + v + ")";
        }
    }

    @ParameterizedTest
    @EnumSource
    void aWrongBitIsDetectedBeforeTheNextTickAndReported(Wrong wrong) throws Exception {
        int tick = 33, index = 60;
        Plan plan = new Plan(8, 3, 100, List.of());
        try (Relay relay = new Relay(plan)) {
            List<Player> players = play(plan, relay, 4, 1, game -> {
                if (game.tick() == tick) wrong.change.accept(game.world.get(index));
            });
            for (Player player : players) assertEquals(tick, player.game.tick());
            assertEquals(tick, relay.hashes().size());
            Unit good = players.get(0).game.world.get(index),
                    bad = players.get(1).game.world.get(index);
            String line =
                    "unit " + good.getId() + " " + wrong.field + ": " + wrong.show(bad) + " | " + wrong.show(good);
            List<String> report = relay.desync().lines().toList();
            assertEquals(List.of("player 1 differs at tick " + tick + ":", line), report.subList(0, 2));
            for (String rest : report.subList(2, report.size())) { // setPosition also changes the previous position
                assertTrue(rest.startsWith("unit " + good.getId() + " previous"), rest);
                assertTrue(wrong == Wrong.X || wrong == Wrong.Y, rest);
            }
        }
    }

    /** Runs a match of all players. {@code changeGame} may change one player's game after each tick. */
    private static List<Player> play(Plan plan, Relay relay, long noise, int changed, Consumer<Game> changeGame)
            throws Exception {
        List<Player> players = new ArrayList<>();
        for (int i = 0; i < plan.players(); i++) {
            players.add(new Player(i, plan, relay, noise, i == changed ? changeGame : game -> {}));
        }
        ExecutorService threads = Executors.newCachedThreadPool(work -> {
            Thread thread = new Thread(work);
            thread.setDaemon(true);
            return thread;
        });
        try {
            List<Future<Player>> played = threads.invokeAll(players, 90, TimeUnit.SECONDS);
            relay.hashes(); // throws the first failure
            for (Future<Player> player : played) player.get();
            return players;
        } finally {
            threads.shutdownNow();
        }
    }
}
