#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "app/live/socket.h"

struct addrinfo;

namespace etalon {

/// Network address of a listening program.
struct NetworkAddress {
    std::string host, port;
};

/// Reads "HOST:PORT", or "[HOST]:PORT" for a host with colons.
NetworkAddress parse_address(const std::string& text);

/// Returns what is wrong with such a text, beginning with the text; empty if it is valid.
std::string check_address(const std::string& text);

/// A connection for writing. While the other end blocks, it asks repeatedly whether to go on.
class TcpSender {
  public:
    using Seconds = std::chrono::duration<double>;
    using GoesOn = std::function<bool(Seconds waited)>;

    explicit TcpSender(GoesOn goes_on) : goes_on_(std::move(goes_on)) {}

    /// Each returns why it failed, in the system's words, or an empty string.
    std::string connect(const NetworkAddress& address);
    std::string send(std::string_view bytes);

  private:
    std::string connect_to(const addrinfo& address);
    std::string wait_until_writable() const;

    GoesOn goes_on_;
    Socket socket_;
};

}  // namespace etalon
