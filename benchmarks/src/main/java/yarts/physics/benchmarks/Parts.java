package yarts.physics.benchmarks;

/** The state of a unit as components of an entity, and its movement, for both entity systems. */
final class Parts {
    private Parts() {}

    /** A component for Ashley and for artemis-odb, which creates its components itself. */
    public abstract static class Part extends com.artemis.Component implements com.badlogic.ashley.core.Component {}

    public static final class Position extends Part {
        double x, y;
    }

    public static final class Velocity extends Part {
        double vx, vy;
    }

    public static final class Force extends Part {
        double fx, fy;
    }

    public static final class Body extends Part {
        double mass, friction, maxSpeed;
    }

    static void start(Army army, int i, Velocity v, Body body) {
        body.mass = army.mass[i];
        body.friction = army.friction[i];
        body.maxSpeed = army.maxSpeed[i];
        v.vx = army.vx[i];
        v.vy = army.vy[i];
        cap(v, body.maxSpeed);
    }

    static void push(Force f) {
        f.fx += Workload.FX;
        f.fy += Workload.FY;
    }

    static void move(Position p, Velocity v, Force f, Body body, double dt) {
        double h = dt / body.mass, z = body.friction * h;
        double decay = Math.max(0, 1 - z), gain = h / Math.max(1, z);
        p.x += dt * v.vx;
        p.y += dt * v.vy;
        v.vx = decay * v.vx + gain * f.fx;
        v.vy = decay * v.vy + gain * f.fy;
        cap(v, body.maxSpeed);
        f.fx = 0;
        f.fy = 0;
    }

    private static void cap(Velocity v, double maxSpeed) {
        double square = v.vx * v.vx + v.vy * v.vy;
        if (square > maxSpeed * maxSpeed) {
            double k = maxSpeed / Math.sqrt(square);
            v.vx *= k;
            v.vy *= k;
        }
    }
}
