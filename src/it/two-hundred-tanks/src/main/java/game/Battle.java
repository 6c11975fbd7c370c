package game;

// tag::battle[]
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import yarts.physics.Integrator;
import yarts.physics.Unit;
import yarts.physics.World;

/** Tanks that drive to a click, around buildings, and come to rest in a round crowd. */
final class Battle {
    static final double MASS = 40_000; // kg
    static final double ENGINE = 4, BRAKES = 8; // m/s²
    static final double TOP = 10, FLUNG = 20; // m/s: the top speed with the engine, and under a push or a blast
    static final double APART = 4, NEAR = 60; // m: closer tanks push each other; tanks with closer clicks swap places
    static final double STIFFNESS = 20, STRONGEST = 8; // per kilogram: the push per metre of overlap, and its limit
    static final double WALL = APART / 2, CORNER = WALL + 1; // m: the distance of tanks from walls, and from corners
    static final double SPACING = 0.65 * APART; // m: with 0.65, two places in a crowd are never closer than APART
    static final double GOLDEN = 2.399963229728653; // radians: the golden angle
    static final int CELLS = 128; // the grid has CELLS × CELLS cells of APART × APART
    private static final int[] AROUND = {-CELLS - 1, -CELLS, 1 - CELLS, -1, 0, 1, CELLS - 1, CELLS, CELLS + 1};

    /** A tank brakes until it has an order. */
    static final class Tank extends Unit {
        private List<Stop> order; // the click, then the corners of the buildings
        private Stop place; // in the crowd around the click
        private double pushX, pushY; // m/s²: the sum of the pushes of all neighbours in this step
        private Tank next; // the next tank in the same cell of the grid

        private Tank(double x, double y) {
            super(MASS);
            setPosition(x, y).setMaxSpeed(FLUNG);
            place = new Stop(x, y, 0);
        }
    }

    private record Stop(double x, double y, double left) {} // a point, and the length of its way to the click

    private record Building(double x, double y, double halfWidth, double halfHeight) {
        boolean blocks(double fromX, double fromY, Stop to, double margin) {
            double w = halfWidth + margin, h = halfHeight + margin, ex = (to.x - fromX) / 2, ey = (to.y - fromY) / 2;
            double dx = fromX + ex - x, dy = fromY + ey - y, lx = Math.abs(ex), ly = Math.abs(ey);
            return Math.abs(dx) < w + lx && Math.abs(dy) < h + ly && Math.abs(ex * dy - ey * dx) <= w * ly + h * lx;
        }
    }

    final List<Tank> tanks = new ArrayList<>();
    private final World world;
    private final double lag; // of the integrator
    private final List<Building> buildings = new ArrayList<>();
    private final Tank[] grid = new Tank[CELLS * CELLS]; // the first tank of each cell

    Battle(World world) {
        this.world = world;
        Integrator integrator = world.getIntegrator();
        lag = integrator == Integrator.EULER ? 1 : integrator == Integrator.SEMI_IMPLICIT ? 0 : 0.5;
        world.addBeforeStep((w, dt) -> steer(dt));
        world.addAfterStep((w, dt) -> tanks.forEach(this::keepOut));
    }

    void addBuilding(double x, double y, double width, double height) {
        buildings.add(new Building(x, y, width / 2, height / 2));
    }

    void addTank(double x, double y) {
        tanks.add(world.add(new Tank(x, y)));
    }

    /** A click: finds the ways around the buildings, and gives each tank a place on a spiral around the click. */
    void order(List<Tank> selected, double x, double y) {
        Unit click = new Unit(MASS).setPosition(x, y);
        keepOut(click);
        List<Stop> stops = new ArrayList<>(List.of(new Stop(click.getX(), click.getY(), 0)));
        for (int i = 0; i < 4 * buildings.size(); i++) {
            Building b = buildings.get(i / 4);
            double dx = b.halfWidth + CORNER, dy = b.halfHeight + CORNER;
            stops.add(new Stop(b.x + (i % 4 < 2 ? dx : -dx), b.y + (i % 2 < 1 ? dy : -dy), Double.POSITIVE_INFINITY));
        }
        for (int n = stops.size(), i = 0; i < n * n; i++) {
            Stop to = stops.get(i % n);
            stops.replaceAll(from -> {
                double left = to.left + length(to.x - from.x, to.y - from.y);
                return left < from.left && isClear(from.x, from.y, to) ? new Stop(from.x, from.y, left) : from;
            });
        }
        int i = 0;
        for (Tank tank : selected) tank.order = stops;
        for (Tank tank : selected) {
            do {
                double r = SPACING * Math.sqrt(selected.size() > 1 ? i + 0.5 : i), angle = GOLDEN * i++;
                double dx = r * StrictMath.cos(angle), dy = r * StrictMath.sin(angle);
                tank.place = new Stop(click.getX() + dx, click.getY() + dy, r);
            } while (!isFree(tank) && i < 100_000);
        }
    }

