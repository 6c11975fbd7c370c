package yarts.physics.metamorphic;

import yarts.physics.Unit;

/**
 * A transformation of a game: swapped axes, mirrors, other measures of length, mass and time. The measures are powers
 * of two, by which doubles are multiplied without error; so the transformed values must be the same to the bit.
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

    /** The x component in this view of a vector (x, y). */
    double x(double x, double y, double measure) {
        return (swapped ? y : x) * signX * measure;
    }

    double y(double x, double y, double measure) {
        return (swapped ? x : y) * signY * measure;
    }

    /** All values of a unit in this view, as the bits that they have without it. */
    long[] bits(Unit unit) {
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

    /**
     * A mirror turns 0.0 into −0.0. A velocity below rest does not scale: the threshold is the same in all measures.
     */
    private static long bits(double v) {
        return Math.abs(v) < 0x1p-400 ? 0 : Double.doubleToRawLongBits(v);
    }
}
