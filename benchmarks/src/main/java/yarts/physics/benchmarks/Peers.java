package yarts.physics.benchmarks;

import java.util.function.Function;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/** The peers: libraries for comparison, each with the features that it lacks. */
public enum Peers {
    OBJECT_LIST("list of objects", Kind.SAME, ObjectList::inOrder),
    OBJECT_LIST_SHUFFLED("list of objects, shuffled", Kind.SAME, ObjectList::shuffled),
    ARTEMIS("artemis-odb", Kind.SAME, Artemis::new),
    ASHLEY("Ashley", Kind.SAME, Ashley::new),
    GDX_BOX2D("gdx-box2d (native)", Kind.FLOAT_ENGINE, GdxBox2d::new),
    DYN4J("dyn4j", Kind.DOUBLE_ENGINE, Dyn4j::new),
    JBOX2D("JBox2D", Kind.FLOAT_ENGINE, JBox2d::new);

    private enum Kind {
        /** The arithmetic of EULER, written by hand. */
        SAME("", 1e-9),
        /** A physics engine: no top speed per unit. It applies friction after forces, and moves by the new velocity. */
        DOUBLE_ENGINE("no top speed per unit", 1e-9),
        FLOAT_ENGINE("no top speed per unit; state in `float`", 1e-4);

        final String lacks;
        final double precision;

        Kind(String lacks, double precision) {
            this.lacks = lacks;
            this.precision = precision;
        }
    }

    private static final int CHECKED = 1000;
    private static final int STEPS = 120;

    final String label;
    private final Kind kind;
    private final Function<Army, Peer> maker;

    Peers(String label, Kind kind, Function<Army, Peer> maker) {
        this.label = label;
        this.kind = kind;
        this.maker = maker;
    }

    /** The features that it lacks; empty if it has all. */
    String lacks() {
        return kind.lacks;
    }

    Peer of(Army army) {
        return maker.apply(army);
    }

    /**
     * Compares the peer with this library: both step 1,000 of the units for two seconds from the same state.
     *
     * <p>The velocity of an engine differs for two reasons, with h = dt/m and z = f h. It also applies friction to the
     * velocity from the force of this step, a difference of up to h|F|. And Box2D divides by 1 + z instead of
     * multiplying by 1 − z, a difference of up to h|f v − F|. Both grow with n z over n steps, and are 0 without
     * friction. The position of an engine is ahead by dt (v − v at the start), because it moves by the new velocity.
     *
     * @throws IllegalStateException if the differences are greater
     */
    void check() {
        Army army = kind == Kind.SAME ? Army.of(CHECKED) : Army.of(CHECKED).uncapped();
        Peer peer = of(army);
        World world = army.world(Integrator.EULER);
        for (int n = 0; n < STEPS; n++) {
            peer.step();
            Workload.push(world);
            world.step(Workload.DT);
        }
        for (int i = 0; i < CHECKED; i++) {
            Unit unit = world.get(i);
            check(army, i, army.vx[i], Workload.FX, unit.getVx(), peer.vx(i), unit.getX(), peer.x(i));
            check(army, i, army.vy[i], Workload.FY, unit.getVy(), peer.vy(i), unit.getY(), peer.y(i));
        }
    }

    private void check(Army army, int i, double start, double force, double v, double theirV, double x, double theirX) {
        double h = Workload.DT / army.mass[i], f = army.friction[i];
        double damping = h * (Math.abs(force) + Math.abs(f * start - force)) * Math.min(1, STEPS * f * h);
        boolean same = kind == Kind.SAME;
        double allowed = same ? 0 : damping;
        double ahead = same ? 0 : Workload.DT * (theirV - start);
        check(i, "velocity", v, theirV, allowed);
        check(i, "position", x, theirX - ahead, allowed * STEPS * Workload.DT);
    }

    private void check(int i, String what, double ours, double theirs, double allowed) {
        double difference = Math.abs(theirs - ours);
        if (!(difference <= allowed + kind.precision * (1 + Math.abs(ours)))) {
            throw new IllegalStateException(
                    label + " differs in the " + what + " of unit " + i + ": " + theirs + ", ours is " + ours);
        }
    }
}
