package yarts.physics.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.openqa.selenium.chrome.ChromeDriver;

/** The library, compiled by TeaVM to JavaScript and WebAssembly, computes the same bits as on this JVM. */
@Tag("long")
class GoldenTest {
    private static final Path FOLDER = Path.of(System.getProperty("golden")).normalize();
    /** The first version of node whose WebAssembly has garbage collection. */
    private static final int NODE_WITH_GC = 22;

    private static String expected;

    @BeforeAll
    static void playHere() {
        expected = Golden.text();
        System.out.println(expected);
    }

    @Test
    void javaScriptInNode() throws Exception {
        assertEquals(expected, Programs.node("-e", "require(process.argv[1]).main([])", file("golden.js")));
    }

    @Test
    void webAssemblyInNode() throws Exception {
        String version = Programs.node("-p", "process.versions.node");
        boolean gc = Integer.parseInt(version.split("\\.")[0]) >= NODE_WITH_GC;
        if (!gc) System.out.println("node " + version + " has no WebAssembly with garbage collection: skipped");
        assumeTrue(gc, "node " + version);
        String load = "require(process.argv[1]); TeaVM.wasmGC.load(process.argv[2]).then(t => t.exports.main([]))";
        assertEquals(expected, Programs.node("-e", load, file("golden.wasm-runtime.js"), file("golden.wasm")));
    }

    private static String file(String name) {
        return FOLDER.resolve(name).toString();
    }

    @Test
    void javaScriptInChromium() throws Exception {
        assertEquals(expected, inChromium("<script src=golden.js></script><script>main([], done)</script>"));
    }

    @Test
    void webAssemblyInChromium() throws Exception {
        String load = "TeaVM.wasmGC.load('golden.wasm').then(t => t.exports.main([])).catch(console.log).finally(done)";
        assertEquals(expected, inChromium("<script src=golden.wasm-runtime.js></script><script>" + load + "</script>"));
    }

    /** {@return the text that a page with some scripts prints on the console} */
    private static String inChromium(String scripts) throws IOException {
        String capture = "<script>var text = '', over = false; function done() { over = true }"
                + "console.log = console.info = line => text += line + '\\n'</script>";
        ChromeDriver chromium = Programs.chromium(800, 600);
        try (Server server = new Server(FOLDER, "<!DOCTYPE html>" + capture + scripts)) {
            chromium.get(server.address());
            Programs.until(chromium, () -> chromium.executeScript("return over").equals(true));
            return ((String) chromium.executeScript("return text")).trim();
        } finally {
            chromium.quit();
        }
    }
}
