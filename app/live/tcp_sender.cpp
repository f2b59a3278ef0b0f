#include "app/live/tcp_sender.h"

#include <linux/sockios.h>
#include <netdb.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cerrno>
#include <memory>

#include "core/base/parse_number.h"
#include "core/base/uninterrupted.h"

namespace etalon {
namespace {

/// Milliseconds between two checks whether to go on.
constexpr int interval = 20;

/// Returns how many of the bytes sent the other end has not accepted yet; 0 if that is unknown.
int unaccepted(int socket) {
    int bytes = 0;
    return ::ioctl(socket, SIOCOUTQ, &bytes) == 0 ? bytes : 0;
}

}  // namespace

NetworkAddress parse_address(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) return {};
    std::string host = text.substr(0, colon);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
        host = host.substr(1, host.size() - 2);
    }
    return {host, text.substr(colon + 1)};
}

std::string check_address(const std::string& text) {
    const NetworkAddress address = parse_address(text);
    const unsigned port = parse_number<unsigned>(address.port).value_or(0);
    const bool is_port = port > 0 && port < 65536;
    return is_port && !address.host.empty() ? "" : text + ": expected HOST:PORT";
}

std::string TcpSender::connect(const NetworkAddress& address) {
    addrinfo hints = {};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    const int error = getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found);
    if (error != 0) return gai_strerror(error);
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> list(found, freeaddrinfo);
    std::string reason;
    for (const addrinfo* a = found; a; a = a->ai_next) {
        reason = connect_to(*a);
        if (reason.empty()) return {};
        socket_ = Socket();
    }
    return reason;
}

std::string TcpSender::connect_to(const addrinfo& address) {
    socket_ = Socket(::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket_) return error_text(errno);
    if (::connect(socket_.number(), address.ai_addr, address.ai_addrlen) == 0) return {};
    if (errno != EINPROGRESS) return error_text(errno);
    const std::string reason = wait_until_writable();
    if (!reason.empty()) return reason;
    int error = 0;
    socklen_t size = sizeof error;
    getsockopt(socket_.number(), SOL_SOCKET, SO_ERROR, &error, &size);
    return error == 0 ? std::string() : error_text(error);
}

/// The system calls a socket writable only when a third of its buffer is free, which takes a slow
/// viewer some seconds. So it counts as waiting only while the other end accepts nothing.
std::string TcpSender::wait_until_writable() const {
    using Clock = std::chrono::steady_clock;
    int waiting = unaccepted(socket_.number());
    for (auto start = Clock::now(); goes_on_(Clock::now() - start);) {
        pollfd state = {socket_.number(), POLLOUT, 0};
        const int ready = ::poll(&state, 1, interval);
        if (ready > 0) return {};
        if (ready < 0 && errno != EINTR) return error_text(errno);
        const int still_waiting = unaccepted(socket_.number());
        if (still_waiting < waiting) start = Clock::now();
        waiting = still_waiting;
    }
    return error_text(ETIMEDOUT);
}

std::string TcpSender::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            const std::string reason = wait_until_writable();
            if (!reason.empty()) return reason;
        } else if (errno != EINTR) {
            return error_text(errno);
        }
    }
    return {};
}

}  // namespace etalon
