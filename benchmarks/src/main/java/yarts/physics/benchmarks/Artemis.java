package yarts.physics.benchmarks;

import com.artemis.ComponentMapper;
import com.artemis.World;
import com.artemis.WorldConfigurationBuilder;
import com.artemis.annotations.All;
import com.artemis.systems.IteratingSystem;

/** artemis-odb, an entity system: one system applies a force to all entities, another moves them. */
final class Artemis implements Peer {
    private final World world = new World(
            new WorldConfigurationBuilder().with(new Push(), new Movement()).build());
    private final ComponentMapper<Parts.Position> position = world.getMapper(Parts.Position.class);
    private final ComponentMapper<Parts.Velocity> velocity = world.getMapper(Parts.Velocity.class);
    private final int[] entities;

    Artemis(Army army) {
        entities = new int[army.size];
        ComponentMapper<Parts.Force> force = world.getMapper(Parts.Force.class);
        ComponentMapper<Parts.Body> body = world.getMapper(Parts.Body.class);
        for (int i = 0; i < army.size; i++) {
            int entity = world.create();
            position.create(entity);
            force.create(entity);
            Parts.start(army, i, velocity.create(entity), body.create(entity));
            entities[i] = entity;
        }
    }

    @All(Parts.Force.class)
    private static final class Push extends IteratingSystem {
        private ComponentMapper<Parts.Force> force;

        @Override
        protected void process(int entity) {
            Parts.push(force.get(entity));
        }
    }

    @All({Parts.Position.class, Parts.Velocity.class, Parts.Force.class, Parts.Body.class})
    private static final class Movement extends IteratingSystem {
        private ComponentMapper<Parts.Position> position;
        private ComponentMapper<Parts.Velocity> velocity;
        private ComponentMapper<Parts.Force> force;
        private ComponentMapper<Parts.Body> body;

        @Override
        protected void process(int e) {
            Parts.move(position.get(e), velocity.get(e), force.get(e), body.get(e), Workload.DT);
        }
    }

    @Override
    public void step() {
        world.process();
    }

    @Override
    public double x(int i) {
        return position.get(entities[i]).x;
    }

    @Override
    public double y(int i) {
        return position.get(entities[i]).y;
    }

    @Override
    public double vx(int i) {
        return velocity.get(entities[i]).vx;
    }

    @Override
    public double vy(int i) {
        return velocity.get(entities[i]).vy;
    }
}
