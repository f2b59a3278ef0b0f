#include "app/live/http_server.h"

#include <netinet/in.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <system_error>

#include "core/base/uninterrupted.h"

namespace etalon {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t most_connections = 64;
constexpr auto time_to_end = 1s;

/// Time without new connections after the system had no descriptor for one.
constexpr auto pause_without_descriptors = 20ms;

/// Returns the milliseconds that poll() may wait; -1 for an unlimited time.
int milliseconds_until(HttpConnection::Clock::time_point end) {
    if (end == HttpConnection::Clock::time_point::max()) return -1;
    const auto rest =
        std::chrono::ceil<std::chrono::milliseconds>(end - HttpConnection::Clock::now());
    return std::max(0, static_cast<int>(rest.count()));
}

}  // namespace

HttpServer::~HttpServer() {
    if (!thread_.joinable()) return;
    uninterrupted([&] { return eventfd_write(ending_.number(), 1); });
    thread_.join();
}

std::string HttpServer::start() {
    ending_ = Socket(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
    if (!ending_) return error_text(errno);
    if (std::string error = listen(); !error.empty()) {
        return "no port of 127.0.0.1 can be listened at: " + error;
    }
    connections_.reserve(most_connections);
    polled_.reserve(2 + most_connections);
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error& error) {
        return "no thread can be started: " + error.code().message();
    }
    return {};
}

std::string HttpServer::listen() {
    listener_ = Socket(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const general = reinterpret_cast<sockaddr*>(&address);
    if (!listener_ || ::bind(listener_.number(), general, size) != 0 ||
        ::listen(listener_.number(), SOMAXCONN) != 0 ||
        ::getsockname(listener_.number(), general, &size) != 0) {
        return error_text(errno);
    }
    port_ = ntohs(address.sin_port);
    return {};
}

/// Nothing here throws: the vectors have their memory from the start.
void HttpServer::run() {
    bool is_ending = false;
    auto end = Clock::time_point::max();
    while ((!is_ending || !connections_.empty()) && wait(!is_ending, end)) {
        const Clock::time_point now = Clock::now();
        if (polled_[0].revents != 0) {
            is_ending = true;
            end = now + time_to_end;
        }
        for (std::size_t i = 0; i < connections_.size(); ++i) {
            serve(connections_[i], polled_[2 + i].revents, now);
        }
        std::erase_if(connections_, [&](const HttpConnection& c) {
            return c.is_over() || (is_ending && (!c.is_answering() || now >= end));
        });
        is_answering_ = std::ranges::any_of(connections_, &HttpConnection::is_answering);
        if (polled_[1].revents != 0 && !is_ending) accept();
    }
}

/// Waits until something can go on, at most until a deadline. Returns false if that is impossible.
bool HttpServer::wait(bool accepts, Clock::time_point end) {
    polled_.assign({{accepts ? ending_.number() : -1, POLLIN, 0},
                    {accepts ? listener_.number() : -1, POLLIN, 0}});
    for (const HttpConnection& c : connections_) {
        polled_.push_back({c.socket(), c.awaited_events(), 0});
        end = std::min(end, c.deadline());
    }
    return uninterrupted([&] {
               return ::poll(polled_.data(), polled_.size(), milliseconds_until(end));
           }) >= 0;
}

/// `now` is when poll() returned, so that the time of other connections' answers does not count.
void HttpServer::serve(HttpConnection& connection, short events, Clock::time_point now) {
    try {
        if (events != 0) connection.advance(handler_);
        if (now >= connection.deadline()) connection.expire();
    } catch (...) {  // no memory
        connection.close();
    }
}

/// Accepts one connection, so that each can send its request before many others follow.
void HttpServer::accept() {
    Socket socket(uninterrupted([&] {
        return ::accept4(listener_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    }));
    if (!socket) return std::this_thread::sleep_for(pause_without_descriptors);
    if (connections_.size() == most_connections) {
        const auto idle = std::find_if(connections_.begin(), connections_.end(),
                                       [](const auto& c) { return !c.is_answering(); });
        connections_.erase(idle == connections_.end() ? connections_.begin() : idle);
    }
    connections_.emplace_back(std::move(socket));
}

}  // namespace etalon
