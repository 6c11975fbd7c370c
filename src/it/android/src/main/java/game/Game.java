package game;

import com.android.tools.r8.CompilationFailedException;
import com.android.tools.r8.CompilationMode;
import com.android.tools.r8.D8;
import com.android.tools.r8.D8Command;
import com.android.tools.r8.Diagnostic;
import com.android.tools.r8.DiagnosticsHandler;
import com.android.tools.r8.JdkClassFileProvider;
import com.android.tools.r8.OutputMode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarFile;
import yarts.physics.Unit;

/** A part of an Android build: D8 translates the jar of the library, without a warning. */
public final class Game {
    private static final int API = 24; // Android 7
    private static final int CLASSES = 0x60; // where the header of a dex file has the number of classes

    private Game() {}

    public static void main(String[] args) throws Exception {
        Path jar = Path.of(
                Unit.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        Path dex = Files.createTempDirectory("dex");
        Complaints complaints = new Complaints();
        compile(jar, dex, complaints);
        require(complaints.messages.isEmpty(), "D8 complains of nothing: " + complaints.messages);

        ByteBuffer code =
                ByteBuffer.wrap(Files.readAllBytes(dex.resolve("classes.dex"))).order(ByteOrder.LITTLE_ENDIAN);
        int classes = code.getInt(CLASSES);
        try (JarFile library = new JarFile(jar.toFile())) {
            long expected = library.stream()
                    .filter(entry -> entry.getName().matches("yarts/.*(?<!package-info)\\.class"))
                    .count();
            require(classes >= expected, "all classes are there: " + classes + ", of " + expected);
        }
        System.out.println("android: D8 made " + classes + " classes, " + code.capacity() + " bytes, for API " + API);
    }

    private static void compile(Path jar, Path dex, DiagnosticsHandler handler) throws Exception {
        try {
            D8.run(D8Command.builder(handler)
                    .addProgramFiles(jar)
                    .addLibraryResourceProvider(JdkClassFileProvider.fromSystemJdk())
                    .setMinApiLevel(API)
                    .setMode(CompilationMode.RELEASE)
                    .setOutput(dex, OutputMode.DexIndexed)
                    .build());
        } catch (CompilationFailedException e) {
            throw new AssertionError("D8 takes the jar", e);
        }
    }

    private static void require(boolean holds, String claim) {
        if (!holds) throw new AssertionError(claim);
    }

    /** Collects the messages of D8. */
    private static final class Complaints implements DiagnosticsHandler {
        final List<String> messages = new ArrayList<>();

        @Override
        public void error(Diagnostic diagnostic) {
            messages.add(diagnostic.getDiagnosticMessage());
        }

        @Override
        public void warning(Diagnostic diagnostic) {
            messages.add(diagnostic.getDiagnosticMessage());
        }
    }
}
