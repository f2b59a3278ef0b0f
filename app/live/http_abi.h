// Interface between the HTTP module and the rest of the program, in C types only, so that no
// exception and no type of a library crosses it. Texts are UTF-8 and end in a zero.
#pragma once

#include <cstddef>

extern "C" {

struct EtalonHttpRequest {
    const char *method, *host, *path;  ///< the path without a query
};

/// Receives the answer to a request, once.
struct EtalonHttpReply {
    void* context;
    void (*send)(void* context, int status, const char* type, const char* body, std::size_t size);
};

/// Answers requests; called by several threads.
struct EtalonHttpHandler {
    void* context;
    void (*answer)(void* context, const EtalonHttpRequest* request, const EtalonHttpReply* reply);
};

struct EtalonHttp {
    int version;  ///< etalon_http_version

    /// Starts to serve 127.0.0.1, at a port that the system chooses. Returns null on failure.
    void* (*start)(const EtalonHttpHandler* handler, int* port);

    /// Stops the server after pending requests are answered.
    void (*stop)(void* server);
};

/// The module's one symbol has this type and the name etalon_http.
using EtalonHttpEntry = const EtalonHttp* (*)();

}  // extern "C"

inline constexpr int etalon_http_version = 1;
