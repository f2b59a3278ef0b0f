#include "app/live/page_server.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <limits>

namespace etalon {
namespace {

/// Returns 128 random bits from the system in hexadecimal digits; nothing if it has none.
std::string random_token() {
    std::array<unsigned char, 16> bytes;
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
    std::string token;
    for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
    return token;
}

/// Compares in constant time, so that the time does not tell how much is right.
bool is_same(std::string_view a, std::string_view b) {
    unsigned difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
    }
    return difference == 0;
}

/// Returns whether a page was loaded from this machine. The port may be another one, from which
/// ssh forwards.
bool is_own_name(std::string_view host) {
    const std::string_view name = host.substr(0, host.find(':'));
    const std::string_view port = host.substr(name.size());
    return (name == "127.0.0.1" || name == "localhost") &&
           port.find_first_not_of(":0123456789") == std::string_view::npos;
}

}  // namespace

PageServer::PageServer(std::map<std::string, Resource> resources)
    : resources_(std::move(resources)),
      token_(random_token()),
      server_([this](const HttpRequest& request) { return answer(request); }) {}

std::string PageServer::start() {
    if (token_.empty()) return "the system has no random numbers";
    return server_.start();
}

std::string PageServer::address() const {
    return fmt::format("http://127.0.0.1:{}/{}/", server_.port(), token_);
}

double PageServer::idle_seconds() const {
    const std::lock_guard lock(mutex_);
    if (!was_asked_) return std::numeric_limits<double>::infinity();
    const auto now = std::chrono::steady_clock::now();
    if (is_making_ || server_.is_answering()) last_ = now;
    return std::chrono::duration<double>(now - last_).count();
}

void PageServer::note_making(bool is_making) {
    const std::lock_guard lock(mutex_);
    was_asked_ = true;
    is_making_ = is_making;
    last_ = std::chrono::steady_clock::now();
}

HttpAnswer PageServer::answer(const HttpRequest& request) {
    const std::string& path = request.path;
    if (!is_own_name(request.host)) {
        return text_answer(403, "This page is for this machine alone.\n");
    }
    const std::size_t slash = path.find('/', 1);
    if (slash == std::string::npos || !is_same(path.substr(1, slash - 1), token_)) {
        return text_answer(404, "There is nothing here.\n");
    }
    note_making(true);
    struct AtEnd {
        PageServer& self;
        ~AtEnd() { self.note_making(false); }
    } at_end{*this};
    try {
        return answer(request.method, path.substr(slash + 1));
    } catch (const std::exception& error) {
        return text_answer(500, error.what());
    }
}

HttpAnswer PageServer::answer(const std::string& method, const std::string& name) {
    const auto found = resources_.find(name);
    if (found == resources_.end()) return text_answer(404, "There is nothing here.\n");
    const Resource& resource = found->second;
    if (method != resource.method) {
        HttpAnswer refusal = text_answer(405, "Ask by " + resource.method + ".\n");
        refusal.allowed = resource.method;
        return refusal;
    }
    return {200, resource.type, resource.body()};
}

}  // namespace etalon
