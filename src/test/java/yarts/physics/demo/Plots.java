package yarts.physics.demo;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.knowm.xchart.AnnotationLine;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.BitmapEncoder.BitmapFormat;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import yarts.physics.Integrator;
import yarts.physics.Unit;

/** Plots the rules: velocity over time, and terminal speed over the tick rate. */
public final class Plots {
    // Okabe and Ito's colours, which colour-blind people can tell apart.
    private static final Color VERMILION = new Color(0xD55E00);
    private static final Color ORANGE = new Color(0xE69F00);
    private static final Color BLUE = new Color(0x0072B2);
    private static final Color SKY = new Color(0x56B4E9);
    private static final Color GREEN = new Color(0x009E73);
    private static final Color PURPLE = new Color(0xCC79A7);
    private static final Color GREY = new Color(0x666666);

    private static final double MASS = 1; // kg
    private static final double FRICTION = 10; // N·s/m
    private static final double DRY = 10; // N
    private static final double SPEED = 10; // m/s, at the start or at the end
    private static final double OFF_THE_CHART = 1000; // m/s

    private Plots() {}

    /** Velocity against time, beyond the naive rule's limits: without a force (left) and under a steady push (right). */
    public static void jitter(Path file) throws IOException {
        List<XYChart> charts = List.of(
                overTime("No push: it should come to rest, at 0 m/s", SPEED, 0, 0),
                overTime("A steady push: it should reach F/f = 10 m/s", 0, FRICTION * SPEED, SPEED));
        BitmapEncoder.saveBitmap(charts, 1, 2, file.toString(), BitmapFormat.PNG);
    }

    private static XYChart overTime(String title, double v, double force, double goal) {
        XYChart chart = chart(620, 560, title, "time, s   (m = 1 kg, f = 10 N·s/m, z = f·dt/m)", "velocity, m/s");
        chart.getStyler().setLegendPosition(LegendPosition.InsideNW);
        chart.getStyler().setYAxisMin(goal - 25).setYAxisMax(goal + 40);
        overTime(chart, "naive, z = 2.1", Rule.NAIVE, 0.21, v, force, ORANGE, SeriesMarkers.TRIANGLE_UP);
        overTime(chart, "naive, z = 1.8", Rule.NAIVE, 0.18, v, force, VERMILION, SeriesMarkers.CIRCLE);
        overTime(chart, "EULER, z = 1.8", Rule.EULER, 0.18, v, force, BLUE, SeriesMarkers.SQUARE);
        overTime(chart, "SEMI_IMPLICIT, z = 1.8", Rule.SEMI_IMPLICIT, 0.18, v, force, SKY, SeriesMarkers.TRIANGLE_DOWN);
        overTime(chart, "MIDPOINT, z = 1.8", Rule.MIDPOINT, 0.18, v, force, GREEN, SeriesMarkers.DIAMOND);
        overTime(chart, "EXACT, z = 1.8", Rule.EXACT, 0.18, v, force, Color.BLACK, SeriesMarkers.CROSS);
        return chart;
    }

    private static void overTime(
            XYChart chart, String name, Rule rule, double dt, double v, double force, Color colour, Marker marker) {
        int steps = (int) (2 / dt);
        double[] velocity = rule.velocities(v, force, FRICTION, MASS, dt, steps);
        style(chart.addSeries(name, times(dt, steps), velocity), colour, marker, 2);
    }

    private static double[] times(double dt, int steps) {
        return IntStream.rangeClosed(0, steps).mapToDouble(i -> i * dt).toArray();
    }

    /** Velocity against time under dry friction, by the naive rule and by the motor; and under linear friction. */
    public static void motor(Path file) throws IOException {
        String title = "Dry friction: the unit should stop after 1 s and stay at rest";
        XYChart chart = chart(1000, 600, title, "time, s   (m = 1 kg, R = 10 N, u = 0)", "velocity, m/s");
        chart.getStyler().setLegendPosition(LegendPosition.InsideNE);
        chart.getStyler().setXAxisMin(0.0).setXAxisMax(3.0).setYAxisMin(-3.0).setYAxisMax(10.0);
        Unit linear = new Unit(MASS).setFriction(2);
        slowing(chart, "linear friction: −f·v, f = 2 N·s/m", library(linear, 0.02), 0.02, GREY, SeriesMarkers.NONE);
        naive(chart, 0.4, ORANGE, SeriesMarkers.TRIANGLE_UP);
        naive(chart, 0.154, VERMILION, SeriesMarkers.CIRCLE);
        braked(chart, 0.4, GREEN, SeriesMarkers.DIAMOND);
        braked(chart, 0.154, BLUE, SeriesMarkers.SQUARE);
        BitmapEncoder.saveBitmap(chart, file.toString(), BitmapFormat.PNG);
    }

    private static void naive(XYChart chart, double dt, Color colour, Marker marker) {
        DoubleUnaryOperator step = v -> v - DRY * Math.signum(v) * dt / MASS;
        slowing(chart, "naive: −R·v/|v|, steps of " + dt + " s", step, dt, colour, marker);
    }

    private static void braked(XYChart chart, double dt, Color colour, Marker marker) {
        Unit unit = new Unit(MASS).setMotor(0, 0, DRY);
        slowing(chart, "motor, steps of " + dt + " s", library(unit, dt), dt, colour, marker);
    }

