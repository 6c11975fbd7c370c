package yarts.physics.demo;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The source's example in numbers: with longer steps, a sliding unit does not stop by the naive rule. */
public final class JitterTable {
    static final double SPEED = 10; // m/s, at the start
    static final double FRICTION = 10; // N·s/m
    static final double MASS = 1; // kg
    private static final double[] DTS = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3}; // s
    private static final Rule[] RULES = {Rule.NAIVE, Rule.EULER, Rule.SEMI_IMPLICIT, Rule.MIDPOINT, Rule.EXACT};
    private static final int STEPS = 6;

    /** A line of the table: the velocities at the start and after each step. */
    public record Line(double dt, Rule rule, double[] v) {
        /** z = f dt/m, which alone determines the behaviour. */
        public double z() {
            return FRICTION * dt / MASS;
        }

        /** Whether a step, counted from 1, reverses the velocity. */
        public boolean flips(int step) {
            return v[step] * v[step - 1] < 0;
        }
    }

    private JitterTable() {}

    /** All lines: one for each dt and rule. */
    public static List<Line> lines() {
        List<Line> lines = new ArrayList<>();
        for (double dt : DTS) {
            for (Rule rule : RULES) {
                lines.add(new Line(dt, rule, rule.velocities(SPEED, 0, FRICTION, MASS, dt, STEPS)));
            }
        }
        return lines;
    }

    public static void print(PrintStream out) {
        out.println("The jitters: m = 1 kg, f = 10 N s/m, v = 10 m/s, no force. Friction should bring the unit");
        out.println("to rest. The naive rule is v' = v - (f v/m) dt.  z = f dt/m,  ! = reversed.");
        out.printf("%nVelocity after one step, in m/s%n%n  dt, s    z");
        for (Rule rule : RULES) out.printf("%14s ", rule);
        for (Line line : lines()) {
            if (line.rule == RULES[0]) out.printf(Locale.ROOT, "%n   %.2f  %.1f", line.dt, line.z());
            out.print("   " + cell(line, 1));
        }
        out.printf("%n%nVelocity step by step, in m/s%n%n  dt, s    z  rule         ");
        for (int step = 1; step <= STEPS; step++) out.printf("%11s ", "step " + step);
        for (Line line : lines()) {
            if (line.rule == RULES[0]) out.printf(Locale.ROOT, "%n   %.2f  %.1f  %-13s", line.dt, line.z(), line.rule);
            else out.printf("%n%14s%-13s", "", line.rule);
            for (int step = 1; step <= STEPS; step++) out.print(cell(line, step));
        }
        out.println();
    }

    private static String cell(Line line, int step) {
        return String.format(Locale.ROOT, "%11.3f%s", line.v[step], line.flips(step) ? "!" : " ");
    }
}
