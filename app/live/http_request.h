#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace etalon {

/// What a request asks for. Percent escapes in the path are kept.
struct HttpRequest {
    std::string method, host, path;  ///< the path without a query
};

/// Limits, in bytes, on what precedes the body of a request, and on the body.
constexpr std::size_t largest_http_head = 8192, largest_http_body = 1024;

struct ParsedRequest {
    int status;  ///< 200: valid; 0: incomplete; otherwise the status that refuses it
    HttpRequest request;
};

/// Parses what a client of HTTP/1 has sent so far. Bodies are ignored.
ParsedRequest parse_http_request(std::string_view bytes);

}  // namespace etalon
