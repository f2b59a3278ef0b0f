#include "app/live/http_answer.h"

#include <fmt/format.h>

#include <string_view>

namespace etalon {
namespace {

/// Returns the status in words (RFC 9110, 15).
std::string_view reason(int status) {
    switch (status) {
        case 200:
            return "OK";
        case 400:
            return "Bad Request";
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 408:
            return "Request Timeout";
        case 413:
            return "Content Too Large";
        case 431:
            return "Request Header Fields Too Large";
        default:
            return "Internal Server Error";
    }
}

constexpr std::string_view common_headers =
    "Connection: close\r\n"
    "Cache-Control: no-store\r\n"
    "Content-Security-Policy: default-src 'none'; connect-src 'self'; img-src blob: data:; "
    "script-src 'unsafe-inline'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "X-Content-Type-Options: nosniff\r\n";

}  // namespace

HttpAnswer text_answer(int status, std::string text) {
    if (text.empty()) text = fmt::format("{}.\n", reason(status));
    return {status, "text/plain; charset=utf-8", std::move(text)};
}

std::string http_message(const HttpAnswer& answer, bool with_body) {
    const std::string allow =
        answer.allowed.empty() ? "" : fmt::format("Allow: {}\r\n", answer.allowed);
    return fmt::format("HTTP/1.1 {} {}\r\n{}{}Content-Type: {}\r\nContent-Length: {}\r\n\r\n{}",
                       answer.status, reason(answer.status), common_headers, allow, answer.type,
                       answer.body.size(), with_body ? answer.body : std::string_view());
}

}  // namespace etalon
