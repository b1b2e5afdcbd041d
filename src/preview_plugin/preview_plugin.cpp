// The HTTP server of --preview: libmicrohttpd behind a border of plain C.
#include "rt/app/preview_abi.h"

#include <microhttpd.h>

#include <cstddef>

namespace {

constexpr unsigned kMostConnections = 16;
constexpr unsigned kIdleSeconds = 15;
constexpr std::size_t kMostRequestBytes = std::size_t{32} << 10;

struct Server {
    RtPreviewAnswer* answer = nullptr;
    void* context = nullptr;
    MHD_Daemon* daemon = nullptr;
};

/// The page may use what it came with and this server, and nobody may show it in a frame or read
/// it from elsewhere.
constexpr const char* kHeaders[][2] = {
    {"Cache-Control", "no-store"},
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src 'self' "
     "data: "
     "blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Referrer-Policy", "no-referrer"},
    {"X-Content-Type-Options", "nosniff"},
};

struct Sink {
    MHD_Connection* connection;
    MHD_Result result = MHD_NO;
};

void send(void* to, int status, const char* type, const void* bytes, std::size_t count) {
    auto& sink = *static_cast<Sink*>(to);
    // The library copies, and only its older interface asks for a pointer to what is not const.
    MHD_Response* response =
        MHD_create_response_from_buffer(count, const_cast<void*>(bytes), MHD_RESPMEM_MUST_COPY);
    if (response == nullptr) return;
    for (const auto& [name, value] : kHeaders) MHD_add_response_header(response, name, value);
    MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, type);
    sink.result = MHD_queue_response(sink.connection, static_cast<unsigned>(status), response);
    MHD_destroy_response(response);
}

MHD_Result onRequest(void* self, MHD_Connection* connection, const char* path, const char* method,
                     const char*, const char*, std::size_t* bodyBytes, void** seen) {
    static char mark;
    const auto& server = *static_cast<const Server*>(self);
    if (*seen == nullptr) {
        *seen = &mark;
        return MHD_YES;
    }
    if (*bodyBytes > 0) {  // no request needs a body
        *bodyBytes = 0;
        return MHD_YES;
    }
    const auto header = [&](const char* name) {
        return MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name);
    };
    const auto argument = [&](const char* name) {
        return MHD_lookup_connection_value(connection, MHD_GET_ARGUMENT_KIND, name);
    };
    const RtPreviewRequest request{
        method,          path,          header("Host"), header("Origin"), header("X-Token"),
        argument("map"), argument("x"), argument("y")};
    Sink sink{connection};
    server.answer(server.context, &request, &send, &sink);
    return sink.result;
}

}  // namespace

extern "C" void* rtPreviewServe(int socket, RtPreviewAnswer* answer, void* context) {
    auto* server = new Server{answer, context, nullptr};
    server->daemon = MHD_start_daemon(
        MHD_USE_INTERNAL_POLLING_THREAD | MHD_USE_ITC, 0, nullptr, nullptr, &onRequest, server,
        MHD_OPTION_LISTEN_SOCKET, socket, MHD_OPTION_CONNECTION_LIMIT, kMostConnections,
        MHD_OPTION_CONNECTION_TIMEOUT, kIdleSeconds, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
        kMostRequestBytes, MHD_OPTION_END);
    if (server->daemon != nullptr) return server;
    delete server;
    return nullptr;
}

extern "C" void rtPreviewEnd(void* server) {
    auto* const ended = static_cast<Server*>(server);
    MHD_stop_daemon(ended->daemon);
    delete ended;
}
