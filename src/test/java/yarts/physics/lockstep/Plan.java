package yarts.physics.lockstep;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Who plays when, and what they will order: all that decides the outcome of a match but for the game itself. The
 * network decides nothing.
 *
 * @param seed of the game and of the orders
 * @param players how many, from number 0 on
 * @param ticks how many to play
 * @param absences when they are away
 */
record Plan(long seed, int players, int ticks, List<Absence> absences) {
    /** Every so many ticks all send their saves. */
    static final int SAVE_EVERY = 50;

    /**
     * A player's absence: from tick {@code from} to before tick {@code to} the others play on without orders of theirs.
     * The line is up again when the others have come to tick {@code dials}, and there is much to catch up with. From
     * tick 0, it is a player who joins late, and has nothing.
     */
    record Absence(int player, int from, int dials, int to) {}

    boolean isAway(int player, long tick) {
        return absences.stream().anyMatch(a -> a.player == player && a.from <= tick && tick < a.to);
    }

    /** What a player orders, who sees the game as it stands before its next tick. */
    List<Command> orders(int player, Game game) {
        List<Command> orders = new ArrayList<>();
        if (isAway(player, game.tick())) return orders;
        Random random = new Random((seed * 1_000_003 + player) * 1_000_003 + game.tick());
        for (int i = random.nextInt(5); i > 0; i--) orders.add(order(Command.Kind.MOVE, game, random));
        if (random.nextInt(3) == 0) orders.add(order(Command.Kind.SPAWN, game, random));
        if (random.nextInt(8) == 0) orders.add(order(Command.Kind.EXPLODE, game, random));
        if (random.nextInt(4) == 0) orders.add(order(Command.Kind.RETIRE, game, random));
        return orders;
    }

    private static Command order(Command.Kind kind, Game game, Random random) {
        int size = game.world.size();
        long unit = size == 0 ? 0 : game.world.get(random.nextInt(size)).getId();
        return new Command(kind, unit, 500 * random.nextDouble(), 500 * random.nextDouble());
    }
}
