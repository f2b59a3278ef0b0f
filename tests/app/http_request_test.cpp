// Requests to the server of `etalon serve`, as bytes.
#include "app/live/http_request.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

const std::string host = "Host: 127.0.0.1:80\r\n";

int status_of(const std::string& bytes) {
    return parse_http_request(bytes).status;
}

/// Returns the status of a request with the fields, lines that end in CR LF.
int status_with(const std::string& fields) {
    return status_of("GET / HTTP/1.1\r\n" + fields + "\r\n");
}

}  // namespace

TEST_CASE("a request over HTTP has a method, a host and a path without its query", "[app]") {
    const auto [status, request] = parse_http_request(
        "POST /a/%41/b.png?c=/d?e HTTP/1.1\r\nAccept: */*\r\nhOST: \t localhost:80 \r\n"
        "Content-Length: 3\r\nEmpty:\r\n\r\nxyz");
    CHECK(status == 200);
    CHECK(request.method == "POST");
    CHECK(request.host == "localhost:80");
    CHECK(request.path == "/a/%41/b.png");
    CHECK(status_of("GET / HTTP/1.0\r\n" + host + "\r\n") == 200);
}

TEST_CASE("a request over HTTP is incomplete up to its empty line", "[app]") {
    const std::string whole = "GET / HTTP/1.1\r\n" + host + "A: b\r\n\r\n";
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CHECK(status_of(whole.substr(0, size)) == 0);
    }
    CHECK(status_of(whole) == 200);
}

TEST_CASE("a request over HTTP must have one host", "[app]") {
    CHECK(status_with("") == 400);
    CHECK(status_with("A: b\r\n") == 400);
    CHECK(status_with("Hosts: a\r\n") == 400);
    CHECK(status_with(host) == 200);
    CHECK(status_with(host + host) == 400);
    CHECK(status_with(host + "HOST:\r\n") == 400);
}

TEST_CASE("a first line that is not HTTP/1 is refused", "[app]") {
    for (const std::string line : {"",
                                   " ",
                                   "GET",
                                   "GET /",
                                   "GET / ",
                                   "GET / HTTP/2.0",
                                   "GET / HTTP/9.9",
                                   "GET / HTTP/1.",
                                   "GET / HTTP/1.x",
                                   "GET / HTTP/1.11",
                                   "GET / http/1.1",
                                   "GET / HTTP/1.1 ",
                                   "GET  / HTTP/1.1",
                                   " GET / HTTP/1.1",
                                   "GET /\t HTTP/1.1",
                                   "G:T / HTTP/1.1",
                                   "GET http://a/ HTTP/1.1",
                                   "GET * HTTP/1.1",
                                   "GET ?a HTTP/1.1",
                                   "GET /\x80 HTTP/1.1"}) {
        CAPTURE(line);
        CHECK(status_of(line + "\r\n" + host + "\r\n") == 400);
    }
}

TEST_CASE("lines of a request over HTTP end in CR LF and have no other control characters",
          "[app]") {
    CHECK(status_of("GET / HTTP/1.1\nHost: a\n\n") == 400);
    CHECK(status_of("GET / HTTP/1.1\r\nHost: a\n\n") == 400);
    CHECK(status_of("GET / HTTP/1.1\r\nHost: a\n\r\n") == 400);
    CHECK(status_of("GET / HTTP/1.1\r\nHost: a\r\n\n") == 400);
    CHECK(status_of("GET / HTTP/1.1\nHost: a\r\n\r\n") == 400);
    CHECK(status_of("GET / HTTP/1.1\rHost: a\r\n\r\n") == 400);
    CHECK(status_of(std::string("\0\0\r\n\r\n", 6)) == 400);
    for (const std::string field : {"A", "A : b", " A: b", ": b", "A: b\rC: d", "A: b\nC: d",
                                    "A: \x7F", "A: \x01", "\xC4: b"}) {
        CAPTURE(field);
        CHECK(status_with(host + field + "\r\n") == 400);
    }
    CHECK(status_with(host + std::string("A: \0\r\n", 6)) == 400);
    CHECK(status_with(host + "A: \xC3\x84\t:\r\n") == 200);
}

TEST_CASE("the head and the body of a request over HTTP have limits", "[app]") {
    const auto head_of = [](std::size_t size) {
        std::string head = "GET / HTTP/1.1\r\n" + host + "A: ";
        head.resize(size - 4, 'a');
        return head + "\r\n\r\n";
    };
    CHECK(status_of(head_of(largest_http_head)) == 200);
    CHECK(status_of(head_of(largest_http_head + 1)) == 431);
    CHECK(status_of(head_of(1000) + std::string(largest_http_head, 'b')) == 200);
    CHECK(status_of(std::string(largest_http_head, 'G')) == 0);
    CHECK(status_of(std::string(largest_http_head + 1, 'G')) == 431);
    for (const auto& [length, status] :
         {std::pair("0", 200), std::pair("1024", 200), std::pair("1025", 413),
          std::pair("99999999999999999999999", 413), std::pair("", 400), std::pair("-1", 400),
          std::pair("+1", 400), std::pair("1 1", 400), std::pair("1,1", 400),
          std::pair("0x1", 400)}) {
        CAPTURE(length);
        CHECK(status_with(host + "Content-Length: " + length + "\r\n") == status);
    }
    CHECK(status_with(host + "Content-Length: 1\r\nContent-Length: 1\r\n") == 400);
}