    /** Whether a place is in sight of the click, not in the lane along a wall, and not too close to another order's. */
    private boolean isFree(Tank tank) {
        double x = tank.place.x, y = tank.place.y;
        for (Building b : buildings) if (b.blocks(x, y, tank.place, CORNER + APART)) return false;
        for (Tank other : tanks) {
            if (other.order != tank.order && length(other.place.x - x, other.place.y - y) < APART) return false;
        }
        return isClear(x, y, tank.order.get(0));
    }

    /** Throws tanks away from a point: by this speed in m/s at the point, decreasing to 0 at the radius. */
    void blast(double x, double y, double radius, double speed) {
        for (Tank tank : tanks) {
            double dx = tank.getX() - x, dy = tank.getY() - y, distance = length(dx, dy);
            double impulse = MASS * speed * Math.max(0, 1 - distance / radius) / Math.max(distance, 1e-10);
            tank.applyImpulse(impulse * dx, impulse * dy);
        }
    }

    private void steer(double dt) {
        Arrays.fill(grid, null);
        for (Tank tank : tanks) {
            int cell = CELLS * cell(tank.getY()) + cell(tank.getX());
            for (int step : AROUND)
                for (Tank near = grid[cell + step]; near != null; near = near.next) meet(tank, near);
            tank.next = grid[cell];
            grid[cell] = tank;
        }
        for (Tank tank : tanks) {
            double push = length(tank.pushX, tank.pushY), force = MASS * Math.min(push, STRONGEST);
            if (push > 0) tank.applyForce(force * tank.pushX / push, force * tank.pushY / push);
            tank.pushX = tank.pushY = 0;
            drive(tank, dt);
        }
    }

    private static int cell(double v) {
        return (int) Math.max(1, Math.min(CELLS - 2, CELLS / 2 + v / APART));
    }

    /** Pushes two tanks apart. They swap their places if this makes their ways shorter. */
    private static void meet(Tank a, Tank b) {
        double dx = a.getX() - b.getX(), dy = a.getY() - b.getY();
        if (dx == 0 && dy == 0) { // at the same point: a different direction for each tank
            dx = 1e-9 * StrictMath.cos(GOLDEN * a.getIndex());
            dy = 1e-9 * StrictMath.sin(GOLDEN * a.getIndex());
        }
        double distance = length(dx, dy), push = STIFFNESS * (APART / distance - 1);
        if (distance >= APART) return;
        a.pushX += push * dx;
        a.pushY += push * dy;
        b.pushX -= push * dx;
        b.pushY -= push * dy;
        Stop place = a.place;
        List<Stop> order = a.order;
        if (order == null || b.order == null || dx * (place.x - b.place.x) + dy * (place.y - b.place.y) >= 0) return;
        if (length(order.get(0).x - b.order.get(0).x, order.get(0).y - b.order.get(0).y) >= NEAR) return;
        a.place = b.place;
        a.order = b.order;
        b.place = place;
        b.order = order;
    }

    /** Arrival with brakes. If a building is in the way, the tank drives to the stop with the shortest way. */
    private void drive(Tank tank, double dt) {
        double vx = tank.getVx(), vy = tank.getVy(), x = tank.getX() + lag * dt * vx, y = tank.getY() + lag * dt * vy;
        Stop place = tank.place, aim = place;
        double left = length(place.x - x, place.y - y), least = Double.POSITIVE_INFINITY, u = 0;
        if (tank.order != null && left > 1e-10) { // m; closer than that, it stops
            if (!isClear(x, y, place)) {
                for (Stop stop : tank.order) {
                    double way = length(stop.x - x, stop.y - y), rest = length(place.x - stop.x, place.y - stop.y);
                    way += isClear(stop.x, stop.y, place) ? rest : stop.left + place.left;
                    if (way >= least || !isClear(x, y, stop)) continue;
                    least = left = way;
                    aim = stop;
                }
            }
            double n = Math.max(1, Math.ceil((Math.sqrt(1 + 8 * left / (BRAKES * dt * dt)) - 1) / 2 - 1e-12));
            u = Math.min(2 * left / ((1 + n) * dt), TOP);
        }
        double away = Math.max(1e-10, length(aim.x - x, aim.y - y));
        double force = MASS * (u == 0 || u < tank.getSpeed() ? BRAKES : ENGINE);
        tank.setMotor(u * (aim.x - x) / away, u * (aim.y - y) / away, force);
    }

    private boolean isClear(double x, double y, Stop to) {
        for (Building b : buildings) if (b.blocks(x, y, to, WALL - 0.1)) return false;
        return true;
    }

    /** Moves a unit out of a building to the nearest wall. The unit keeps its velocity along the wall. */
    private void keepOut(Unit unit) {
        for (Building b : buildings) {
            double x = unit.getX(), y = unit.getY(), vx = unit.getVx(), vy = unit.getVy(), dx = x - b.x, dy = y - b.y;
            double inX = b.halfWidth + WALL - Math.abs(dx), inY = b.halfHeight + WALL - Math.abs(dy);
            if (inX <= 0 || inY <= 0) continue;
            if (inX < inY) unit.moveTo(x + Math.copySign(inX, dx), y).setVelocity(vx * dx < 0 ? 0 : vx, vy);
            else unit.moveTo(x, y + Math.copySign(inY, dy)).setVelocity(vx, vy * dy < 0 ? 0 : vy);
        }
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }
}
// end::battle[]
