package yarts.physics.benchmarks;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.BitmapEncoder.BitmapFormat;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import yarts.physics.Integrator;

/** Draws the time per unit against the number of units: the library's and its peers'. */
final class Plot {
    /** The colours of Okabe and Ito, which colour-blind readers can distinguish: one for each line, in order. */
    private static final List<Color> COLOURS = List.of(
            new Color(0x0072B2),
            new Color(0x0072B2),
            new Color(0x0072B2),
            new Color(0x0072B2),
            Color.BLACK,
            Color.BLACK,
            new Color(0x009E73),
            new Color(0x56B4E9),
            new Color(0xE69F00),
            new Color(0xD55E00),
            new Color(0xCC79A7));

    private static final List<Marker> MARKERS = List.of(
            SeriesMarkers.SQUARE,
            SeriesMarkers.TRIANGLE_UP,
            SeriesMarkers.DIAMOND,
            SeriesMarkers.CROSS,
            SeriesMarkers.CIRCLE,
            SeriesMarkers.TRIANGLE_UP,
            SeriesMarkers.DIAMOND,
            SeriesMarkers.SQUARE,
            SeriesMarkers.TRIANGLE_DOWN,
            SeriesMarkers.CIRCLE,
            SeriesMarkers.TRIANGLE_UP);

    private Plot() {}

    static void draw(Results results, Path file) throws IOException {
        XYChart chart = new XYChart(1000, 700);
        chart.setTitle("A force on every unit and a step: less is better");
        chart.setXAxisTitle("units");
        chart.setYAxisTitle("ns per unit and step");
        XYStyler styler = chart.getStyler();
        styler.setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        styler.setXAxisDecimalPattern("#,###").setYAxisDecimalPattern("#,###");
        styler.setYAxisMin(1.0).setYAxisMax(2000.0).setLegendPosition(LegendPosition.OutsideE);
        styler.setChartBackgroundColor(Color.WHITE)
                .setPlotBorderVisible(false)
                .setChartTitleBoxVisible(false)
                .setChartTitleFont(font(Font.BOLD, 20))
                .setChartPadding(12)
                .setLegendFont(font(Font.PLAIN, 15))
                .setLegendBorderColor(Color.LIGHT_GRAY)
                .setMarkerSize(10);
        styler.setAxisTitleFont(font(Font.PLAIN, 16)).setAxisTickLabelsFont(font(Font.PLAIN, 16));

        List<Report.Line> lines = Report.contest();
        for (int k = lines.size() - 1; k >= 0; k--) { // the legend in the order of the curves, from the top
            Report.Line line = lines.get(k);
            int[] sizes = IntStream.of(results.sizes())
                    .filter(n -> line.in(results, n).isPresent())
                    .toArray();
            if (sizes.length == 0) continue;
            double[] ns = IntStream.of(sizes)
                    .mapToDouble(n -> line.in(results, n).orElseThrow().median())
                    .toArray();
            double[] units = IntStream.of(sizes).asDoubleStream().toArray();
            XYSeries series = chart.addSeries(line.label(), units, ns);
            series.setMarkerColor(COLOURS.get(k)).setMarker(MARKERS.get(k)).setLineColor(COLOURS.get(k));
            series.setLineStyle(new BasicStroke(k < Integrator.values().length ? 4 : 2));
        }
        BitmapEncoder.saveBitmap(chart, file.toString(), BitmapFormat.PNG);
    }

    private static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }
}
