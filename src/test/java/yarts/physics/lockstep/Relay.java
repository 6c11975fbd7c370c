package yarts.physics.lockstep;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Collects every player's orders for a tick, compares the hashes of their games, and then sends the orders to all
 * players. It keeps the latest save and the ticks since then for players who were away. It does not know the rules of
 * the game.
 */
final class Relay implements AutoCloseable {
    /** The longest wait; in ms. */
    static final int PATIENCE = 20_000;

    private final Plan plan;
    private final ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    /** The requests for the current tick, by player. */
    private final Map<Integer, Request> present = new TreeMap<>();
    /** The common hashes of all players, from tick 0 on. */
    private final List<Long> hashes = new ArrayList<>();
    /** The ticks since the save. */
    private final List<Reply> log = new ArrayList<>();

    private byte[] save = {};
    private boolean suspicious;
    private String desync;
    private Throwable failure;

    Relay(Plan plan) throws IOException {
        this.plan = plan;
        daemon(() -> {
            while (true) {
                Socket line = server.accept();
                daemon(() -> serve(line));
            }
        });
    }

    private interface Work {
        void run() throws Exception;
    }

    private void daemon(Work work) {
        Thread thread = new Thread(() -> {
            try {
                work.run();
            } catch (IOException e) {
                // A connection failed, or the server is closed. A player who still plays connects again.
            } catch (Throwable e) {
                fail(e);
            }
        });
        thread.setDaemon(true);
        thread.start();
    }

    Socket connect() throws IOException {
        return new Socket(server.getInetAddress(), server.getLocalPort());
    }

    private void serve(Socket line) throws Exception {
        try (line) {
            line.setTcpNoDelay(true);
            line.setSoTimeout(PATIENCE);
            DataInputStream in = new DataInputStream(new BufferedInputStream(line.getInputStream()));
            DataOutputStream out = new DataOutputStream(new BufferedOutputStream(line.getOutputStream()));
            while (true) answer(Request.read(in)).write(out);
        }
    }

    private synchronized Reply answer(Request request) throws Exception {
        if (request.tick() == tick()) take(request);
        long deadline = System.nanoTime() + PATIENCE * 1_000_000L;
        while (true) {
            if (failure != null || desync != null) return new Reply(Reply.Kind.END);
            long first = (long) hashes.size() - log.size();
            if (request.tick() < first) return new Reply(Reply.Kind.LOAD, save);
            if (request.tick() < tick()) {
                requireEqual(request.player(), "hash", hashes.get((int) request.tick()), request.hash());
                return log.get((int) (request.tick() - first));
            }
            if (suspicious && request.save().length == 0) return new Reply(Reply.Kind.SHOW);
            await(deadline);
        }
    }

    @SuppressWarnings("WaitNotInLoop") // the caller waits in a loop
    private void await(long deadline) throws InterruptedException {
        long left = (deadline - System.nanoTime()) / 1_000_000;
        if (left <= 0)
            throw new IllegalStateException("at tick " + tick() + " only these have sent: " + present.keySet());
        wait(left);
    }

    private void take(Request request) throws IOException {
        Request earlier = present.get(request.player());
        if (earlier != null) {
            requireEqual(request.player(), "repeated hash", earlier.hash(), request.hash());
            requireEqual(request.player(), "repeated orders", earlier.orders(), request.orders());
            if (request.save().length == 0) return;
        }
        present.put(request.player(), request);
        for (int i = 0; i < plan.players(); i++) {
            if (!plan.isAway(i, tick()) && !present.containsKey(i)) return;
        }
        if (present.values().stream().map(Request::hash).distinct().count() == 1) release(present.values());
        else if (present.values().stream().allMatch(r -> r.save().length > 0)) desync = report();
        else suspicious = true;
        notifyAll();
    }

    private void release(Collection<Request> all) throws IOException {
        List<Command> orders = new ArrayList<>();
        for (Request request : all) orders.addAll(request.orders());
        if (tick() % Plan.SAVE_EVERY == 0) {
            save = all.iterator().next().save();
            for (Request r : all) requireEqual(r.player(), "save", ByteBuffer.wrap(save), ByteBuffer.wrap(r.save()));
            log.clear();
        }
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        Command.writeAll(orders, new DataOutputStream(body));
        log.add(new Reply(Reply.Kind.RUN, body.toByteArray()));
        hashes.add(all.iterator().next().hash());
        present.clear();
    }

    /** The player whose hash differs, and the differences of that player's world from the others'. */
    private String report() {
        Collection<Request> all = present.values();
        Comparator<Request> byCamp = Comparator.comparing(
                a -> all.stream().filter(b -> a.hash() == b.hash()).count());
        Request odd = Collections.min(all, byCamp), other = Collections.max(all, byCamp);
        return "player " + odd.player() + " differs at tick " + tick() + ":\n"
                + Game.snapshot(odd.save()).difference(Game.snapshot(other.save()));
    }

    private static void requireEqual(int player, String what, Object expected, Object actual) {
        if (expected.equals(actual)) return;
        throw new IllegalStateException("player " + player + ": " + what + " " + actual + ", not " + expected);
    }

    /** Ends the match. */
    synchronized void fail(Throwable e) {
        if (failure == null) failure = e;
        notifyAll();
    }

    /** The tick that is being collected. */
    synchronized long tick() {
        return hashes.size();
    }

    /** Waits until the relay collects this tick or a later one, or the match is over. */
    synchronized void await(int tick) throws InterruptedException {
        long deadline = System.nanoTime() + PATIENCE * 1_000_000L;
        while (tick() < tick && failure == null && desync == null) await(deadline);
    }

    /** {@return the report of the tick at which the hashes differed, or null} */
    synchronized String desync() {
        return desync;
    }

    /** {@return the common hash of each tick} */
    synchronized List<Long> hashes() {
        if (failure != null) throw new AssertionError(failure);
        return List.copyOf(hashes);
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
