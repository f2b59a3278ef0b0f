// When clients of the page of etalon serve are idle.
#include "app/live/page_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include "app/live/socket.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// A client that has asked for the page, and has read nothing of the answer.
Socket asking_client(const PageServer& server) {
    const std::string url = server.address(), prefix = "http://127.0.0.1:";
    const std::size_t slash = url.find('/', prefix.size());
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(url.substr(prefix.size()))));
    Socket client(::socket(AF_INET, SOCK_STREAM, 0));
    const auto* const general = reinterpret_cast<const sockaddr*>(&address);
    REQUIRE(::connect(client.number(), general, sizeof address) == 0);
    const std::string request = "GET " + url.substr(slash) + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    REQUIRE(::send(client.number(), request.data(), request.size(), 0) ==
            static_cast<ssize_t>(request.size()));
    return client;
}

void read_everything(const Socket& client) {
    std::string bytes(1 << 20, '\0');
    while (::recv(client.number(), bytes.data(), bytes.size(), 0) > 0) continue;
}

/// Waits until the server is idle, or is busy. Returns false if that does not come.
bool becomes(const PageServer& server, bool is_idle) {
    using namespace std::chrono_literals;
    for (int i = 0; i < 10'000; ++i) {
        if ((server.idle_seconds() > 0) == is_idle) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

}  // namespace

TEST_CASE("A server that no one has asked is idle for ever", "[app]") {
    PageServer server({{"", {"text/plain", [] { return std::string(); }}}});
    REQUIRE(server.start() == "");
    CHECK(std::isinf(server.idle_seconds()));
}

TEST_CASE("A server is not idle while an answer is made, nor while it is taken", "[app]") {
    double while_made = 1;
    PageServer* asked = nullptr;
    const auto make = [&] {
        while_made = asked->idle_seconds();
        return std::string(64 << 20, 'x');  // more than the system takes at once
    };
    PageServer server({{"", {"text/plain", make}}});
    asked = &server;
    REQUIRE(server.start() == "");
    const Socket client = asking_client(server);
    char first = 0;
    REQUIRE(::recv(client.number(), &first, 1, 0) == 1);
    CHECK(while_made == 0);
    CHECK(becomes(server, false));
    read_everything(client);
    CHECK(becomes(server, true));
}
