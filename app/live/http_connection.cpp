#include "app/live/http_connection.h"

#include <poll.h>
#include <sys/socket.h>

#include <array>

#include "core/base/uninterrupted.h"

namespace etalon {
namespace {

using namespace std::chrono_literals;

constexpr auto time_to_ask = 2s;
constexpr auto time_to_answer = 30s;  ///< enough for a tunnel to another machine
constexpr auto time_to_discard = 1s;

}  // namespace

HttpConnection::HttpConnection(Socket socket)
    : socket_(std::move(socket)), deadline_(Clock::now() + time_to_ask) {}

short HttpConnection::awaited_events() const {
    return is_answering() ? POLLOUT : POLLIN;
}

void HttpConnection::advance(const HttpHandler& handler) {
    if (phase_ == Phase::asking) receive(handler);
    if (phase_ == Phase::answering) send();
    if (phase_ == Phase::discarding) discard();
}

void HttpConnection::expire() {
    if (phase_ == Phase::asking && !received_.empty()) {
        begin_answer(text_answer(408), true);
    } else {
        close();
    }
}

void HttpConnection::receive(const HttpHandler& handler) {
    std::array<char, largest_http_head + 1> bytes;
    const ssize_t size = uninterrupted(
        [&] { return ::recv(socket(), bytes.data(), bytes.size() - received_.size(), 0); });
    if (size == 0) return close();
    if (size < 0) return close_if_broken();
    received_.append(bytes.data(), static_cast<std::size_t>(size));
    const auto [status, request] = parse_http_request(received_);
    if (status == 0) return;
    begin_answer(status == 200 ? handler(request) : text_answer(status), request.method != "HEAD");
}

void HttpConnection::begin_answer(const HttpAnswer& answer, bool with_body) {
    message_ = http_message(answer, with_body);
    enter(Phase::answering, time_to_answer);
}

void HttpConnection::send() {
    while (sent_ < message_.size()) {
        const ssize_t size = uninterrupted([&] {
            return ::send(socket(), message_.data() + sent_, message_.size() - sent_, MSG_NOSIGNAL);
        });
        if (size < 0) return close_if_broken();
        sent_ += static_cast<std::size_t>(size);
    }
    message_ = {};
    ::shutdown(socket(), SHUT_WR);
    enter(Phase::discarding, time_to_discard);
}

void HttpConnection::discard() {
    std::array<char, 4096> bytes;
    const ssize_t size =
        uninterrupted([&] { return ::recv(socket(), bytes.data(), bytes.size(), 0); });
    if (size == 0) close();
    if (size < 0) close_if_broken();
}

void HttpConnection::close_if_broken() {
    if (errno != EAGAIN && errno != EWOULDBLOCK) close();
}

void HttpConnection::enter(Phase phase, std::chrono::seconds limit) {
    phase_ = phase;
    deadline_ = Clock::now() + limit;
}

}  // namespace etalon
