package game;

import com.badlogic.ashley.core.Entity;
import com.badlogic.ashley.core.EntityListener;
import com.badlogic.ashley.core.EntitySystem;
import yarts.physics.World;

// tag::adapter[]
/**
 * Steps a world once per update, and removes the unit of an entity that is removed. The game creates both:
 * {@code engine.addEntity(new Entity().add(new Body(physics.world.add(unit))))}, where the component is
 * {@code record Body(Unit unit) implements Component {}}. It adds this to the engine as a system, and as a listener to
 * {@code Family.all(Body.class).get()}.
 */
final class Physics extends EntitySystem implements EntityListener {
    final World world = new World();

    public void update(float deltaTime) {
        world.advance(deltaTime);
    }

    public void entityAdded(Entity entity) {}

    public void entityRemoved(Entity entity) {
        world.remove(entity.getComponent(Body.class).unit());
    }
}
// end::adapter[]
