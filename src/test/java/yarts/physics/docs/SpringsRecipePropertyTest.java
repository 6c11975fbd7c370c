package yarts.physics.docs;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import yarts.physics.Integrator;
import yarts.physics.Timestep;
import yarts.physics.Unit;
import yarts.physics.World;
import yarts.physics.support.Doubles;

/** The table of docs/cookbook.md, "Springs": one unit, two units and chains. Crowds are in SpringsRecipeTest. */
class SpringsRecipePropertyTest {
    private static final double DT = 1 / 64.0;

    /** A row of units with springs between neighbours; a spring may tie the first unit to a fixed point. */
    private enum Row {
        ONE(1, 1, true),
        PAIR(2, 2, false),
        CHAIN(8, 4, false),
        TIED_CHAIN(8, 4, true);
        final int units, count;
        final boolean tied;

        Row(int units, int count, boolean tied) {
            this.units = units;
            this.count = count;
            this.tied = tied;
        }

        /** The stiffness of the stiffest oscillation (the largest eigenvalue) in multiples of k. */
        double stiffest() {
            if (this == TIED_CHAIN) return 2 + 2 * Math.cos(2 * Math.PI / (2 * units + 1));
            return this == ONE ? 1 : 2 + 2 * Math.cos(Math.PI / units);
        }

        /** Returns whether the units come to rest from a random start, or the oscillations grow. */
        String play(Integrator how, double[] mass, double[] friction, double k) {
            World world = new World(how, Timestep.fixed(60));
            Random random = new Random(1);
            for (int i = 0; i < units; i++) {
                Unit unit = world.add(new Unit(mass[i % mass.length]).setFriction(friction[i % friction.length]));
                unit.setPosition((i % 2 == 0 ? 1 : -1) * (0.5 + random.nextDouble() / 2), 0);
            }
            world.addBeforeStep((w, dt) -> {
                for (int i = tied ? 0 : 1; i < units; i++) {
                    double pull = k
                            * (world.get(i).getX()
                                    - (i == 0 ? 0 : world.get(i - 1).getX()));
                    world.get(i).applyForce(-pull, 0);
                    if (i > 0) world.get(i - 1).applyForce(pull, 0);
                }
            });
            // At 95 % of the limit, the oscillations of the heaviest units decay by a factor of exp(−12) in this time.
            double ticks = 10_000 * Arrays.stream(mass).max().orElseThrow() / mass[0];
            for (int tick = 0; tick < ticks; tick++) {
                world.step(DT);
                for (Unit unit : world) if (Math.abs(unit.getX()) > 100) return "grows";
            }
            double fastest = 0;
            for (Unit unit : world) fastest = Math.max(fastest, unit.getSpeed());
            return fastest * DT < 1e-4 ? "calms" : "swings";
        }
    }

    @Provide
    Arbitrary<Double> stiffness() {
        return Doubles.logUniform(0.05, 20);
    }

    @Provide
    Arbitrary<Double> masses() {
        return Doubles.logUniform(1e-3, 1e3);
    }

    @Provide
    Arbitrary<Double> shares() {
        return Arbitraries.oneOf(
                Arbitraries.doubles().between(0.3, 0.95), Arbitraries.just(0.95), Arbitraries.just(0.5));
    }

    @Property(tries = 300)
    void belowTheLimitOfTheTableUnitsOnSpringsComeToRest(
            @ForAll Integrator how,
            @ForAll Row row,
            @ForAll("masses") double mass,
            @ForAll("stiffness") double z,
            @ForAll("shares") double share) {
        double friction = z * mass / DT, k = share * SpringsRecipeTest.limit(how, row.count, mass, friction, DT);
        String what = row.play(how, new double[] {mass}, new double[] {friction}, k);
        assertTrue(what.equals("calms"), what);
    }

    /** The limit follows from the smallest mass and the smallest friction. */
    @Property(tries = 300)
    void differentUnitsComeToRestBelowTheLimitOfTheirSmallestMassAndFriction(
            @ForAll Integrator how,
            @ForAll Row row,
            @ForAll("stiffness") double z,
            @ForAll @DoubleRange(min = 1, max = 20) double heavier,
            @ForAll @DoubleRange(min = 1, max = 5) double rougher,
            @ForAll @IntRange(min = 1, max = 3) int heavyUnits) {
        double friction = z / DT, k = 0.9 * SpringsRecipeTest.limit(how, row.count, 1, friction, DT);
        double[] masses = {1, 1, 1, 1}, frictions = {friction, friction * rougher, friction};
        for (int i = 1; i <= heavyUnits; i++) masses[i] = heavier;
        String what = row.play(how, masses, frictions, k);
        assertTrue(what.equals("calms"), what);
    }

    /** The limit has no margin: oscillations grow at 5 % above the limit of the stiffest one, with the exact lag. */
    @Property(tries = 300)
    void aboveTheLimitTheOscillationsGrow(
            @ForAll Integrator how,
            @ForAll Row row,
            @ForAll("masses") double mass,
            @ForAll("stiffness") double z,
            @ForAll @DoubleRange(min = 1.05, max = 3) double share) {
        double friction = z * mass / DT, limit = SpringsRecipeTest.limit(how, 1, mass, friction, DT);
        double lag = 1 / z - 1 / Math.expm1(z);
        if (how == Integrator.EXACT) limit = friction / (lag * DT);
        Assume.that(how != Integrator.EXACT || z < 3);
        String what = row.play(how, new double[] {mass}, new double[] {friction}, share * limit / row.stiffest());
        assertTrue(what.equals("grows"), what);
    }

    /** At f = k·dt, which is enough for one unit under EULER, the oscillations of a pair and of a chain grow. */
    @Property(tries = 100)
    void theRuleForOneUnitIsNotEnoughForAPairOrAChain(@ForAll("masses") double mass, @ForAll("stiffness") double z) {
        double friction = z * mass / DT;
        for (Row row : Row.values()) {
            String what = row.play(Integrator.EULER, new double[] {mass}, new double[] {friction}, 0.9 * friction / DT);
            assertTrue(what.equals(row == Row.ONE ? "calms" : "grows"), row + " " + what);
        }
    }
}
