package game;

import com.artemis.Component;
import com.artemis.annotations.DelayedComponentRemoval;
import yarts.physics.Unit;

/** What an entity has that moves. It is still there when systems are told of its removal. */
@DelayedComponentRemoval
public final class Body extends Component {
    Unit unit;
}
