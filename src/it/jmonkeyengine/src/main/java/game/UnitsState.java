package game;

import com.jme3.app.state.AbstractAppState;
import com.jme3.scene.Spatial;
import java.util.HashMap;
import java.util.Map;
import yarts.physics.Unit;
import yarts.physics.World;

// tag::adapter[]
/** Steps a world once per frame, and moves the spatials of its units in the plane of x and z, the ground in jME. */
final class UnitsState extends AbstractAppState {
    final World world = new World();
    final Map<Unit, Spatial> spatials = new HashMap<>();

    @Override
    public void update(float tpf) {
        world.advance(tpf);
        spatials.forEach((unit, spatial) ->
                spatial.setLocalTranslation((float) unit.getInterpolatedX(), 0, (float) -unit.getInterpolatedY()));
    }
}
// end::adapter[]
