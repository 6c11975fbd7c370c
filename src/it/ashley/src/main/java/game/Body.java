package game;

import com.badlogic.ashley.core.Component;
import yarts.physics.Unit;

/** What an entity has that moves. It has it as long as it lives. */
record Body(Unit unit) implements Component {}