    private static DoubleUnaryOperator library(Unit unit, double dt) {
        return v -> {
            unit.setVelocity(v, 0).integrate(dt, Integrator.EXACT);
            return unit.getVx();
        };
    }

    private static void slowing(
            XYChart chart, String name, DoubleUnaryOperator step, double dt, Color colour, Marker marker) {
        int steps = (int) (3 / dt);
        double[] velocity = DoubleStream.iterate(SPEED, step).limit(steps + 1).toArray();
        style(chart.addSeries(name, times(dt, steps), velocity), colour, marker, 2);
    }

    /** Terminal speed against tick rate. The library's is F/f at every rate. */
    public static void terminalSpeed(Path file) throws IOException {
        String title = "Terminal speed under a steady push: it should be F/f = 10 m/s";
        String x = "ticks per second   (F = 100 N, m = 1 kg, f = 10 N·s/m, z = f·dt/m)";
        XYChart chart = chart(1000, 600, title, x, "speed after 60 s, m/s");
        chart.getStyler().setLegendPosition(LegendPosition.InsideNE);
        chart.getStyler().setXAxisLogarithmic(true).setXAxisMin(2.0).setXAxisMax(1000.0);
        chart.getStyler().setYAxisMin(0.0).setYAxisMax(30.0);
        curve(chart, "naive: v' = v + (F − f·v)·dt/m", Rule.NAIVE, VERMILION, 7);
        curve(chart, "damp, then push: v' = v·max(0, 1 − z) + F·dt/m", Rule.DAMP_THEN_PUSH, ORANGE, 3);
        curve(chart, "push, then damp: v' = (v + F·dt/m)·max(0, 1 − z)", Rule.PUSH_THEN_DAMP, PURPLE, 3);
        points(chart, Rule.EULER, BLUE, SeriesMarkers.SQUARE, 22);
        points(chart, Rule.SEMI_IMPLICIT, SKY, SeriesMarkers.TRIANGLE_DOWN, 20);
        points(chart, Rule.MIDPOINT, GREEN, SeriesMarkers.DIAMOND, 12);
        points(chart, Rule.EXACT, Color.BLACK, SeriesMarkers.CROSS, 22);
        limit(chart, 2);
        limit(chart, 1);
        BitmapEncoder.saveBitmap(chart, file.toString(), BitmapFormat.PNG);
    }

    private static void curve(XYChart chart, String name, Rule rule, Color colour, float width) {
        double[] rates = rates(271);
        style(chart.addSeries(name, rates, speeds(rule, rates)), colour, SeriesMarkers.NONE, width);
    }

    /** All integrators have their points at the same rates. The sizes of their markers keep all four visible. */
    private static void points(XYChart chart, Rule rule, Color colour, Marker marker, int size) {
        double[] rates = rates(10);
        style(chart.addSeries(rule.name(), rates, speeds(rule, rates)), colour, sized(marker, size), 2);
    }

    private static Marker sized(Marker marker, int size) {
        return new Marker() {
            @Override
            public void paint(Graphics2D g, double x, double y, int ignored) {
                marker.paint(g, x, y, size);
            }
        };
    }

    /** Tick rates, n of them evenly spaced on a logarithmic axis from 2 to 1,000. */
    private static double[] rates(int n) {
        return IntStream.range(0, n)
                .mapToDouble(i -> 2 * Math.pow(500, i / (n - 1.0)))
                .toArray();
    }

    private static double[] speeds(Rule rule, double[] rates) {
        return DoubleStream.of(rates)
                .map(rate -> {
                    int steps = (int) (60 * rate);
                    double[] v = rule.velocities(0, FRICTION * SPEED, FRICTION, MASS, 1 / rate, steps);
                    return Math.min(OFF_THE_CHART, Math.abs(v[steps]));
                })
                .toArray();
    }

    private static void limit(XYChart chart, double z) {
        double rate = FRICTION / MASS / z;
        chart.addAnnotation(new AnnotationLine(rate, true, false));
        String text = String.format(Locale.ROOT, "z = %.0f: %.0f/s", z, rate);
        chart.addAnnotation(new AnnotationText(text, 1.35 * rate, 29, false));
    }

    private static void style(XYSeries series, Color colour, Marker marker, float width) {
        series.setMarkerColor(colour).setMarker(marker).setLineColor(colour);
        series.setLineStyle(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    }

    private static XYChart chart(int width, int height, String title, String x, String y) {
        XYChart chart = new XYChart(width, height);
        chart.setTitle(title);
        chart.setXAxisTitle(x);
        chart.setYAxisTitle(y);
        XYStyler styler = chart.getStyler();
        styler.setChartBackgroundColor(Color.WHITE)
                .setPlotBorderVisible(false)
                .setChartTitleBoxVisible(false)
                .setChartTitleFont(font(Font.BOLD, 20))
                .setChartTitlePadding(12)
                .setChartPadding(12)
                .setLegendFont(font(Font.PLAIN, 16))
                .setLegendBorderColor(Color.LIGHT_GRAY)
                .setAnnotationLineColor(GREY)
                .setAnnotationTextFont(font(Font.PLAIN, 16))
                .setMarkerSize(10);
        styler.setAxisTitleFont(font(Font.PLAIN, 16)).setAxisTickLabelsFont(font(Font.PLAIN, 16));
        return chart;
    }

    private static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }
}
