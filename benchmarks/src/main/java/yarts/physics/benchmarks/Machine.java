package yarts.physics.benchmarks;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** The machine on which the benchmarks ran. The JSON of JMH contains the JVM and the flags of each benchmark. */
final class Machine {
    private Machine() {}

    static String describe() throws IOException {
        OperatingSystemMXBean os = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        return String.join(
                "\n",
                "CPU: " + cpu() + ", " + os.getAvailableProcessors() + " threads",
                "Memory: " + (os.getTotalMemorySize() >> 30) + " GiB",
                "OS: " + os.getName() + " " + os.getVersion() + ", " + os.getArch(),
                "JVM: " + System.getProperty("java.vm.name") + " " + System.getProperty("java.vm.version"),
                "Flags: " + flags(),
                "");
    }

    /** The CPU from the operating system, because the JVM knows only its architecture. */
    private static String cpu() throws IOException {
        Path linux = Path.of("/proc/cpuinfo");
        if (Files.isReadable(linux)) {
            try (Stream<String> lines = Files.lines(linux)) {
                return lines.filter(line -> line.startsWith("model name"))
                        .map(line -> line.replaceFirst(".*: ", ""))
                        .findFirst()
                        .orElse(System.getProperty("os.arch"));
            }
        }
        String windows = System.getenv("PROCESSOR_IDENTIFIER");
        return windows != null ? windows : System.getProperty("os.arch");
    }

    private static String flags() {
        var flags = ManagementFactory.getRuntimeMXBean().getInputArguments();
        return flags.isEmpty() ? "none" : String.join(" ", flags);
    }
}
