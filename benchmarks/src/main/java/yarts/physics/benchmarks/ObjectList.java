package yarts.physics.benchmarks;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** No library: a list of objects with double fields; each object steps itself. */
final class ObjectList implements Peer {
    private final List<Soldier> inOrder = new ArrayList<>();
    private final List<Soldier> list;

    private ObjectList(Army army, boolean shuffle) {
        Soldier[] made = new Soldier[army.size];
        for (int i = 0; i < army.size; i++) {
            int j = i;
            made[i] = shuffle ? Garbage.among(() -> new Soldier(army, j)) : new Soldier(army, j);
        }
        Collections.addAll(inOrder, made);
        Workload.collect(); // before the list is shuffled: a copying collector would follow its order
        list = new ArrayList<>(inOrder);
        if (shuffle) Collections.shuffle(list, new Random(4));
    }

    /** Objects whose order on the heap is that of the list. */
    static Peer inOrder(Army army) {
        return new ObjectList(army, false);
    }

    /** Objects that were created among garbage, in a list that was shuffled afterwards. */
    static Peer shuffled(Army army) {
        return new ObjectList(army, true);
    }

    @Override
    public void step() {
        for (Soldier soldier : list) soldier.applyForce(Workload.FX, Workload.FY);
        for (Soldier soldier : list) soldier.integrate(Workload.DT);
    }

    private static final class Soldier {
        private final double mass, friction, maxSpeed;
        private double x, y, vx, vy, fx, fy;

        Soldier(Army army, int i) {
            mass = army.mass[i];
            friction = army.friction[i];
            maxSpeed = army.maxSpeed[i];
            vx = army.vx[i];
            vy = army.vy[i];
            double speed = Math.sqrt(vx * vx + vy * vy);
            if (speed > maxSpeed) {
                vx *= maxSpeed / speed;
                vy *= maxSpeed / speed;
            }
        }

        void applyForce(double fx, double fy) {
            this.fx += fx;
            this.fy += fy;
        }

        void integrate(double dt) {
            double h = dt / mass, z = friction * h;
            double decay = Math.max(0, 1 - z), gain = h / Math.max(1, z);
            x += dt * vx;
            y += dt * vy;
            vx = decay * vx + gain * fx;
            vy = decay * vy + gain * fy;
            double square = vx * vx + vy * vy;
            if (square > maxSpeed * maxSpeed) {
                double k = maxSpeed / Math.sqrt(square);
                vx *= k;
                vy *= k;
            }
            fx = 0;
            fy = 0;
        }
    }

    @Override
    public double x(int i) {
        return inOrder.get(i).x;
    }

    @Override
    public double y(int i) {
        return inOrder.get(i).y;
    }

    @Override
    public double vx(int i) {
        return inOrder.get(i).vx;
    }

    @Override
    public double vy(int i) {
        return inOrder.get(i).vy;
    }
}
