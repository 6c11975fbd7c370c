package yarts.physics.lockstep;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Iterator;
import java.util.List;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/**
 * A small war that follows, to the bit, from its seed and the commands of its ticks. It uses no clock, no network and
 * no thread. The state of its random numbers is part of its state, its hash and its saves.
 */
final class Game {
    private static final int RATE = 30; // steps per second, one step per tick
    private static final int MOST = 160; // tanks
    private static final double MAP = 500, BLAST = 60; // m

    /** A unit with values of the game, which the game itself must hash and save. */
    static final class Tank extends Unit {
        private double targetX, targetY;
        private int health = 3;

        Tank() {
            super(20_000);
            setFriction(40_000).setMaxSpeed(40);
        }

        private void drive() {
            double dx = targetX - getX(), dy = targetY - getY();
            double force = 600_000 / Math.max(5, Math.sqrt(dx * dx + dy * dy)); // 15 m/s, and slower from 5 m on
            applyForce(force * dx, force * dy);
        }
    }

    final World world = new World(Integrator.EXACT, Timestep.fixed(RATE));
    private long lot;

    /** A war of a hundred tanks. */
    static Game start(long seed) {
        Game game = new Game();
        game.lot = seed;
        for (int i = 0; i < 100; i++) game.spawn(MAP * game.draw(), MAP * game.draw());
        return game;
    }

    /** The number of steps that it has run. */
    long tick() {
        return world.getTick();
    }

    /** Executes the commands in their order, and runs one step. */
    void run(List<Command> commands) {
        for (Command command : commands) obey(command);
        for (int i = 0; i < world.size(); i++) ((Tank) world.get(i)).drive();
        world.step();
    }

    private void obey(Command command) {
        Tank tank = (Tank) world.find(command.unit()); // null if it has been removed, then on all machines
        switch (command.kind()) {
            case MOVE:
                if (tank == null) break;
                tank.targetX = command.x();
                tank.targetY = command.y();
                break;
            case RETIRE:
                if (tank != null) world.remove(tank);
                break;
            case SPAWN:
                if (world.size() < MOST) spawn(command.x(), command.y());
                break;
            case EXPLODE:
                explode(command.x(), command.y());
                break;
        }
    }

    private void spawn(double x, double y) {
        double angle = 2 * Math.PI * draw();
        Tank tank = world.add(new Tank());
        tank.setPosition(x + 20 * StrictMath.cos(angle), y + 20 * StrictMath.sin(angle));
        tank.targetX = MAP * draw();
        tank.targetY = MAP * draw();
        tank.setMass(10_000 + 20_000 * draw());
    }

    private void explode(double x, double y) {
        for (Iterator<Unit> i = world.iterator(); i.hasNext(); ) {
            Tank tank = (Tank) i.next();
            double dx = tank.getX() - x, dy = tank.getY() - y;
            double distance = Math.sqrt(dx * dx + dy * dy);
            if (distance == 0 || distance > BLAST) continue;
            double kick = 1e6 * StrictMath.exp(-distance / 20) / distance;
            tank.applyImpulse(kick * dx, kick * dy);
            if (draw() < 0.5 && --tank.health == 0) i.remove(); // the last tank takes its index
        }
    }

    /** In [0, 1): SplitMix64 (Steele, Lea, Flood, 2014). */
    private double draw() {
        lot += 0x9E3779B97F4A7C15L;
        long v = (lot ^ (lot >>> 30)) * 0xBF58476D1CE4E5B9L;
        v = (v ^ (v >>> 27)) * 0x94D049BB133111EBL;
        return ((v ^ (v >>> 31)) >>> 11) * 0x1p-53;
    }

    /** The hash of the world and of the values of the game. */
    long hash() {
        long h = 31 * world.stateHash() + lot;
        for (Unit unit : world) {
            Tank tank = (Tank) unit;
            h = 31 * h + Double.doubleToLongBits(tank.targetX);
            h = 31 * h + Double.doubleToLongBits(tank.targetY);
            h = 31 * h + tank.health;
        }
        return h;
    }

    /** The snapshot of the world and then the values of the game. The bytes are the same on every machine. */
    byte[] save() {
        byte[] bytes = world.save().toBytes();
        ByteArrayOutputStream save = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(save)) {
            out.writeInt(bytes.length);
            out.write(bytes);
            out.writeLong(lot);
            for (Unit unit : world) {
                Tank tank = (Tank) unit;
                out.writeDouble(tank.targetX);
                out.writeDouble(tank.targetY);
                out.writeInt(tank.health);
            }
        } catch (IOException e) {
            throw new AssertionError(e); // a stream in memory does not throw this
        }
        return save.toByteArray();
    }

    /** Restores the state of a saved game. Tanks that exist in both stay the same objects. */
    void load(byte[] save) throws IOException {
        world.restore(snapshot(save), id -> new Tank());
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(save));
        in.skipNBytes(in.readInt());
        lot = in.readLong();
        for (Unit unit : world) {
            Tank tank = (Tank) unit;
            tank.targetX = in.readDouble();
            tank.targetY = in.readDouble();
            tank.health = in.readInt();
        }
    }

    /** The world's snapshot in a save. */
    static Snapshot snapshot(byte[] save) {
        byte[] bytes = new byte[ByteBuffer.wrap(save).getInt()];
        ByteBuffer.wrap(save, 4, bytes.length).get(bytes);
        return Snapshot.fromBytes(bytes);
    }
}
