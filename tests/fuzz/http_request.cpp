// Fuzzes the parser of requests to the page of `serve`, which may arrive in any pieces.
#include "app/live/http_request.h"

#include <algorithm>

#include "tests/fuzz/target.h"

namespace etalon::fuzz {
namespace {

bool is_printable(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 0x7F; });
}

void check_request(const HttpRequest& request) {
    require(!request.method.empty() && is_printable(request.method), "a method that is none");
    require(request.path.starts_with('/') && is_printable(request.path) &&
                request.path.find('?') == std::string::npos,
            "a path that is none");
}

void run(std::string_view bytes) {
    const ParsedRequest whole = parse_http_request(bytes);
    if (whole.status == 200) check_request(whole.request);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 8) {
        const int status = parse_http_request(bytes.substr(0, size)).status;
        require(status == 0 || status == whole.status, "what follows changes the answer");
    }
}

}  // namespace

const Target target = {run, true};

}  // namespace etalon::fuzz
