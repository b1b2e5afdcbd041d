// The border between the program and the plugin that holds the HTTP server: plain C, so that the
// program starts, and renders, where libmicrohttpd is not installed.
#pragma once

#include <cstddef>

extern "C" {

/// What is asked for. Texts end with 0; a header or an argument that is not there is null.
struct RtPreviewRequest {
    const char* method;
    const char* path;  ///< decoded, without the arguments
    const char* host;
    const char* origin;
    const char* token;  ///< X-Token
    const char* map;    ///< argument
    const char* x;      ///< argument
    const char* y;      ///< argument
};

/// Takes the answer, once; the bytes are copied.
using RtPreviewSend = void(void* sink, int status, const char* type, const void* bytes,
                           std::size_t count);

/// Answers a request by calling `send` once; from the server's thread; throws nothing.
using RtPreviewAnswer = void(void* context, const RtPreviewRequest* request, RtPreviewSend* send,
                             void* sink);

/// Serves on a socket that listens, which it closes in the end. Null if it cannot.
using RtPreviewServe = void*(int socket, RtPreviewAnswer* answer, void* context);
/// Ends the server; no answer is asked for from here on.
using RtPreviewEnd = void(void* server);

RtPreviewServe rtPreviewServe;
RtPreviewEnd rtPreviewEnd;
}
