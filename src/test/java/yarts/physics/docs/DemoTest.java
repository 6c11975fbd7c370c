package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
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
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import yarts.physics.demo.JitterTable;
import yarts.physics.demo.Plots;
import yarts.physics.demo.Rule;
import yarts.physics.demo.Skirmish;
import yarts.physics.demo.SkirmishFilm;
import yarts.physics.demo.SkirmishRun;

/** The text and the pictures of the demo. */
class DemoTest {
    private static final int PINK = 0xFF5C9A; // a jittering tank

    @TempDir
    Path folder;

    @Test
    void theNaiveRuleReversesInEveryStepIfZExceeds1AndTheLibraryNever() {
        List<JitterTable.Line> lines = JitterTable.lines();
        assertEquals(6 * 5, lines.size());
        for (JitterTable.Line line : lines) {
            for (int step = 1; step < line.v().length; step++) {
                boolean expected = line.rule() == Rule.NAIVE && line.z() > 1;
                assertEquals(expected, line.flips(step), line + ", step " + step);
            }
        }
        assertEquals(4, lines.stream().filter(line -> line.flips(1)).count()); // dt = 0.15, 0.2, 0.25 and 0.3
    }

    @Test
    void theTableHasAtMost100ColumnsAndMarksEachReversal() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        JitterTable.print(new PrintStream(bytes, true, StandardCharsets.US_ASCII));
        String table = bytes.toString(StandardCharsets.US_ASCII);
        assertTrue(table.lines().mapToInt(String::length).max().orElse(0) <= 100, table);
        assertTrue(
                table.contains(
                        "   0.15  1.5        -5.000!         0.000          4.000          1.429          2.231"),
                table);
        assertEquals(4 + 4 * 6, table.split("\\d!", -1).length - 1);
    }

    @Test
    void thePlotsAreDrawn() throws IOException {
        Plots.jitter(folder.resolve("jitter.png"));
        Plots.terminalSpeed(folder.resolve("terminal-speed.png"));
        Plots.motor(folder.resolve("motor.png"));
        assertDrawn(read("jitter.png"), 1240, 560, 0xD55E00, 0x0072B2, 0x56B4E9, 0x009E73);
        assertDrawn(read("terminal-speed.png"), 1000, 600, 0xD55E00, 0x0072B2, 0x009E73);
        assertDrawn(read("motor.png"), 1000, 600, 0xD55E00, 0xE69F00, 0x0072B2, 0x009E73);
    }

    @Test
    void theEndOfTheSkirmishIsDrawn() throws IOException {
        int[] ticks = {0};
        SkirmishRun run = new SkirmishRun(new Skirmish(200, 1));
        run.play(60, () -> ticks[0]++);
        assertEquals(60, ticks[0]);
        run.draw(folder.resolve("skirmish.png"));
        assertDrawn(read("skirmish.png"), 960, 746, 0xE69F00, 0x56B4E9);
    }

    /** From the second frame on, the file contains only changed pixels, so the test draws each frame over the last. */
    @Test
    void theFilmShowsJitteringTanksInItsNaiveHalfOnly() throws IOException {
        int frames = 80;
        int[] shot = {0};
        new SkirmishFilm(480, 1).shoot(folder.resolve("skirmish.gif"), frames, () -> shot[0]++);
        assertEquals(frames, shot[0]);
        ImageReader gif = ImageIO.getImageReadersByFormatName("gif").next();
        try (var in =
                ImageIO.createImageInputStream(folder.resolve("skirmish.gif").toFile())) {
            gif.setInput(in);
            assertEquals(frames, gif.getNumImages(true));
            BufferedImage film = new BufferedImage(828, 382, BufferedImage.TYPE_INT_RGB);
            for (int frame = 0; frame < frames; frame++) {
                film.getGraphics().drawImage(gif.read(frame), 0, 0, null);
                assertEquals(0, count(film.getSubimage(418, 34, 410, 320), PINK), "frame " + frame);
            }
            assertDrawn(film, 828, 382, 0xE69F00, 0x56B4E9);
            int pink = count(film.getSubimage(0, 34, 410, 320), PINK);
            assertTrue(pink > 1000, pink + " pixels");
            assertTrue(film.getWidth() <= 830, "wider than a README on GitHub");
            assertEquals(50, delay(gif, 0));
        } finally {
            gif.dispose();
        }
    }

    private static int delay(ImageReader gif, int frame) throws IOException {
        IIOMetadataNode root = (IIOMetadataNode) gif.getImageMetadata(frame).getAsTree("javax_imageio_gif_image_1.0");
        IIOMetadataNode control = (IIOMetadataNode)
                root.getElementsByTagName("GraphicControlExtension").item(0);
        return 10 * Integer.parseInt(control.getAttribute("delayTime"));
    }

    @Test
    void twoFilmsOfTheSameGameHaveTheSameBytes() throws IOException {
        byte[][] gifs = new byte[2][];
        for (int run = 0; run < 2; run++) {
            new SkirmishFilm(50, 1).shoot(folder.resolve("skirmish.gif"), 10, () -> {});
            gifs[run] = Files.readAllBytes(folder.resolve("skirmish.gif"));
        }
        assertArrayEquals(gifs[0], gifs[1]);
    }

    @Test
    void theFilmInTheDocsIsSmallerThanThreeMegabytes() throws IOException {
        long bytes = Files.size(Path.of("docs", "images", "skirmish.gif"));
        assertTrue(bytes < 3_000_000, bytes + " bytes");
    }

    private BufferedImage read(String name) throws IOException {
        return ImageIO.read(folder.resolve(name).toFile());
    }

    /** Checks the size of the image, and that it has many pixels of each colour. */
    private static void assertDrawn(BufferedImage image, int width, int height, int... colours) {
        assertEquals(width, image.getWidth());
        assertEquals(height, image.getHeight());
        assertTrue(Arrays.stream(pixels(image)).distinct().count() > 4);
        for (int colour : colours) {
            int count = count(image, colour);
            assertTrue(count > 300, count + " pixels of " + Integer.toHexString(colour));
        }
    }

    private static int count(BufferedImage image, int colour) {
        return (int) Arrays.stream(pixels(image))
                .filter(p -> (p & 0xFFFFFF) == colour)
                .count();
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }
}
