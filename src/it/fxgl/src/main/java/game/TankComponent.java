package game;

import com.almasb.fxgl.entity.component.Component;
import yarts.physics.Unit;

/** Drives a tank: gives its unit an order in each frame. */
final class TankComponent extends Component {
    static final double PUSH = 80_000; // N

    private final Unit unit;

    TankComponent(Unit unit) {
        this.unit = unit;
    }

    @Override
    public void onUpdate(double tpf) {
        unit.applyForce(PUSH, PUSH / 2);
    }
}
