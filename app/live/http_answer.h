#pragma once

#include <string>

namespace etalon {

/// An answer to a request over HTTP.
struct HttpAnswer {
    int status;
    std::string type;  ///< as in Content-Type
    std::string body;
    std::string allowed{};  ///< the method that a 405 names
};

/// Returns an answer in plain text; by default the text is the status in words.
HttpAnswer text_answer(int status, std::string text = {});

/// Returns the bytes of an answer after which the connection ends. Its headers disable caches,
/// foreign content and referrers. The answer to a HEAD request omits the body.
std::string http_message(const HttpAnswer& answer, bool with_body);

}  // namespace etalon
