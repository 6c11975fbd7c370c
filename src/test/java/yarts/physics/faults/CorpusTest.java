package yarts.physics.faults;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import yarts.physics.snapshot.SnapshotFuzz;
import yarts.physics.world.WorldFuzz;

/** Repeats the inputs of a fuzzer that led to new paths through the library, or that failed once. */
class CorpusTest {
    private static final Path CORPUS = Path.of("src/test/resources/fuzz");

    @TestFactory
    Stream<DynamicTest> snapshots() throws IOException {
        return replay("snapshot.SnapshotFuzz", SnapshotFuzz::fuzzerTestOneInput);
    }

    @TestFactory
    Stream<DynamicTest> worlds() throws IOException {
        return replay("world.WorldFuzz", WorldFuzz::fuzzerTestOneInput);
    }

    private static Stream<DynamicTest> replay(String target, Consumer<byte[]> call) throws IOException {
        try (Stream<Path> files = Files.list(CORPUS.resolve(target))) {
            var tests = files.sorted()
                    .map(file -> DynamicTest.dynamicTest(
                            target + " " + file.getFileName(), () -> call.accept(Files.readAllBytes(file))))
                    .toList();
            assertTrue(tests.size() >= 20, "a corpus of only " + tests.size());
            return tests.stream();
        }
    }
}
