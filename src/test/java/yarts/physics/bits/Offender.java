package yarts.physics.bits;

import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.DoubleAdder;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import yarts.physics.bits.BytecodeTest.Rule;

/** Methods that break each rule of {@link BytecodeTest} in several ways, and at the end methods that break none. */
@SuppressWarnings("unused")
final class Offender {
    /** The only rule that a method breaks. */
    @Retention(RetentionPolicy.RUNTIME)
    @interface Breaks {
        Rule value();
    }

    private final Map<Long, String> map = new HashMap<>();
    private final HashSet<Long> set = new HashSet<>();
    private final List<Double> list = new ArrayList<>();
    private double state;

    @Breaks(Rule.FLOAT)
    private float height;

    @Breaks(Rule.MATH)
    double sine(double v) {
        return Math.sin(v);
    }

    @Breaks(Rule.MATH)
    double fused(double v) {
        return Math.fma(v, v, v);
    }

    @Breaks(Rule.MATH)
    long rounded(double v) {
        return Math.round(v);
    }

    @Breaks(Rule.MATH)
    float largerFloat(float v) {
        return Math.max(v, 1);
    }

    @Breaks(Rule.MATH)
    double chance() {
        return Math.random();
    }

    @Breaks(Rule.MATH)
    DoubleUnaryOperator sineByReference() {
        return Math::sin;
    }

    @Breaks(Rule.STRICT_MATH)
    double strictPower(double v) {
        return StrictMath.pow(v, 2);
    }

    @Breaks(Rule.STRICT_MATH)
    double strictExponential(double v) {
        return StrictMath.exp(v);
    }

    @Breaks(Rule.STRICT_MATH)
    double strictRoot(double v) {
        return StrictMath.sqrt(v);
    }

    @Breaks(Rule.STRICT_MATH)
    DoubleUnaryOperator strictByReference() {
        return StrictMath::expm1;
    }

    @Breaks(Rule.FLOAT)
    float floatProduct(float v) {
        return v * v;
    }

    @Breaks(Rule.FLOAT)
    float floatSum(float v) {
        return v + 1;
    }

    @Breaks(Rule.FLOAT)
    float floatDifference(float v) {
        return 1 - v;
    }

    @Breaks(Rule.FLOAT)
    float floatQuotient(float v) {
        return 1 / v;
    }

    @Breaks(Rule.FLOAT)
    float floatRemainder(float v) {
        return v % 3;
    }

    @Breaks(Rule.FLOAT)
    float floatOpposite(float v) {
        return -v;
    }

    @Breaks(Rule.FLOAT)
    boolean floatComparison(float v) {
        return v < 1;
    }

    @Breaks(Rule.FLOAT)
    void floatIntoState(float v) {
        state = v;
    }

    @Breaks(Rule.FLOAT)
    float floatOfCount(int n) {
        return n;
    }

    @Breaks(Rule.HASH_ORDER)
    long valuesOfMap() {
        long sum = 0;
        for (String s : map.values()) sum = sum * 31 + s.length();
        return sum;
    }

    @Breaks(Rule.HASH_ORDER)
    Iterator<Long> iteratorOfSet() {
        return set.iterator();
    }

    @Breaks(Rule.HASH_ORDER)
    Object[] arrayOfKeys() {
        return ((Set<?>) set).toArray();
    }

    @Breaks(Rule.HASH_ORDER)
    void eachOfMap() {
        map.forEach((k, v) -> list.add(state));
    }

    @Breaks(Rule.HASH_ORDER)
    Object entriesByIdentity() {
        return new IdentityHashMap<Object, Object>().entrySet();
    }

    @Breaks(Rule.HASH_ORDER)
    Set<Integer> saltedOrder() {
        return Set.of(1, 2, 3);
    }

    @Breaks(Rule.HASH_ORDER)
    Object copyOfMap() {
        Map<Long, String> copy = new HashMap<>();
        copy.putAll(map);
        return copy;
    }

    @Breaks(Rule.SYSTEM)
    long nanoTime() {
        return System.nanoTime();
    }

    @Breaks(Rule.SYSTEM)
    long wallClock() {
        return System.currentTimeMillis();
    }

    @Breaks(Rule.SYSTEM)
    Instant instant() {
        return Instant.now();
    }

    @Breaks(Rule.SYSTEM)
    void sleep() throws InterruptedException {
        Thread.sleep(1);
    }

    @Breaks(Rule.SYSTEM)
    String setting() {
        return System.getProperty("dt");
    }

    @Breaks(Rule.RANDOM)
    double random() {
        return new Random().nextDouble();
    }

    @Breaks(Rule.RANDOM)
    double randomOfThread() {
        return ThreadLocalRandom.current().nextDouble();
    }

    @Breaks(Rule.RANDOM)
    double randomSplit() {
        return new SplittableRandom(1).nextDouble();
    }

    @Breaks(Rule.IDENTITY)
    int identity(Object o) {
        return System.identityHashCode(o);
    }

    @Breaks(Rule.IDENTITY)
    int hashOfObject(Object o) {
        return o.hashCode();
    }

    @Breaks(Rule.IDENTITY)
    int hashOfObjects(Object o) {
        return Objects.hash(o, state);
    }

    @Breaks(Rule.REDUCTION)
    double sumOfStream(double[] v) {
        return DoubleStream.of(v).sum();
    }

    @Breaks(Rule.REDUCTION)
    IntStream parallel() {
        return IntStream.range(0, 9).parallel();
    }

    @Breaks(Rule.REDUCTION)
    Object parallelOfList() {
        return list.parallelStream();
    }

    @Breaks(Rule.REDUCTION)
    void prefix(double[] v) {
        Arrays.parallelPrefix(v, Double::sum);
    }

    @Breaks(Rule.REDUCTION)
    double adder() {
        return new DoubleAdder().sum();
    }

    double allowedMath(double v) {
        return Math.sqrt(Math.abs(v)) + Math.min(v, 1) + Math.max(v, 2);
    }

    long allowedIntegers(int n, long m) {
        return Math.toIntExact(m) + Math.floorMod(n, 3) + Math.addExact(m, 1L) + Math.abs(n) + Math.max(m, n);
    }

    void allowedFloats(float[] xy, double v) {
        xy[0] = (float) v;
        xy[1] = xy[0];
    }

    String allowedLookUps(long id) {
        map.put(id, "unit");
        if (set.add(id) || map.containsKey(id) || set.contains(id)) map.remove(id);
        return map.get(id);
    }

    double allowedLists(double[] from, double[] to) {
        System.arraycopy(from, 0, to, 0, 1);
        double sum = 0;
        for (double v : list) sum += v;
        return sum;
    }
}
