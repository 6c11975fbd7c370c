package game;

import com.badlogic.ashley.core.Component;
import yarts.physics.Unit;

/** The unit of an entity, from its creation to its removal. */
record Body(Unit unit) implements Component {}
