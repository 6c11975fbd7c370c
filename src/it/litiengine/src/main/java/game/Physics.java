package game;

import de.gurkenlabs.litiengine.ILoop;
import de.gurkenlabs.litiengine.IUpdateable;
import de.gurkenlabs.litiengine.entities.IEntity;
import java.util.Map;
import yarts.physics.Unit;
import yarts.physics.World;

// tag::adapter[]
/**
 * Steps a world once per tick of the loop, whose delta is in whole milliseconds, and moves the entities of its units. A game
 * attaches it: {@code Game.loop().attach(new Physics(Game.loop(), world, entities))}.
 */
record Physics(ILoop loop, World world, Map<Unit, IEntity> entities) implements IUpdateable {
    static final double METRE = 16; // pixels

    @Override
    public void update() {
        world.advance(loop.getDeltaTime() / 1_000.0);
        entities.forEach(
                (unit, entity) -> entity.setLocation(METRE * unit.getInterpolatedX(), METRE * unit.getInterpolatedY()));
    }
}
// end::adapter[]
