package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The claims of docs/adopting.md that its code blocks do not show, for example Minecraft's rules at 20 ticks/s. */
class AdoptingTest {
    private static final int TICKS = 200;

    @TempDir
    Path folder;

    @Test
    void aFallingItemMovesByTheVelocityAfterTheAccelerationAsInMinecraft() {
        double y = 0, v = 0.2, keep = 0.98f;
        World world = new World(Integrator.EULER, Timestep.fixed(20));
        Unit item = world.add(new Unit(1).setFriction((1 - keep) * 20).setVelocity(0, (v - 0.04) * 20));
        world.addBeforeStep((w, dt) -> item.applyForce(0, -0.04 * 20 * 20));
        for (int tick = 0; tick < TICKS; tick++) {
            v -= 0.04;
            y += v;
            v *= keep;
            world.step();
            assertEquals(y, item.getY(), 1e-12);
        }
    }

    @Test
    void aListenerGivesOneAxisAnotherDrag() {
        double x = 0, y = 0, vx = 0.3, vy = 0, across = 0.91f, down = 0.98f;
        World world = new World(Integrator.EULER, Timestep.fixed(20));
        Unit creature = world.add(new Unit(1).setFriction((1 - down) * 20).setVelocity(vx * 20, 0));
        world.addBeforeStep((w, dt) -> creature.applyForce(0, -down * 0.08 * 20 * 20));
        world.addAfterStep((w, dt) -> creature.setVelocity(creature.getVx() * across / down, creature.getVy()));
        for (int tick = 0; tick < TICKS; tick++) {
            x += vx;
            y += vy;
            vx *= across;
            vy = (vy - 0.08) * down;
            world.step();
            assertEquals(x, creature.getX(), 1e-12);
            assertEquals(y, creature.getY(), 1e-12);
        }
    }

    @Test
    void speedAndKickPerTickAreMultipliedByTheRateAndAccelerationByItsSquare() {
        double x = 0, v = 0.5, mass = 40_000, gravity = 0.02, kick = 0.3;
        int rate = 30;
        World world = new World(Integrator.SEMI_IMPLICIT, Timestep.fixed(rate));
        Unit unit = world.add(new Unit(mass).setVelocity(v * rate, 0));
        world.addBeforeStep((w, dt) -> unit.applyForce(mass * gravity * rate * rate, 0));
        for (int tick = 0; tick < TICKS; tick++) {
            if (tick == 50) v += kick;
            if (tick == 50) unit.applyImpulse(mass * kick * rate, 0);
            v += gravity;
            x += v;
            world.step();
            assertEquals(x, unit.getX(), 1e-10);
        }
    }

    @Test
    void anImportTakesPrecedenceOverAClassUnitInTheSamePackage() throws Exception {
        Path library = Path.of(
                Unit.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        Path own = folder.resolve("Unit.java"), user = folder.resolve("User.java");
        Files.writeString(own, "package game; class Unit {}");
        Files.writeString(
                user,
                "package game; import yarts.physics.Unit; class User { double m = new Unit(1).getMass(); game.Unit own; }");
        int result = ToolProvider.getSystemJavaCompiler()
                .run(
                        null,
                        null,
                        null,
                        "-d",
                        folder.toString(),
                        "-cp",
                        library.toString(),
                        own.toString(),
                        user.toString());
        assertEquals(0, result, "does not compile");
    }
}
