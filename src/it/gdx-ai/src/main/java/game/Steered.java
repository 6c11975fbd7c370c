package game;

import com.badlogic.gdx.ai.steer.Steerable;
import com.badlogic.gdx.ai.steer.SteerableAdapter;
import com.badlogic.gdx.math.Vector2;
import yarts.physics.Unit;

/** Units for gdx-ai. */
final class Steered {
    private Steered() {}

    // tag::adapter[]
    /**
     * A unit for the behaviours of gdx-ai; their {@code Limiter} contains its limits. They return an acceleration, and the
     * game applies the force for it before each step: {@code unit.applyForce(m * a.x, m * a.y)}.
     */
    static Steerable<Vector2> steerable(Unit unit) {
        return new SteerableAdapter<>() {
            public Vector2 getPosition() {
                return new Vector2((float) unit.getX(), (float) unit.getY());
            }

            public Vector2 getLinearVelocity() {
                return new Vector2((float) unit.getVx(), (float) unit.getVy());
            }
        };
    }
    // end::adapter[]
}
