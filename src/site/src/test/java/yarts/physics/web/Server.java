package yarts.physics.web;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Serves a page and the files of a folder over HTTP, because a browser does not load WebAssembly from files. */
final class Server implements AutoCloseable {
    private final HttpServer server;

    Server(Path folder, String page) throws IOException {
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext("/", exchange -> {
            String name = exchange.getRequestURI().getPath().substring(1);
            Path file = folder.resolve(name).normalize();
            if (name.isEmpty()) send(exchange, 200, "text/html", page.getBytes(StandardCharsets.UTF_8));
            else if (!Files.isRegularFile(file)) send(exchange, 404, "text/plain", new byte[] {'?'});
            else send(exchange, 200, type(name), Files.readAllBytes(file));
        });
        server.start();
    }

    private static String type(String name) {
        return name.endsWith(".wasm") ? "application/wasm" : "text/javascript";
    }

    private static void send(HttpExchange exchange, int status, String type, byte[] body) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        exchange.sendResponseHeaders(status, body.length);
        exchange.getResponseBody().write(body);
        exchange.close();
    }

    String address() {
        return "http://" + server.getAddress().getHostString() + ":"
                + server.getAddress().getPort() + "/";
    }

    @Override
    public void close() {
        server.stop(0);
    }
}
