package game;

import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.utils.ScreenUtils;
import yarts.physics.Unit;
import yarts.physics.World;

/** The game in docs/engines.md. */
// tag::battle[]
public class Battle extends ApplicationAdapter {
    private SpriteBatch batch;
    private Texture picture;

    private final World world = new World(); // EXACT, 60 steps per second
    private final Unit tank = world.add(new Unit(40_000)); // kg

    @Override
    public void render() {
        double speed = Gdx.input.isKeyPressed(Input.Keys.RIGHT) ? 10 : 0; // m/s
        tank.setMotor(speed, 0, 80_000); // drives at this speed, or brakes, with an engine of 80 kN
        world.advance(Gdx.graphics.getDeltaTime()); // 60 steps per second at any frame rate
        draw((float) tank.getInterpolatedX(), (float) tank.getInterpolatedY());
    }

    @Override
    public void create() {
        batch = new SpriteBatch();
        picture = new Texture("tank.png");
    }

    protected void draw(float x, float y) {
        ScreenUtils.clear(Color.BLACK);
        batch.begin();
        batch.draw(picture, x, y);
        batch.end();
    }
}
// end::battle[]
