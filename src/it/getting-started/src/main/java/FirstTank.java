// tag::program[]
import yarts.physics.Unit;
import yarts.physics.World;

/** A tank drives for six seconds and brakes. */
public class FirstTank {
    public static void main(String[] args) {
        World world = new World(); // EXACT, 60 steps per second
        Unit tank = world.add(new Unit(40_000)); // kg
        tank.setMotor(10, 0, 80_000); // drive at 10 m/s, with 80 kN: 2 m/s²
        for (int second = 1; second <= 9; second++) {
            if (second == 7) tank.setMotor(0, 0, 160_000); // brake: 4 m/s²
            for (int frame = 0; frame < 30; frame++) world.advance(1 / 30.0); // s
            System.out.println(second + " s: " + (float) tank.getX() + " m, " + (float) tank.getSpeed() + " m/s");
        }
    }
}
// end::program[]
