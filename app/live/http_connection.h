#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "app/live/http_answer.h"
#include "app/live/http_request.h"
#include "app/live/socket.h"

namespace etalon {

using HttpHandler = std::function<HttpAnswer(const HttpRequest&)>;

/// A client's connection, for one request and its answer. It never blocks; each phase ends at a
/// deadline, however often the client sends or receives something until then.
class HttpConnection {
  public:
    using Clock = std::chrono::steady_clock;

    /// Takes a socket that does not block.
    explicit HttpConnection(Socket socket);

    /// Goes on as far as the client allows. May throw what the handler throws, and std::bad_alloc;
    /// the connection must be closed then.
    void advance(const HttpHandler& handler);

    /// Ends the phase, whose deadline has passed. May throw std::bad_alloc.
    void expire();

    int socket() const { return socket_.number(); }
    short awaited_events() const;  ///< of poll()
    Clock::time_point deadline() const { return deadline_; }
    bool is_answering() const { return phase_ == Phase::answering; }
    bool is_over() const { return phase_ == Phase::over; }
    void close() { phase_ = Phase::over; }

  private:
    /// After an answer the rest of what the client sends is discarded: if a socket is closed with
    /// unread data, the client may lose the answer.
    enum class Phase { asking, answering, discarding, over };

    void receive(const HttpHandler& handler);
    void begin_answer(const HttpAnswer& answer, bool with_body);
    void send();
    void discard();
    void close_if_broken();
    void enter(Phase phase, std::chrono::seconds limit);

    Socket socket_;
    Phase phase_ = Phase::asking;
    Clock::time_point deadline_;
    std::string received_, message_;
    std::size_t sent_ = 0;  ///< bytes of the message
};

}  // namespace etalon
