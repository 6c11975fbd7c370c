package game;

import dev.dominion.ecs.api.Entity;
import dev.dominion.ecs.api.Scheduler;
import java.util.Map;
import yarts.physics.Unit;
import yarts.physics.World;

// tag::adapter[]
/**
 * Steps a world once per tick, and removes units whose entities were deleted. A unit is itself a component: the game creates
 * both with {@code entities.put(unit, dominion.createEntity(world.add(unit)))}, and calls {@code scheduler.schedule(physics)}.
 */
record Physics(Scheduler scheduler, World world, Map<Unit, Entity> entities) implements Runnable {
    @Override
    public void run() {
        entities.values().removeIf(Entity::isDeleted);
        world.removeIf(unit -> !entities.containsKey(unit));
        world.advance(scheduler.deltaTime());
    }
}
// end::adapter[]
