package yarts.physics.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.ConcurrentModificationException;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.ListIterator;
import java.util.NoSuchElementException;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import yarts.physics.Snapshot;
import yarts.physics.Unit;
import yarts.physics.World;

/** An iterator detects every change of its world except its own remove, in the next call of hasNext or next. */
class IteratorTest {
    private static final int MOST = 6;

    /** All iterators over the units of a world. Those that run backwards begin at the end. */
    enum Kind {
        WORLD(World::iterator),
        UNITS(world -> world.units().iterator()),
        LIST_ITERATOR(world -> world.units().listIterator()),
        LIST_ITERATOR_FROM_AN_INDEX(world -> world.units().listIterator(0)),
        LIST_ITERATOR_BACKWARDS(world -> backwards(world.units())),
        SUBLIST(world -> sublist(world).iterator()),
        SUBLIST_LIST_ITERATOR(world -> sublist(world).listIterator()),
        SUBLIST_BACKWARDS(world -> backwards(sublist(world))),
        SUBLIST_OF_A_SUBLIST(world ->
                sublist(world).subList(0, world.size()).subList(0, world.size()).iterator());

        private final Function<World, Iterator<Unit>> maker;

        Kind(Function<World, Iterator<Unit>> maker) {
            this.maker = maker;
        }

        Iterator<Unit> over(World world) {
            return maker.apply(world);
        }
    }

    private static List<Unit> sublist(World world) {
        return world.units().subList(0, world.size());
    }

    private static Iterator<Unit> backwards(List<Unit> list) {
        ListIterator<Unit> iterator = list.listIterator(list.size());
        return new Iterator<>() {
            @Override
            public boolean hasNext() {
                return iterator.hasPrevious();
            }

            @Override
            public Unit next() {
                return iterator.previous();
            }
        };
    }

    private static World world(int units) {
        World world = new World();
        for (int i = 0; i < units; i++) world.add(new Unit(1));
        return world;
    }

    private static void fails(Executable call) {
        String message =
                assertThrows(ConcurrentModificationException.class, call).getMessage();
        assertTrue(message != null && message.length() > 20, "the message says why: " + message);
    }

