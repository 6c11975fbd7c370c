package yarts.physics.benchmarks;

import com.badlogic.ashley.core.ComponentMapper;
import com.badlogic.ashley.core.Engine;
import com.badlogic.ashley.core.Entity;
import com.badlogic.ashley.core.Family;
import com.badlogic.ashley.systems.IteratingSystem;
import java.util.ArrayList;
import java.util.List;

/** Ashley, an entity system for libGDX: one system applies a force to all entities, another moves them. */
final class Ashley implements Peer {
    private static final ComponentMapper<Parts.Position> POSITION = ComponentMapper.getFor(Parts.Position.class);
    private static final ComponentMapper<Parts.Velocity> VELOCITY = ComponentMapper.getFor(Parts.Velocity.class);
    private static final ComponentMapper<Parts.Force> FORCE = ComponentMapper.getFor(Parts.Force.class);
    private static final ComponentMapper<Parts.Body> BODY = ComponentMapper.getFor(Parts.Body.class);

    private final Engine engine = new Engine();
    private final List<Entity> entities = new ArrayList<>();

    Ashley(Army army) {
        for (int i = 0; i < army.size; i++) {
            Parts.Velocity velocity = new Parts.Velocity();
            Parts.Body body = new Parts.Body();
            Parts.start(army, i, velocity, body);
            Entity entity = new Entity();
            entity.add(new Parts.Position())
                    .add(velocity)
                    .add(new Parts.Force())
                    .add(body);
            engine.addEntity(entity);
            entities.add(entity);
        }
        engine.addSystem(new Push());
        engine.addSystem(new Movement());
    }

    private static final class Push extends IteratingSystem {
        Push() {
            super(Family.all(Parts.Force.class).get());
        }

        @Override
        protected void processEntity(Entity entity, float dt) {
            Parts.push(FORCE.get(entity));
        }
    }

    private static final class Movement extends IteratingSystem {
        Movement() {
            super(Family.all(Parts.Position.class, Parts.Velocity.class, Parts.Force.class, Parts.Body.class)
                    .get());
        }

        @Override
        protected void processEntity(Entity e, float dt) {
            Parts.move(POSITION.get(e), VELOCITY.get(e), FORCE.get(e), BODY.get(e), Workload.DT); // dt as a double
        }
    }

    @Override
    public void step() {
        engine.update((float) Workload.DT);
    }

    @Override
    public double x(int i) {
        return POSITION.get(entities.get(i)).x;
    }

    @Override
    public double y(int i) {
        return POSITION.get(entities.get(i)).y;
    }

    @Override
    public double vx(int i) {
        return VELOCITY.get(entities.get(i)).vx;
    }

    @Override
    public double vy(int i) {
        return VELOCITY.get(entities.get(i)).vy;
    }
}
