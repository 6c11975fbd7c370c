package yarts.physics.demo;

import com.madgag.gif.fmsware.AnimatedGifEncoder;
import java.awt.Color;
import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes a GIF that is small and fast to encode: all frames have one palette, and a frame stores only the pixels that
 * differ from the frame before.
 */
final class FilmEncoder extends AnimatedGifEncoder {
    private static final int COLOURS = 256, UNCHANGED = COLOURS - 1, KEEP = 1;

    private final int[] palette;
    private final Map<Integer, Byte> nearest = new HashMap<>();
    private byte[] shown = {};

    FilmEncoder(List<Color> palette) {
        if (palette.size() > UNCHANGED) throw new IllegalArgumentException(palette.size() + " colours");
        this.palette = palette.stream().mapToInt(Color::getRGB).toArray();
        setTransparent(Color.BLACK); // marks the pixels with the index UNCHANGED
        setDispose(KEEP);
        transIndex = UNCHANGED;
        colorDepth = 8;
        palSize = 7;
        colorTab = new byte[3 * COLOURS];
        for (int i = 0; i < palette.size(); i++) {
            colorTab[3 * i] = (byte) palette.get(i).getRed();
            colorTab[3 * i + 1] = (byte) palette.get(i).getGreen();
            colorTab[3 * i + 2] = (byte) palette.get(i).getBlue();
        }
    }

    @Override
    protected void analyzePixels() {
        byte[] now = new byte[pixels.length / 3];
        int last = -1;
        byte index = 0;
        for (int i = 0; i < now.length; i++) {
            int colour =
                    (pixels[3 * i] & 0xFF) | ((pixels[3 * i + 1] & 0xFF) << 8) | ((pixels[3 * i + 2] & 0xFF) << 16);
            if (colour != last) index = nearest.computeIfAbsent(colour, this::nearest);
            last = colour;
            now[i] = index;
        }
        indexedPixels = now.clone();
        if (!firstFrame) {
            for (int i = 0; i < now.length; i++) if (now[i] == shown[i]) indexedPixels[i] = (byte) UNCHANGED;
        }
        shown = now;
        pixels = null;
    }

    private byte nearest(int colour) {
        int best = 0, least = Integer.MAX_VALUE;
        for (int i = 0; i < palette.length; i++) {
            int distance =
                    square(palette[i], colour, 0) + square(palette[i], colour, 8) + square(palette[i], colour, 16);
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return (byte) best;
    }

    private static int square(int a, int b, int shift) {
        int difference = (a >> shift & 0xFF) - (b >> shift & 0xFF);
        return difference * difference;
    }

    /** The palette of the first frame is that of the file. */
    @Override
    protected void writePalette() throws IOException {
        if (firstFrame) super.writePalette();
    }

    @Override
    protected void writeImageDesc() throws IOException {
        out.write(',');
        writeShort(0);
        writeShort(0);
        writeShort(width);
        writeShort(height);
        out.write(0); // no palette of its own
    }
}
