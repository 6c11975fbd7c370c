package yarts.physics.lockstep;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.Socket;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.function.Consumer;

/**
 * One machine: a game, and a bad connection to the relay, with random delays and failures in the middle of messages.
 */
final class Player implements Callable<Player> {
    private final int number;
    private final Plan plan;
    private final Relay relay;
    private final Random noise;
    private final Consumer<Game> afterTick;
    private Socket line;

    Game game;
    int drops, loads, caughtUp;

    /**
     * A player.
     *
     * @param number the player's number in the plan
     * @param plan the plan of the match
     * @param relay the host
     * @param noise the seed of the faults of the connection
     * @param afterTick is called with the game after every tick
     */
    Player(int number, Plan plan, Relay relay, long noise, Consumer<Game> afterTick) {
        this.number = number;
        this.plan = plan;
        this.relay = relay;
        this.noise = new Random(noise * 31 + number);
        this.afterTick = afterTick;
        if (!plan.isAway(number, 0)) game = Game.start(plan.seed());
    }

    private long tick() {
        return game == null ? -1 : game.tick();
    }

    /** Plays the match until its end. */
    @Override
    public Player call() throws Exception {
        try {
            boolean over = false;
            while (!over && tick() < plan.ticks()) {
                for (Plan.Absence absence : plan.absences()) {
                    if (absence.player() == number && absence.from() == Math.max(0, tick())) {
                        hangUp();
                        relay.await(absence.dials());
                    }
                }
                boolean show = tick() >= 0 && tick() % Plan.SAVE_EVERY == 0;
                Reply reply = ask(request(show));
                if (reply.kind() == Reply.Kind.SHOW) reply = ask(request(true));
                over = !follow(reply);
            }
            return this;
        } catch (Exception | Error e) {
            relay.fail(e);
            throw e;
        } finally {
            hangUp();
        }
    }

    private byte[] request(boolean show) throws IOException {
        if (game == null) return new Request(number, -1, 0, List.of(), new byte[0]).toBytes();
        byte[] save = show ? game.save() : new byte[0];
        return new Request(number, tick(), game.hash(), plan.orders(number, game), save).toBytes();
    }

    /** {@return whether the match continues} */
    private boolean follow(Reply reply) throws IOException {
        switch (reply.kind()) {
            case RUN:
                if (plan.isAway(number, tick())) caughtUp++;
                game.run(Command.readAll(new DataInputStream(new ByteArrayInputStream(reply.body()))));
                afterTick.accept(game);
                return true;
            case LOAD:
                if (game == null) game = new Game();
                game.load(reply.body());
                loads++;
                return true;
            case END:
                return false;
            default:
                throw new IOException("asked again for what was sent");
        }
    }

    /**
     * Sends a request until there is a reply. If the connection fails, none, some or all of the request has been sent.
     */
    private Reply ask(byte[] request) throws IOException, InterruptedException {
        for (int attempt = 1; ; attempt++) {
            try {
                Thread.sleep(noise.nextInt(100) == 0 ? 20 : noise.nextInt(3));
                if (line == null) line = dial();
                boolean breaks = noise.nextInt(25) == 0;
                boolean all = !breaks || noise.nextBoolean();
                line.getOutputStream().write(request, 0, all ? request.length : noise.nextInt(request.length));
                if (!breaks) return Reply.read(new DataInputStream(line.getInputStream()));
                drops++;
                hangUp();
            } catch (IOException e) {
                hangUp();
                if (attempt == 10) throw e;
            }
        }
    }

    private Socket dial() throws IOException {
        Socket socket = relay.connect();
        socket.setTcpNoDelay(true);
        socket.setSoTimeout(2 * Relay.PATIENCE);
        return socket;
    }

    private void hangUp() throws IOException {
        if (line != null) line.close();
        line = null;
    }
}
