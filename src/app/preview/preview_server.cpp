#include "preview_server.h"

#include "rt/core/error.h"
#include "rt/core/plugin.h"

#include <arpa/inet.h>
#include <dlfcn.h>
#include <netinet/in.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>

namespace rt {
namespace {

constexpr const char* kPlugin = "librt_preview.so";
constexpr int kBacklog = 16;

[[noreturn]] void refuse(const std::string& what) {
    throw OutputError("--preview: " + what);
}

/// A socket that listens on the loopback address; `port` becomes the one that it has.
int listenOn(int& port) {
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket < 0) refuse(std::string("no socket: ") + std::strerror(errno));
    // A port whose last connections have not faded away is free all the same.
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const general = reinterpret_cast<sockaddr*>(&address);
    if (::bind(socket, general, sizeof address) != 0 || ::listen(socket, kBacklog) != 0) {
        const std::string reason = std::strerror(errno);
        ::close(socket);
        refuse("port " + std::to_string(port) + " of 127.0.0.1: " + reason +
               "; choose another with --preview-port N, or 0 for any that is free");
    }
    socklen_t size = sizeof address;
    ::getsockname(socket, general, &size);
    port = ntohs(address.sin_port);
    return socket;
}

/// 128 bits that nobody can guess.
std::string freshToken() {
    std::array<unsigned char, 16> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
        refuse("the system gives no random numbers");
    }
    constexpr const char* kDigits = "0123456789abcdef";
    std::string token;
    for (const unsigned char byte : bytes) {
        token += kDigits[byte / 16];
        token += kDigits[byte % 16];
    }
    return token;
}

void* openPlugin() {
    if (const auto path = findPlugin(kPlugin)) {
        void* const plugin = ::dlopen(path->c_str(), RTLD_NOW | RTLD_LOCAL);
        if (plugin) return plugin;
        refuse(std::string("the server cannot be loaded: install libmicrohttpd12 (") + ::dlerror() +
               ")");
    }
    refuse(std::string("built without a server: install libmicrohttpd-dev and build again (") +
           kPlugin + " is missing beside the program)");
}

template <class Function>
Function* find(void* plugin, const char* name) {
    auto* const function = reinterpret_cast<Function*>(::dlsym(plugin, name));
    if (!function) refuse(std::string(kPlugin) + " is not this program's plugin: build it again");
    return function;
}

void answer(void* context, const RtPreviewRequest* request, RtPreviewSend* send, void* sink) {
    PreviewAnswer answer;
    try {
        answer = static_cast<PreviewBoard*>(context)->answer(*request);
    } catch (const std::exception&) {
        answer = {500, "text/plain; charset=utf-8", "The system has no memory left.\n"};
    }
    send(sink, answer.status, answer.type.c_str(), answer.body.data(), answer.body.size());
}

}  // namespace

PreviewServer::PreviewServer(int port, bool watching) : port_(port) {
    void* const plugin = openPlugin();
    auto* const serve = find<RtPreviewServe>(plugin, "rtPreviewServe");
    end_ = find<RtPreviewEnd>(plugin, "rtPreviewEnd");
    const int socket = listenOn(port_);
    board_ = std::make_unique<PreviewBoard>(port_, freshToken(), watching);
    server_ = serve(socket, &answer, board_.get());
    if (!server_) {
        ::close(socket);
        refuse("the server does not start");
    }
}

PreviewServer::~PreviewServer() {
    end_(server_);
}

std::string PreviewServer::address() const {
    return "http://127.0.0.1:" + std::to_string(port_) + "/";
}

}  // namespace rt