    /** For each position of the iterator and several numbers of units. */
    private static void failsAfter(Kind kind, Consumer<World> change) {
        for (int units = 1; units <= MOST; units++) {
            for (int visited = 0; visited <= units; visited++) {
                World world = world(units);
                Iterator<Unit> iterator = kind.over(world);
                for (int i = 0; i < visited; i++) iterator.next();
                assertEquals(visited < units, iterator.hasNext());
                change.accept(world);
                fails(iterator::hasNext);
                fails(iterator::next);
                fails(iterator::hasNext);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void anIteratorFailsAfterTheRemovalOfAnyUnit(Kind kind) {
        for (int leaver = 0; leaver < MOST; leaver++) {
            int index = leaver;
            failsAfter(kind, world -> world.remove(world.get(index % world.size())));
        }
    }

    @ParameterizedTest
    @EnumSource
    void anIteratorFailsAfterAnyOtherChange(Kind kind) {
        World empty = new World(), many = world(3);
        Snapshot none = empty.save(), three = many.save();
        for (Consumer<World> change : List.<Consumer<World>>of(
                world -> world.add(new Unit(1)),
                World::clear,
                world -> world.removeIf(unit -> unit.getIndex() == 0),
                world -> world.removeIf(unit -> true),
                world -> {
                    Unit first = world.get(0);
                    world.remove(first);
                    world.add(first);
                },
                world -> world.add(world.remove(world.get(0)) ? new Unit(1) : null),
                world -> world.restore(none),
                world -> {
                    world.restore(none);
                    world.restore(three);
                },
                world -> {
                    Iterator<Unit> another = world.iterator();
                    another.next();
                    another.remove();
                },
                world -> {
                    world.addBeforeStep((w, dt) -> w.remove(w.get(0)));
                    world.step();
                },
                world -> {
                    world.addAfterStep((w, dt) -> w.add(new Unit(1)));
                    world.advance(0.02);
                })) {
            failsAfter(kind, change);
        }
    }

    /** Also if the last unit but one is removed, which a comparison of index and size does not detect. */
    @Test
    void aLoopThatRemovesUnitsThroughTheWorldFails() {
        for (int units = 1; units <= MOST; units++) {
            for (int least = 1; least <= units; least++) {
                World world = world(units);
                int from = least;
                fails(() -> {
                    for (Unit unit : world) if (unit.getId() >= from) world.remove(unit);
                });
                World growing = world(units);
                fails(() -> {
                    for (Unit unit : growing) if (unit.getId() >= from) growing.add(new Unit(1));
                });
            }
        }
    }

    @Test
    void forEachFailsAfterAChangeByItsAction() {
        for (int units = 1; units <= MOST; units++) {
            World world = world(units);
            fails(() -> world.forEach(unit -> world.add(new Unit(1))));
            fails(() -> world.units().forEach(world::remove));
            fails(() -> world.units().listIterator().forEachRemaining(unit -> world.add(new Unit(1))));
            fails(() -> world.iterator().forEachRemaining(world::remove));
        }
    }

    @Test
    void aStreamFailsAfterAChange() {
        for (int units = 1; units <= MOST; units++) {
            World world = world(units);
            assertThrows(
                    ConcurrentModificationException.class,
                    () -> world.units().stream().forEach(unit -> world.add(new Unit(1))));
            assertThrows(
                    ConcurrentModificationException.class,
                    () -> world.units().stream().forEach(world::remove));
        }
    }

    /** A sublist that was created before the change. */
    @Test
    void aSublistFailsAfterAChange() {
        for (int leaver = 0; leaver < 4; leaver++) {
            World world = world(4);
            List<Unit> all = sublist(world), some = world.units().subList(1, 3), nested = all.subList(1, 3);
            world.remove(world.get(leaver));
            for (List<Unit> list : List.of(all, some, nested)) {
                for (Executable call : List.<Executable>of(
                        list::size, () -> list.get(0), list::iterator, () -> list.listIterator(1))) {
                    assertThrows(ConcurrentModificationException.class, call);
                }
                fails(list::size);
            }
            assertEquals(3, world.units().size());
            assertEquals(3, sublist(world).size(), "a new sublist has the new units");
        }
    }

    @ParameterizedTest
    @EnumSource
    void anIteratorVisitsAllUnitsInOrder(Kind kind) {
        for (int units = 0; units <= MOST; units++) {
            World world = world(units);
            List<Unit> visited = new ArrayList<>();
            Iterator<Unit> iterator = kind.over(world);
            while (iterator.hasNext()) visited.add(iterator.next());
            if (kind.name().endsWith("BACKWARDS")) Collections.reverse(visited);
            assertEquals(world.units(), visited);
            assertFalse(iterator.hasNext());
            assertThrows(NoSuchElementException.class, iterator::next);
        }
    }

    /** Steps, setters of units and saves do not change the list. */
    @ParameterizedTest
    @EnumSource
    void anIteratorContinuesAfterCallsThatDoNotChangeTheList(Kind kind) {
        World world = world(8);
        Snapshot saved = world.save();
        Set<Unit> visited = new HashSet<>();
        Iterator<Unit> iterator = kind.over(world);
        for (Runnable call : List.<Runnable>of(
                world::step,
                () -> world.advance(0.1),
                () -> world.get(3).setPosition(1, 2).setVelocity(3, 4).setMass(5),
                () -> world.get(3).setFrozen(true),
                () -> world.find(world.get(5).getId()).applyForce(1, 2),
                () -> world.save(saved),
                world::stateHash,
                () -> assertFalse(world.remove(new Unit(1)) || world.removeIf(unit -> false)))) {
            call.run();
            assertTrue(iterator.hasNext());
            visited.add(iterator.next());
        }
        assertFalse(iterator.hasNext());
        assertEquals(8, visited.size());
    }

    /** Removes each subset of six units. */
    @Test
    void onlyOtherIteratorsFailAfterTheRemoveOfAnIterator() {
        for (int leavers = 0; leavers < 1 << MOST; leavers++) {
            World world = world(MOST);
            List<Unit> before = List.copyOf(world.units());
            List<Unit> visited = new ArrayList<>(), expected = new ArrayList<>();
            Iterator<Unit> iterator = world.iterator();
            while (iterator.hasNext()) {
                Unit unit = iterator.next();
                visited.add(unit);
                boolean leaves = (leavers >> before.indexOf(unit) & 1) == 1;
                if (!leaves) {
                    expected.add(unit);
                    continue;
                }
                Iterator<Unit> other = world.iterator();
                iterator.remove();
                fails(other::hasNext);
                fails(other::next);
                assertFalse(world.contains(unit));
                assertThrows(IllegalStateException.class, iterator::remove);
            }
            assertEquals(MOST, visited.size());
            assertEquals(Set.copyOf(before), new HashSet<>(visited), "each unit once");
            assertEquals(Set.copyOf(expected), Set.copyOf(world.units()));
            for (int i = 0; i < world.size(); i++) assertEquals(i, world.get(i).getIndex());
            assertThrows(NoSuchElementException.class, iterator::next);
        }
    }

    @Test
    void removeFailsWithoutACurrentUnitAndAfterAnotherChange() {
        World world = world(4);
        Iterator<Unit> iterator = world.iterator();
        assertThrows(IllegalStateException.class, iterator::remove);
        Unit first = iterator.next();
        world.add(new Unit(1));
        fails(iterator::remove);
        assertTrue(world.contains(first));
        assertEquals(5, world.size());
        Iterator<Unit> again = world.iterator();
        again.next();
        world.remove(first);
        fails(again::remove);
        assertEquals(4, world.size());
    }

    /** The list of units is a view that cannot be modified, and so are its parts. */
    @Test
    void theIteratorsOfTheListCannotRemove() {
        World world = world(4);
        for (Kind kind : Kind.values()) {
            if (kind == Kind.WORLD) continue;
            Iterator<Unit> iterator = kind.over(world);
            iterator.next();
            assertThrows(UnsupportedOperationException.class, iterator::remove);
        }
        ListIterator<Unit> units = world.units().listIterator();
        units.next();
        assertThrows(UnsupportedOperationException.class, () -> units.add(new Unit(1)));
        assertThrows(UnsupportedOperationException.class, () -> units.set(new Unit(1)));
        assertThrows(UnsupportedOperationException.class, () -> sublist(world).clear());
        assertEquals(4, world.size());
    }

    @Test
    void aListIteratorFailsInBothDirections() {
        for (int start = 0; start <= 4; start++) {
            World world = world(4);
            ListIterator<Unit> all = world.units().listIterator(start);
            ListIterator<Unit> part = sublist(world).listIterator(start);
            world.remove(world.get(2));
            for (ListIterator<Unit> units : List.of(all, part)) {
                fails(units::hasNext);
                fails(units::next);
                fails(units::hasPrevious);
                fails(units::previous);
            }
        }
    }

    @Test
    void listsOfUnitsHaveIndicesAndCannotBeModified() {
        World world = new World();
        for (int i = 0; i < 5; i++) world.add(new Unit(1));
        List<Unit> middle = world.units().subList(1, 4);
        for (int i = 0; i < 3; i++) assertSame(world.get(i + 1), middle.get(i));
        assertSame(world.get(2), middle.subList(1, 3).get(0));
        assertEquals(3, world.units().lastIndexOf(world.get(3)));
        assertEquals(-1, world.units().lastIndexOf(new Unit(1)));
        ListIterator<Unit> units = middle.listIterator(1);
        assertEquals(1, units.nextIndex());
        assertEquals(0, units.previousIndex());
        units.next();
        assertEquals(2, units.nextIndex());
        assertEquals(1, units.previousIndex());
        ListIterator<Unit> old = new World().units().listIterator();
        assertEquals(-1, old.previousIndex());
        for (Executable wrong : List.<Executable>of(
                () -> middle.get(3),
                () -> middle.get(-1),
                () -> middle.subList(2, 4),
                () -> middle.subList(-1, 2),
                () -> middle.listIterator(4),
                () -> world.units().listIterator(6))) {
            assertThrows(IndexOutOfBoundsException.class, wrong);
        }
        ListIterator<Unit> own = (ListIterator<Unit>) world.iterator();
        own.next();
        assertThrows(UnsupportedOperationException.class, () -> own.set(new Unit(1)));
        assertThrows(UnsupportedOperationException.class, () -> own.add(new Unit(1)));
        assertThrows(UnsupportedOperationException.class, () -> middle.remove(0));
        assertEquals(5, world.size());
        world.remove(world.get(0));
        fails(units::nextIndex);
        fails(units::previousIndex);
    }
}
