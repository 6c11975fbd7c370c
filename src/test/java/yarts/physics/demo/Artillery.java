package yarts.physics.demo;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import yarts.physics.support.Churn;

/** The guns of both armies' first echelons. Shells fly and burst; heavy ones throw the tanks around them. */
final class Artillery {
    private static final double SHOTS_PER_SECOND = 0.05; // of each gun
    private static final double HEAVY = 0.25; // of all shells
    private static final double SHELL_SPEED = 110, RECOIL = 20; // m/s
    private static final double MISS = 4; // m
    /** A gun picks the nearest of this many random targets, from north to south. */
    private static final int RIVALS = 8;

    static final double BLAST_RADIUS = 17; // m
    /** The speed that a blast gives to a tank at its centre. */
    private static final double BLAST = 60; // m/s

    private static final int KEPT_BLASTS = 40;

    private final Tank[] tanks;
    private final Tank[] west, east;
    private final List<Skirmish.Shell> shells = new ArrayList<>();
    private final Deque<Skirmish.Blast> blasts = new ArrayDeque<>();
    private int count;

    Artillery(Tank[] tanks) {
        this.tanks = tanks;
        west = guns(tanks, true);
        east = guns(tanks, false);
    }

    private static Tank[] guns(Tank[] tanks, boolean west) {
        List<Tank> guns = new ArrayList<>();
        for (Tank tank : tanks) if (tank.isWest() == west && tank.company.line.depth == 0) guns.add(tank);
        return guns.toArray(new Tank[0]);
    }

    void fire(Dice dice, double time, double dt) {
        if (dice.next() < SHOTS_PER_SECOND * (west.length + east.length) * dt) {
            boolean fromWest = dice.next() < 0.5;
            Tank[] guns = fromWest ? west : east, rivals = fromWest ? east : west;
            Tank gun = guns[dice.below(guns.length)];
            Tank target = rivals[dice.below(rivals.length)];
            for (int i = 1; i < RIVALS; i++) {
                Tank other = rivals[dice.below(rivals.length)];
                if (Math.abs(other.getY() - gun.getY()) < Math.abs(target.getY() - gun.getY())) target = other;
            }
            if (!gun.isSliding(time)) shoot(gun, target, dice, time);
        }
        for (int i = shells.size() - 1; i >= 0; i--) { // no iterator: no garbage
            Skirmish.Shell shell = shells.get(i);
            if (time < shell.bursts()) continue;
            shells.remove(i);
            if (shell.heavy()) burst(shell.x(), shell.y(), time);
        }
    }

    private void shoot(Tank gun, Tank target, Dice dice, double time) {
        double x = target.getX() + dice.within(MISS), y = target.getY() + dice.within(MISS);
        double dx = x - gun.getX(), dy = y - gun.getY(), distance = Math.sqrt(dx * dx + dy * dy);
        boolean heavy = dice.next() < HEAVY;
        if (distance == 0) return;
        shells.add(new Skirmish.Shell(gun.getX(), gun.getY(), x, y, time, time + distance / SHELL_SPEED, heavy));
        gun.aimX = dx / distance;
        gun.aimY = dy / distance;
        gun.lastShot = time;
        gun.applyImpulse(-RECOIL * Tank.MASS * gun.aimX, -RECOIL * Tank.MASS * gun.aimY);
    }

    /** Makes a blast, which throws the tanks around it outwards. */
    void burst(double x, double y, double time) {
        blasts.add(new Skirmish.Blast(x, y, time));
        if (blasts.size() > KEPT_BLASTS) blasts.remove();
        count++;
        for (Tank tank : tanks) {
            double dx = tank.getX() - x, dy = tank.getY() - y;
            double distance = Math.sqrt(dx * dx + dy * dy);
            if (distance >= BLAST_RADIUS || distance == 0) continue;
            double impulse = Tank.MASS * BLAST * (1 - distance / BLAST_RADIUS) / distance;
            tank.applyImpulse(impulse * dx, impulse * dy);
            tank.lastHit = time;
        }
    }

    Iterable<Skirmish.Blast> blasts() {
        return blasts;
    }

    Iterable<Skirmish.Shell> shells() {
        return shells;
    }

    int count() {
        return count;
    }

    long hash(long hash) {
        for (Skirmish.Shell shell : shells) {
            hash = Churn.scramble(hash + Double.doubleToRawLongBits(shell.x()));
            hash = Churn.scramble(hash + Double.doubleToRawLongBits(shell.y()));
            hash = Churn.scramble(hash + Double.doubleToRawLongBits(shell.bursts())) + (shell.heavy() ? 1 : 0);
        }
        for (Tank tank : tanks) hash = Churn.scramble(hash + Double.doubleToRawLongBits(tank.lastHit));
        return hash;
    }
}
