package game;

import com.artemis.Component;
import com.artemis.annotations.DelayedComponentRemoval;
import yarts.physics.Unit;

/** The unit of an entity. It still exists when artemis-odb calls the systems for its removal. */
@DelayedComponentRemoval
public final class Body extends Component {
    Unit unit;
}
