package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;

/** The claims of docs/troubleshooting.md that its code blocks do not show. */
class TroubleshootingTest {
    @TempDir
    Path classes;

    @Test
    void theLineMarkedAsNotCompilingDoesNotCompile() throws Exception {
        Matcher block = Pattern.compile(
                        "```java\n((?:(?!```).)*?)// ([^\n]*) // does not compile(.*?)```", Pattern.DOTALL)
                .matcher(Files.readString(Path.of("docs/troubleshooting.md")));
        assertTrue(block.find());
        assertEquals("", compile(block.group(1) + block.group(3)));
        String errors = compile(block.group(1) + block.group(2) + block.group(3));
        assertTrue(errors.contains("incompatible types") && errors.contains("1 error"), errors);
    }

    private String compile(String block) throws Exception {
        Path file = classes.resolve("Block.java");
        Files.writeString(
                file, "import yarts.physics.*; class Block { static void run() throws Exception {" + block + "}}");
        Path library = Path.of(
                Unit.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        ToolProvider.getSystemJavaCompiler()
                .run(null, null, errors, "-d", classes.toString(), "-cp", library.toString(), file.toString());
        return errors.toString(StandardCharsets.UTF_8);
    }

    @Test
    void eachOfTheFiveCausesStopsAUnitAndItsCureLetsItMove() {
        assertCured(unit -> unit.setMotor(0, 0, 10), unit -> unit.setMotor(0, 0, 0));
        assertCured(unit -> unit.setFrozen(true), unit -> unit.setFrozen(false));
        assertCured(unit -> unit.setMaxSpeed(0), unit -> unit.setMaxSpeed(5));
        assertCured(unit -> unit.getWorld().remove(unit), unit -> {});

        World world = new World();
        Unit unit = world.add(new Unit(1).setVelocity(1, 0));
        world.advance(0);
        assertEquals(0, world.getTick());
        assertEquals(0, unit.getX());
    }

    /** Checks that a push of 9 N moves a unit only after the cure. */
    private static void assertCured(Consumer<Unit> cause, Consumer<Unit> cure) {
        World world = new World();
        Unit unit = world.add(new Unit(1));
        cause.accept(unit);
        unit.applyForce(9, 0);
        world.step();
        assertEquals(0, unit.getX());
        cure.accept(unit);
        if (unit.getWorld() == null) world.add(unit);
        unit.applyForce(9, 0);
        world.step();
        assertNotEquals(0, unit.getX());
    }

    @Test
    void ifTheStepIsCompletedBeforeAChangeOfTheTimestepThePictureDoesNotJump() {
        Random random = new Random(1);
        for (int game = 0; game < 2_000; game++) {
            int rate = 1 + random.nextInt(240);
            World world = new World(Integrator.EXACT, Timestep.fixed(rate));
            Unit unit = world.add(new Unit(1).setVelocity(10, 0));
            for (int frame = random.nextInt(8); frame >= 0; frame--) world.advance(random.nextDouble() / 20);
            world.advance((1 - world.getAlpha()) / rate);
            assertEquals(0, world.getAlpha());
            double drawn = unit.getInterpolatedX();
            world.setTimestep(Timestep.fixed(1 + random.nextInt(240)));
            assertEquals(drawn, unit.getInterpolatedX(), 2e-6); // half of 1e-9 old steps, in new steps
        }
    }

    @Test
    void afterClearTheFactoryCreatesAllUnitsOfASave() {
        World saved = new World(), running = new World();
        for (int i = 0; i < 3; i++) saved.add(new Unit(i + 1));
        for (int i = 0; i < 5; i++) running.add(new Unit(9));
        List<Unit> old = List.copyOf(running.units());
        running.clear();
        running.restore(saved.save(), id -> new Unit(1));
        assertEquals(saved.stateHash(), running.stateHash());
        for (Unit unit : old) assertNull(unit.getWorld());
    }
}
