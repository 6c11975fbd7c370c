package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import yarts.physics.demo.JitterTable;
import yarts.physics.demo.Plots;
import yarts.physics.demo.Rule;
import yarts.physics.demo.Skirmish;
import yarts.physics.demo.SkirmishFilm;
import yarts.physics.demo.Tank;

/** What the demo says and draws is so. */
class DemoTest {
    @TempDir
    Path folder;

    @Test
    void theNaiveRuleFlipsAtEveryStepExactlyWhereZIsOver1AndTheLibraryNever() {
        List<JitterTable.Line> lines = JitterTable.lines();
        assertEquals(6 * 4, lines.size());
        for (JitterTable.Line line : lines) {
            for (int step = 1; step < line.v().length; step++) {
                boolean expected = line.rule() == Rule.NAIVE && line.z() > 1;
                assertEquals(expected, line.flips(step), line + ", step " + step);
            }
        }
        assertEquals(4, lines.stream().filter(line -> line.flips(1)).count()); // dt = 0.15, 0.2, 0.25 and 0.3
    }

    @Test
    void theTableFitsATerminalAndMarksEachFlip() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        JitterTable.print(new PrintStream(bytes, true, StandardCharsets.US_ASCII));
        String table = bytes.toString(StandardCharsets.US_ASCII);
        assertTrue(table.lines().mapToInt(String::length).max().orElse(0) <= 100, table);
        assertTrue(table.contains("   0.15  1.5     -5.000!      0.000       1.429       2.231"), table);
        assertEquals(4 + 4 * 6, table.split("\\d!", -1).length - 1);
    }

    @Test
    void thePlotsAreDrawn() throws IOException {
        Plots.jitter(folder.resolve("jitter.png"));
        Plots.terminalSpeed(folder.resolve("terminal-speed.png"));
        assertDrawn(read("jitter.png"), 1240, 560, 0xD55E00, 0x0072B2, 0x009E73);
        assertDrawn(read("terminal-speed.png"), 1000, 600, 0xD55E00, 0x0072B2, 0x009E73);
    }

    @Test
    void theSkirmishIsFilmed() throws IOException {
        int[] ticks = {0};
        SkirmishFilm film = new SkirmishFilm(new Skirmish(200, 1));
        film.shoot(folder, 36, () -> ticks[0]++);
        assertEquals(36, ticks[0]);
        assertDrawn(read("skirmish.png"), 960, 746, 0xE69F00, 0x56B4E9);
        ImageReader gif = ImageIO.getImageReadersByFormatName("gif").next();
        try (var in =
                ImageIO.createImageInputStream(folder.resolve("skirmish.gif").toFile())) {
            gif.setInput(in);
            assertEquals(3, gif.getNumImages(true));
            assertDrawn(gif.read(0), 480, 386);
            assertNotEquals(Arrays.hashCode(pixels(gif.read(0))), Arrays.hashCode(pixels(gif.read(2))));
        } finally {
            gif.dispose();
        }
    }

    @Test
    void theSamePicturesAreTheSameBytes() throws IOException {
        byte[][] gifs = new byte[2][];
        for (int run = 0; run < 2; run++) {
            new SkirmishFilm(new Skirmish(50, 1)).shoot(folder, 24, () -> {});
            gifs[run] = Files.readAllBytes(folder.resolve("skirmish.gif"));
        }
        assertArrayEquals(gifs[0], gifs[1]);
    }

    @Test
    void theSameSeedPlaysTheSameSkirmishToTheBit() {
        assertEquals(play(1), play(1));
        assertNotEquals(play(1), play(2));
    }

    private static long play(long seed) {
        Skirmish game = new Skirmish(300, seed);
        for (int tick = 0; tick < 600; tick++) game.tick(); // 10 s: the armies have met
        return game.stateHash();
    }

    /** Under a barrage that moves them all about, they do not get into each other, at 2.6 m, nor close to it. */
    @Test
    void tanksKeepTheirDistance() {
        for (int seed = 1; seed <= 3; seed++) {
            Skirmish game = new Skirmish(100, seed);
            while (game.time() < 9) game.tick();
            Tank[] tanks = game.tanks();
            Random random = new Random(seed);
            double x = tanks[0].getX() - 15, y = tanks[0].getY() - 15;
            for (int second = 0; second < 10; second++) {
                for (int shell = 0; shell < 12; shell++) {
                    game.blastAt(x + 30 * random.nextDouble(), y + 30 * random.nextDouble());
                    for (int tick = 0; tick < 5; tick++) game.tick();
                }
                for (int i = 0; i < tanks.length; i++) {
                    for (int j = 0; j < i; j++) {
                        double distance =
                                Math.hypot(tanks[i].getX() - tanks[j].getX(), tanks[i].getY() - tanks[j].getY());
                        assertTrue(distance > 2.6, game.time() + " s: " + distance);
                    }
                }
            }
        }
    }

    @Test
    void aBlastThrowsTanksAndTheyComeBack() {
        Skirmish game = new Skirmish(200, 4);
        while (game.time() < 9) game.tick();
        Tank[] tanks = game.tanks();
        game.blastAt(tanks[0].getX() + 1, tanks[0].getY() + 1);
        double blast = game.time();
        double[] farthest = new double[tanks.length], nearest = new double[tanks.length];
        while (game.time() < blast + 5) {
            game.tick();
            for (int i = 0; i < tanks.length; i++) {
                farthest[i] = Math.max(farthest[i], tanks[i].astray());
                nearest[i] = game.time() < blast + 0.5 ? farthest[i] : Math.min(nearest[i], tanks[i].astray());
            }
        }
        assertTrue(farthest[0] > 3, farthest[0] + " m");
        int thrown = 0;
        for (int i = 0; i < tanks.length; i++) {
            if (tanks[i].lastHit() != blast) continue;
            thrown++;
            assertTrue(nearest[i] < 0.1, farthest[i] + " m off, and never nearer again than " + nearest[i]);
        }
        assertTrue(thrown > 5, thrown + " thrown");
    }

    /** In a minute every lane's front has moved; and no tank has been beyond the enemy's first rank. */
    @Test
    void theFrontMovesAndHolds() {
        Skirmish game = new Skirmish(250, 5);
        double[] least = new double[5], most = new double[5];
        Arrays.fill(least, Skirmish.WIDTH);
        while (game.time() < 60) {
            game.tick();
            double[] west = new double[5], east = new double[5];
            Arrays.fill(east, Skirmish.WIDTH);
            for (Tank tank : game.tanks()) {
                int lane = (int) ((tank.getY() - 5) / 58);
                if (tank.isWest()) west[lane] = Math.max(west[lane], tank.getX());
                else east[lane] = Math.min(east[lane], tank.getX());
            }
            for (int lane = 0; lane < 5; lane++) {
                assertTrue(west[lane] + 5 < east[lane], game.time() + " s: " + west[lane] + " to " + east[lane]);
                if (game.time() < 10) continue; // before, they come to the front
                least[lane] = Math.min(least[lane], west[lane]);
                most[lane] = Math.max(most[lane], west[lane]);
            }
        }
        for (int lane = 0; lane < 5; lane++) assertTrue(most[lane] - least[lane] > 8, Arrays.toString(most));
    }

    /** z = 40/15 = 2.7. What still turns tanks round in the library is shoves and blasts. */
    @Test
    void naiveFrictionJittersAt15TicksASecondAndTheLibraryDoesNot() {
        assertTrue(turnedPerTick(true) > 0.25, turnedPerTick(true) + " of all tanks at each tick");
        assertTrue(turnedPerTick(false) < 0.01, turnedPerTick(false) + " of all tanks at each tick");
    }

    private static double turnedPerTick(boolean naive) {
        Skirmish game = new Skirmish(250, 1);
        game.setTicksPerSecond(15);
        game.setNaive(naive);
        double turned = 0;
        for (int tick = 0; tick < 300; tick++) {
            game.tick();
            turned += game.turned();
        }
        return turned / 300 / game.tanks().length;
    }

    /** As many as asked for, wherever the companies are not full. */
    @Test
    void armiesMayHaveAnySize() {
        for (int n : new int[] {1, 49, 50, 51, 137, 1000}) {
            Skirmish game = new Skirmish(n, 1);
            for (int tick = 0; tick < 100; tick++) game.tick();
            assertEquals(2 * n, game.world().size());
            assertEquals(n, Arrays.stream(game.tanks()).filter(Tank::isWest).count());
        }
    }

    private BufferedImage read(String name) throws IOException {
        return ImageIO.read(folder.resolve(name).toFile());
    }

    /** It has the size, more than a few colours, and enough of those that mark what it is about. */
    private static void assertDrawn(BufferedImage image, int width, int height, int... colours) {
        assertEquals(width, image.getWidth());
        assertEquals(height, image.getHeight());
        int[] pixels = pixels(image);
        assertTrue(Arrays.stream(pixels).distinct().count() > 4);
        for (int colour : colours) {
            long count =
                    Arrays.stream(pixels).filter(p -> (p & 0xFFFFFF) == colour).count();
            assertTrue(count > 300, count + " pixels of " + Integer.toHexString(colour));
        }
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }
}
