package yarts.physics.release;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.module.ModuleDescriptor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.xpath.XPath;
import javax.xml.xpath.XPathConstants;
import javax.xml.xpath.XPathFactory;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;

/** Checks the bundle for Maven Central that {@code mvn -Prelease verify} has built. */
class BundleIT {
    private static final String VERSION = System.getProperty("bundle.version");
    private static final boolean SIGNED = Boolean.getBoolean("bundle.signed");
    private static final String STEM = "io/github/yarts/yarts-physics/" + VERSION + "/yarts-physics-" + VERSION;
    private static final List<String> FILES = List.of(".pom", ".jar", "-sources.jar", "-javadoc.jar", "-cyclonedx.xml");
    private static final Map<String, String> CHECKSUMS =
            Map.of(".md5", "MD5", ".sha1", "SHA-1", ".sha256", "SHA-256", ".sha512", "SHA-512");
    private static final int MOST_BYTES = 80_000;
    private static final Path SOURCES = Path.of("src/main/java");

    private static SortedMap<String, byte[]> bundle;
    private static SortedMap<String, byte[]> jar;

    @BeforeAll
    static void open() throws IOException {
        bundle = unzip(Files.readAllBytes(Path.of(System.getProperty("bundle"))));
        jar = unzip(bundle.get(STEM + ".jar"));
    }

    @Test
    void theBundleHasOnlyTheFilesAndTheirChecksums() {
        Set<String> expected = new TreeSet<>();
        for (String file : FILES) {
            expected.add(STEM + file);
            CHECKSUMS.keySet().forEach(suffix -> expected.add(STEM + file + suffix));
            if (SIGNED) expected.add(STEM + file + ".asc");
        }
        assertEquals(expected, bundle.keySet());
    }

    @Test
    void everyChecksumIsRight() throws Exception {
        for (String file : FILES) {
            for (Map.Entry<String, String> checksum : CHECKSUMS.entrySet()) {
                byte[] digest = MessageDigest.getInstance(checksum.getValue()).digest(bundle.get(STEM + file));
                String written = new String(bundle.get(STEM + file + checksum.getKey()), US_ASCII);
                assertEquals(HexFormat.of().formatHex(digest), written, file + checksum.getKey());
            }
        }
    }

    @Test
    void theBundleHasSignaturesIfThereIsAKey() {
        if (!SIGNED) System.out.println("No key: the bundle has no signatures, which Maven Central requires");
        for (String file : FILES) {
            byte[] signature = bundle.get(STEM + file + ".asc");
            assertEquals(SIGNED, signature != null, file);
            if (SIGNED) assertTrue(new String(signature, US_ASCII).startsWith("-----BEGIN PGP SIGNATURE-----"), file);
        }
    }

    @Test
    void theJarHasOnlyTheLibrary() throws IOException {
        Set<String> found = new TreeSet<>();
        for (String entry : jar.keySet()) {
            if (entry.endsWith(".class")) found.add(entry.replaceFirst("(\\$\\w+)?\\.class$", ".java"));
            else assertTrue(entry.startsWith("META-INF/"), entry);
        }
        assertEquals(sources(), found);
        int bytes = bundle.get(STEM + ".jar").length;
        assertTrue(bytes < MOST_BYTES, bytes + " bytes");
    }

    @Test
    void theJarIsAModuleThatRequiresOnlyJavaBase() throws IOException {
        ModuleDescriptor module = ModuleDescriptor.read(new ByteArrayInputStream(jar.get("module-info.class")));
        assertEquals("yarts.physics", module.name());
        assertEquals(
                Set.of("java.base"),
                module.requires().stream().map(ModuleDescriptor.Requires::name).collect(Collectors.toSet()));
        assertEquals(
                Set.of("yarts.physics"),
                module.exports().stream().map(ModuleDescriptor.Exports::source).collect(Collectors.toSet()));
        assertFalse(module.isOpen());
    }

    @Test
    void everyClassIsOfJava8AndTheModuleOfJava9() {
        jar.forEach((name, bytes) -> {
            int version = name.equals("module-info.class") ? Opcodes.V9 : Opcodes.V1_8;
            if (name.endsWith(".class")) assertEquals(version, new ClassReader(bytes).readUnsignedShort(6), name);
        });
    }

