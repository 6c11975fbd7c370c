package yarts.physics.metamorphic;

import yarts.physics.Unit;

/**
 * A way to look at a game from elsewhere: axes swapped, mirrored, in other units of length, mass and time. The measures
 * are powers of two, with which doubles are multiplied without error; so what is seen must be the same to the bit.
 */
record View(boolean swapped, int signX, int signY, double length, double mass, double time) {
    static final View SAME = new View(false, 1, 1, 1, 1, 1);

    double speed() {
        return length / time;
    }

    double impulse() {
        return mass * speed();
    }

    double force() {
        return impulse() / time;
    }

    double friction() {
        return mass / time;
    }

    /** The x component here of a vector (x, y) there. */
    double x(double x, double y, double measure) {
        return (swapped ? y : x) * signX * measure;
    }

    double y(double x, double y, double measure) {
        return (swapped ? x : y) * signY * measure;
    }

    /** All that is known of a unit here as the bits that it has there. */
    long[] see(Unit unit) {
        double[][] vectors = {
            {unit.getX(), unit.getY(), length},
            {unit.getVx(), unit.getVy(), speed()},
            {unit.getFx(), unit.getFy(), force()},
            {unit.getMotorVx(), unit.getMotorVy(), speed()},
            {unit.getPendingImpulseX(), unit.getPendingImpulseY(), impulse()},
            {unit.getInterpolatedX(0), unit.getInterpolatedY(0), length},
            {unit.getInterpolatedX(), unit.getInterpolatedY(), length}
        };
        long[] bits = new long[2 * vectors.length + 1];
        for (int i = 0; i < vectors.length; i++) {
            double x = vectors[i][0] * signX / vectors[i][2], y = vectors[i][1] * signY / vectors[i][2];
            bits[2 * i] = bits(swapped ? y : x);
            bits[2 * i + 1] = bits(swapped ? x : y);
        }
        bits[bits.length - 1] = bits(unit.getSpeed() / speed());
        return bits;
    }

    /** A mirror makes −0.0 of 0.0. What is on its way to rest has no scale: it gets there by a speed of the library's own. */
    private static long bits(double v) {
        return Math.abs(v) < 0x1p-400 ? 0 : Double.doubleToRawLongBits(v);
    }
}
