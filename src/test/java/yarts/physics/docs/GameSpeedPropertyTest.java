package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.World;

/** The recipe of docs/cookbook.md for slow motion and fast forward, with frames of any length. */
class GameSpeedPropertyTest {
    @Property
    void noTimeIsDroppedAtAnySpeedAndALongFrameIsLimitedBeforeItIsMultiplied(
            @ForAll long seed,
            @ForAll @DoubleRange(min = 0, max = 20) double speed,
            @ForAll @DoubleRange(min = 0.01, max = 100) double longest) {
        World world = new World(Integrator.EXACT, Timestep.fixed(60).withMaxSteps(300));
        Random random = new Random(seed);
        double time = 0;
        for (int frame = 0; frame < 100; frame++) {
            double elapsed = longest * random.nextDouble();
            world.advance(speed * Math.min(elapsed, 0.25));
            time += speed * Math.min(elapsed, 0.25);
        }
        assertEquals(0, world.getDroppedTime());
        assertEquals(time, world.getTime() + world.getAlpha() / 60, 1e-6);
    }
}
