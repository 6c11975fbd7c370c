package game;

import com.google.gson.Gson;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import tools.jackson.databind.json.JsonMapper;
import yarts.physics.Integrator;
import yarts.physics.Snapshot;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** A game that Jackson and Gson save as JSON: the loaded game continues with the same bits as the original. */
public final class Game {
    /** The whole save: a snapshot in Base64, and the game's data by the unit's id. */
    record Save(String physics, Map<Long, Tank.Data> tanks) {}

    private static final JsonMapper JACKSON = new JsonMapper();
    private static final Gson GSON = new Gson();

    private Game() {}

    // tag::adapter[]
    static Save save(World world) {
        Map<Long, Tank.Data> tanks = new TreeMap<>();
        for (Unit unit : world) tanks.put(unit.getId(), ((Tank) unit).data);
        return new Save(Base64.getEncoder().encodeToString(world.save().toBytes()), tanks);
    }

    static void load(Save save, World into) {
        byte[] physics = Base64.getDecoder().decode(save.physics());
        into.restore(Snapshot.fromBytes(physics), id -> new Tank(save.tanks().get(id)));
    }
    // end::adapter[]

    public static void main(String[] args) {
        List<UnaryOperator<Save>> files = List.of(
                save -> JACKSON.readValue(JACKSON.writeValueAsString(save), Save.class),
                save -> GSON.fromJson(GSON.toJson(save), Save.class),
                save -> GSON.fromJson(JACKSON.writeValueAsString(save), Save.class),
                save -> JACKSON.readValue(GSON.toJson(save), Save.class));
        World world = new World(Integrator.EXACT, Timestep.fixed(60));
        for (int i = 0; i < 100; i++) {
            Tank tank = world.add(new Tank(new Tank.Data("\"tank\" №" + i, i % 7)));
            tank.setFriction(8_000 + i).setVelocity(i / 3.0, -i / 7.0);
            if (i % 2 == 0) tank.setMaxSpeed(15);
        }
        play(world, 50);
        world.removeIf(unit -> unit.getId() % 10 == 3);
        Save save = save(world);
        play(world, 100);
        for (UnaryOperator<Save> file : files) {
            World loaded = new World();
            load(file.apply(save), loaded);
            require(save(loaded).equals(save), "it is what was saved");
            play(loaded, 100);
            require(save(loaded).equals(save(world)), world.save().difference(loaded.save()));
        }
        aUnitIsNoBean();
        System.out.println("json: " + world.size() + " tanks, saved and loaded by Jackson and by Gson, "
                + JACKSON.writeValueAsString(save).length() + " characters, played on to the same bits");
    }

    /** A number of frames that leaves a part of a step, with the impulses that wait for it. */
    private static void play(World world, int frames) {
        for (int frame = 0; frame < frames; frame++) {
            for (Unit unit : world) unit.applyForce(10_000 * ((Tank) unit).data.shells(), 20_000);
            world.advance(1 / 144.0);
        }
        require(world.get(0).getPendingImpulseY() > 0, "it is between two steps");
    }

    /** The statements of docs/snapshots.md about a unit that is passed to the libraries itself. */
    private static void aUnitIsNoBean() {
        Bean written = new Bean();
        written.setFriction(3).setPosition(5, 6).setVelocity(7, 8).setMaxSpeed(100);
        losesItsPosition(written);
        new World().add(written);
        losesItsPosition(written);
        fails("Gson", () -> GSON.toJson(written));
        fails("Gson", () -> GSON.toJson(new Bean()));
    }

    private static void losesItsPosition(Bean written) {
        Bean read = JACKSON.readValue(JACKSON.writeValueAsString(written), Bean.class);
        boolean lost = read.getX() == 0 && read.getVx() == 0 && read.getWorld() == null;
        require(read.getFriction() == 3 && lost, "Jackson loses where it was: " + read);
    }

    static final class Bean extends Unit {
        Bean() {
            super(1);
        }
    }

    private static void fails(String library, Runnable work) {
        try {
            work.run();
        } catch (RuntimeException | StackOverflowError expected) {
            return;
        }
        throw new IllegalStateException(library + " takes a unit now; docs/snapshots.md says that it does not");
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new IllegalStateException(claim);
    }
}
