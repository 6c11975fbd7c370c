package yarts.physics.lockstep;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * The players, their absences and their orders. Together with the game, these determine the outcome of a match. The
 * network has no influence.
 *
 * @param seed the seed of the game and of the orders
 * @param players the number of players, numbered from 0
 * @param ticks the number of ticks
 * @param absences the absences of players
 */
record Plan(long seed, int players, int ticks, List<Absence> absences) {
    /** The number of ticks between two saves of all players. */
    static final int SAVE_EVERY = 50;

    /**
     * A player's absence. From tick {@code from} to before tick {@code to}, the others play without orders of this
     * player. The player connects again when the others have reached tick {@code dials}, and must catch up. An absence
     * from tick 0 is a player who joins late, without a game.
     */
    record Absence(int player, int from, int dials, int to) {}

    boolean isAway(int player, long tick) {
        return absences.stream().anyMatch(a -> a.player == player && a.from <= tick && tick < a.to);
    }

    /** The orders of a player, who sees the game before its next tick. */
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
