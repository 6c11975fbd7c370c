package yarts.physics.comparison;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import yarts.physics.Integrator;

/** A force over no tick and over many: what the loops of games make of it. Measures tables of docs/comparison.md. */
class ForceComparisonTest {
    private static final int[] FRAME_RATES = {15, 60, 144, 240};

    @BeforeEach
    void nativeBox2dIsThere() {
        GdxBox2d.assumeIsThere();
    }

    /** A way to push and step, and who does it. */
    private record Way(String how, String who, Supplier<Engine> engine, Loop.Maker loop) {
        /** Momentum after ten seconds of 1 N, in parts of what it should be; give or take a step that is yet to come. */
        double gainedSteadily(int framesPerSecond) {
            return gained(framesPerSecond, 10 * framesPerSecond, -1) / 10;
        }

        /** The least and the most momentum after one frame of 1 N, in parts of what it should be. */
        String gainedInAFrame(int framesPerSecond) {
            DoubleSummaryStatistics gained = IntStream.range(0, 24) // ticks and frames coincide every 12 at the most
                    .mapToDouble(k -> gained(framesPerSecond, 48, k) * framesPerSecond)
                    .summaryStatistics();
            String least = Page.number(gained.getMin()), most = Page.number(gained.getMax());
            return least.equals(most) ? most : least + " or " + most;
        }

        private double gained(int framesPerSecond, int frames, int only) {
            Engine world = engine.get();
            Engine.Body body = world.add(1, 0, 0, 0);
            Loop frame = loop.of(world, body, framesPerSecond);
            for (int i = 0; i < frames; i++) frame.run(only < 0 || i == only);
            return body.v();
        }
    }

    private static List<Way> ways() {
        String inALoop = "push in each frame, steps in a loop", cleared = "the same, forces cleared once a frame";
        String inEachStep = "push in each step", ofTheFrame = "a step as long as the frame";
        return List.of(
                new Way(inALoop, "dyn4j's `update(elapsed, 10)`", Dyn4j::new, Loop::dyn4jUpdate),
                new Way(inALoop, "JBox2D", JBox2d::new, Loop::accumulate),
                new Way(inALoop, "gdx-box2d", GdxBox2d::new, Loop::accumulate),
                new Way(cleared, "JBox2D", JBox2d::new, Loop::clearOnceAFrame),
                new Way(cleared, "gdx-box2d", GdxBox2d::new, Loop::clearOnceAFrame),
                new Way(inEachStep, "dyn4j's step listener", Dyn4j::new, Loop::dyn4jListener),
                new Way(inEachStep, "JBox2D", JBox2d::new, Loop::pushInEachStep),
                new Way(inEachStep, "gdx-box2d", GdxBox2d::new, Loop::pushInEachStep),
                new Way(ofTheFrame, "dyn4j's `updatev(elapsed)`", Dyn4j::new, Loop::dyn4jUpdatev),
                new Way(ofTheFrame, "JBox2D", JBox2d::new, Loop::stepOfTheFrame),
                new Way(ofTheFrame, "gdx-box2d", GdxBox2d::new, Loop::stepOfTheFrame),
                new Way("`World.advance(elapsed)`", "this library", () -> new Ours(Integrator.EXACT), Loop::advance));
    }

    @Test
    void aSteadyPushAgainstFrameRate() {
        perFrameRate("steady-push", (way, rate) -> Page.number(way.gainedSteadily(rate), 2));
    }

    @Test
    void aPushOfOneFrameAgainstFrameRate() {
        perFrameRate("push-of-a-frame", Way::gainedInAFrame);
    }

    private interface PerFrameRate {
        String measure(Way way, int rate);
    }

    private static void perFrameRate(String name, PerFrameRate cell) {
        Map<List<String>, String> whoByHow = new LinkedHashMap<>();
        for (Way way : ways()) {
            List<String> row = new ArrayList<>(List.of(way.how));
            for (int rate : FRAME_RATES) row.add(cell.measure(way, rate));
            whoByHow.merge(row, way.who, (a, b) -> a + ", " + b);
        }
        Map<String, List<String>> rows = new LinkedHashMap<>();
        whoByHow.forEach((row, who) -> rows.put(row.get(0) + " (" + who + ")", row.subList(1, row.size())));
        List<String> head = new ArrayList<>(List.of("frames per second:"));
        IntStream.of(FRAME_RATES).mapToObj(String::valueOf).forEach(head::add);
        Page.check(name, head, rows);
    }
}
