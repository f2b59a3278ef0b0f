// Interface of the HTTP module to the rest of the program: C types only, so that no exception and
// no type of a library crosses it. Texts are UTF-8 and end in a zero.
#pragma once

#include <cstddef>

extern "C" {

struct EtalonHttpRequest {
    const char *method, *host, *path;  ///< the path without what follows a "?"
};

/// Takes the answer to a request, once.
struct EtalonHttpReply {
    void* context;
    void (*send)(void* context, int status, const char* type, const char* body, std::size_t size);
};

/// Answers requests, from several threads at a time.
struct EtalonHttpHandler {
    void* context;
    void (*answer)(void* context, const EtalonHttpRequest* request, const EtalonHttpReply* reply);
};

struct EtalonHttp {
    int version;  ///< etalon_http_version

    /// Begins to serve 127.0.0.1, at a port that the system chooses. Returns null if there is none.
    void* (*start)(const EtalonHttpHandler* handler, int* port);

    /// Ends it, when the requests under way are answered.
    void (*stop)(void* server);
};

/// The module's one symbol has this type and the name etalon_http.
using EtalonHttpEntry = const EtalonHttp* (*)();

}  // extern "C"

inline constexpr int etalon_http_version = 1;