    @Test
    void theJarHasItsVersionAndLicence() throws IOException {
        var manifest = new Manifest(new ByteArrayInputStream(jar.get("META-INF/MANIFEST.MF"))).getMainAttributes();
        assertEquals("yarts-physics", manifest.getValue("Implementation-Title"));
        assertEquals(VERSION, manifest.getValue("Implementation-Version"));
        assertArrayEquals(Files.readAllBytes(Path.of("LICENSE")), jar.get("META-INF/LICENSE"));
        assertArrayEquals(bundle.get(STEM + ".pom"), jar.get("META-INF/maven/io.github.yarts/yarts-physics/pom.xml"));
    }

    @Test
    void theSourcesAreThoseOfTheLibrary() throws IOException {
        SortedMap<String, byte[]> found = unzip(bundle.get(STEM + "-sources.jar"));
        assertTrue(found.containsKey("META-INF/LICENSE"));
        found.keySet().removeIf(name -> name.startsWith("META-INF/"));
        assertEquals(sources(), found.keySet());
        for (String name : sources()) assertArrayEquals(Files.readAllBytes(SOURCES.resolve(name)), found.get(name));
    }

    @Test
    void theJavadocHasAPageForEachPublicTypeAndNoOther() throws IOException {
        Set<String> pages = unzip(bundle.get(STEM + "-javadoc.jar")).keySet();
        assertTrue(pages.contains("index.html"));
        Set<String> types = new TreeSet<>();
        jar.forEach((name, bytes) -> {
            if (!name.matches("yarts/physics/\\w+\\.class")) return;
            String page = "yarts.physics/" + name.replaceFirst("class$", "html");
            boolean isPublic = (new ClassReader(bytes).getAccess() & Opcodes.ACC_PUBLIC) != 0;
            assertEquals(isPublic, pages.contains(page), page);
            if (isPublic) types.add(name);
        });
        assertTrue(types.contains("yarts/physics/Unit.class"), types::toString);
    }

    @Test
    void thePomHasTheElementsThatMavenCentralRequires() throws Exception {
        Document pom = parse(".pom");
        assertEquals("io.github.yarts", text(pom, "/project/groupId"));
        assertEquals("yarts-physics", text(pom, "/project/artifactId"));
        assertEquals(VERSION, text(pom, "/project/version"));
        assertFalse(VERSION.endsWith("-SNAPSHOT"));
        for (String path : List.of(
                "name",
                "description",
                "url",
                "licenses/license/name",
                "licenses/license/url",
                "developers/developer/name",
                "developers/developer/organization",
                "scm/connection",
                "scm/developerConnection",
                "scm/url",
                "issueManagement/url")) {
            assertFalse(text(pom, "/project/" + path).isBlank(), path);
        }
    }

    @Test
    void thePomHasNoDependenciesAndNoRepositories() throws Exception {
        Document pom = parse(".pom");
        assertFalse(all(pom, "/project/dependencies/dependency").isEmpty());
        assertEquals(List.of(), all(pom, "/project/dependencies/dependency[not(scope = 'test')]/artifactId"));
        assertEquals(List.of(), all(pom, "/project/parent | //repositories | //pluginRepositories"));
    }

    @Test
    void theSbomNamesTheLicenceAndNoComponents() throws Exception {
        Document bom = parse("-cyclonedx.xml");
        assertEquals("yarts-physics", text(bom, "/bom/metadata/component/name"));
        assertEquals(VERSION, text(bom, "/bom/metadata/component/version"));
        assertEquals("MIT", text(bom, "/bom/metadata/component/licenses/license/id"));
        assertEquals(List.of(), all(bom, "/bom/components/component"));
    }

    private static Set<String> sources() throws IOException {
        try (Stream<Path> files = Files.walk(SOURCES)) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .map(file -> SOURCES.relativize(file).toString().replace('\\', '/'))
                    .collect(Collectors.toCollection(TreeSet::new));
        }
    }

    /** {@return the files of a zip, by name} */
    private static SortedMap<String, byte[]> unzip(byte[] bytes) throws IOException {
        SortedMap<String, byte[]> files = new TreeMap<>();
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(bytes))) {
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                if (!entry.isDirectory()) files.put(entry.getName(), zip.readAllBytes());
            }
        }
        return files;
    }

    private static Document parse(String file) throws Exception {
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(bundle.get(STEM + file)));
    }

    private static String text(Document document, String path) throws Exception {
        return xpath().evaluate(path, document);
    }

    private static List<String> all(Document document, String path) throws Exception {
        NodeList nodes = (NodeList) xpath().evaluate(path, document, XPathConstants.NODESET);
        return IntStream.range(0, nodes.getLength())
                .mapToObj(i -> nodes.item(i).getTextContent())
                .collect(Collectors.toList());
    }

    private static XPath xpath() {
        return XPathFactory.newInstance().newXPath();
    }
}
