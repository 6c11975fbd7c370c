package yarts.physics.demo;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Point2D;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import yarts.physics.Integrator;

/**
 * Plays a skirmish live. {@code World.advance} gets the real time of each frame, and the tanks are drawn at interpolated
 * positions, which move smoothly at every tick rate.
 */
final class SkirmishWindow {
    private static final Integer[] RATES = {15, 18, 20, 30, 60, 120};
    private static final int FRAME_MILLIS = 15;

    private final Supplier<Skirmish> games;
    private final SkirmishPainter painter = new SkirmishPainter();
    private final JComboBox<Integer> rate = new JComboBox<>(RATES);
    private final JComboBox<Integrator> integrator = new JComboBox<>(Integrator.values());
    private final JCheckBox naive = new JCheckBox("Naive friction");
    private final JToggleButton pause = new JToggleButton("Pause");
    private final JLabel status = new JLabel(" ");
    private final JComponent field = new Field();
    private final Timer timer = new Timer(FRAME_MILLIS, e -> frame());
    private Skirmish game;
    private long last;

    private SkirmishWindow(Supplier<Skirmish> games) {
        this.games = games;
        rate.setSelectedItem(Skirmish.TICKS_PER_SECOND);
        restart();
    }

    /** Opens the window and returns when it is closed. */
    static void show(Supplier<Skirmish> games) throws InterruptedException {
        CountDownLatch closed = new CountDownLatch(1);
        SwingUtilities.invokeLater(() -> new SkirmishWindow(games).open(closed));
        closed.await();
    }

    private void open(CountDownLatch closed) {
        JButton restart = new JButton("Restart");
        restart.addActionListener(e -> restart());
        rate.addActionListener(e -> apply());
        integrator.addActionListener(e -> apply());
        naive.addActionListener(e -> apply());

        JToolBar bar = new JToolBar();
        bar.setFloatable(false);
        bar.add(pause);
        bar.add(restart);
        bar.addSeparator();
        bar.add(new JLabel("Ticks per second "));
        bar.add(rate);
        bar.addSeparator();
        bar.add(new JLabel("Integrator "));
        bar.add(integrator);
        bar.addSeparator();
        bar.add(naive);
        rate.setMaximumSize(rate.getPreferredSize());
        integrator.setMaximumSize(integrator.getPreferredSize());
        status.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));

        JFrame frame = new JFrame("yarts-physics: a skirmish");
        frame.add(bar, BorderLayout.NORTH);
        frame.add(field, BorderLayout.CENTER);
        frame.add(status, BorderLayout.SOUTH);
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent e) {
                timer.stop();
                closed.countDown();
            }
        });
        frame.pack();
        frame.setMinimumSize(new Dimension(680, 560)); // all controls are visible
        frame.setLocationByPlatform(true);
        frame.setVisible(true);
        last = System.nanoTime();
        timer.start();
    }

    private void restart() {
        game = games.get();
        apply();
    }

    /** Applies the settings of the controls. */
    private void apply() {
        game.setIntegrator(integrator.getItemAt(integrator.getSelectedIndex()));
        game.setTicksPerSecond(ticksPerSecond());
        game.setNaive(naive.isSelected());
    }

    private void frame() {
        long now = System.nanoTime();
        if (!pause.isSelected()) game.advance((now - last) / 1e9);
        last = now;
        field.repaint();
        double z = Tank.FRICTION / ticksPerSecond();
        status.setText(String.format(
                Locale.ROOT,
                "z = f dt/m = %.2f: %,d of %,d tanks jitter%s. Click: a blast there.",
                z,
                game.jittering(),
                game.tanks().length,
                naive.isSelected() && z > 1 ? ", as z > 1" : ""));
    }

    private void blastAt(Point2D pixel) {
        try {
            Point2D metres =
                    SkirmishPainter.map(field.getWidth(), field.getHeight()).inverseTransform(pixel, null);
            game.blastAt(metres.getX(), metres.getY());
        } catch (NoninvertibleTransformException e) {
            // a field without an area has no place to hit
        }
    }

    private int ticksPerSecond() {
        return rate.getItemAt(rate.getSelectedIndex());
    }

    /** Swing draws it into a buffer first, so it does not flicker. */
    private final class Field extends JComponent {
        private static final long serialVersionUID = 1;

        Field() {
            setPreferredSize(new Dimension(960, 746));
            setOpaque(true);
            addMouseListener(new MouseAdapter() {
                @Override
                public void mousePressed(MouseEvent e) {
                    blastAt(e.getPoint());
                }
            });
        }

        @Override
        protected void paintComponent(Graphics g) {
            Graphics2D g2 = (Graphics2D) g.create();
            g2.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            painter.paint(g2, getWidth(), getHeight(), game);
            g2.dispose();
        }
    }
}
