package game;

import com.artemis.BaseEntitySystem;
import com.artemis.annotations.All;
import yarts.physics.World;

// tag::adapter[]
/**
 * Steps the units of the entities, and removes the unit of an entity that is deleted or loses its body. The game creates both:
 * {@code world.edit(world.create()).create(Body.class).unit = physics.units.add(unit)}. {@code world} is artemis-odb's, and
 * {@code Body} a component with the field {@code Unit unit}, annotated {@code @DelayedComponentRemoval}.
 */
@All(Body.class)
final class Physics extends BaseEntitySystem {
    final World units = new World();

    protected void processSystem() {
        units.advance(world.getDelta());
    }

    protected void removed(int entity) {
        units.remove(world.getMapper(Body.class).get(entity).unit);
    }
}
// end::adapter[]
