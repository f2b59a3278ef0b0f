#pragma once

#include <poll.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "app/live/http_connection.h"

namespace etalon {

/// A small server of HTTP/1.1 for clients on this machine. One thread serves all connections and
/// calls the handler. Clients are not trusted: what they send is limited in size and time, and none
/// of them delays another, except by the time of the handler.
class HttpServer {
  public:
    explicit HttpServer(HttpHandler handler) : handler_(std::move(handler)) {}

    /// Lets answers that have begun continue for a second.
    ~HttpServer();

    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// Listens at 127.0.0.1, at a port that the system chooses. Returns why that failed, or an
    /// empty string.
    std::string start();

    /// Returns the port; the handler may also call it.
    int port() const { return port_; }

    /// Returns whether an answer is on its way. Thread-safe.
    bool is_answering() const { return is_answering_; }

  private:
    using Clock = HttpConnection::Clock;

    std::string listen();
    void run();
    bool wait(bool accepts, Clock::time_point end);
    void serve(HttpConnection& connection, short events, Clock::time_point now);
    void accept();

    HttpHandler handler_;
    Socket listener_, ending_;  ///< an eventfd that is readable when the thread is to end
    int port_ = 0;
    std::vector<HttpConnection> connections_;  ///< the oldest first
    std::vector<pollfd> polled_;               ///< ending, listener, connections
    std::atomic<bool> is_answering_ = false;
    std::thread thread_;
};

}  // namespace etalon
