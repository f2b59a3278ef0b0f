#include "app/live/page_server.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <limits>

#include "core/base/module_symbol.h"

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

}  // namespace

PageServer::PageServer(std::map<std::string, Resource> resources)
    : resources_(std::move(resources)), token_(random_token()) {}

PageServer::~PageServer() {
    if (server_) module_->stop(server_);
}

std::string PageServer::start() {
    if (token_.empty()) return "the system has no random numbers";
    const Result<void*> symbol = module_symbol("etalon_http.so", "etalon_http");
    if (!symbol) return "the HTTP module cannot be loaded: " + symbol.error;
    module_ = reinterpret_cast<EtalonHttpEntry>(symbol.value)();
    if (module_->version != etalon_http_version) {
        return "etalon_http.so belongs to another version of the program";
    }
    const EtalonHttpHandler handler = {
        this, [](void* self, const EtalonHttpRequest* request, const EtalonHttpReply* reply) {
            const Answer a = static_cast<PageServer*>(self)->answer(request->method, request->host,
                                                                    request->path);
            reply->send(reply->context, a.status, a.type.c_str(), a.body.data(), a.body.size());
        }};
    const std::lock_guard lock(mutex_);  // no answer before the port is known
    server_ = module_->start(&handler, &port_);
    return server_ ? "" : "no port of 127.0.0.1 can be listened at";
}

std::string PageServer::address() const {
    return fmt::format("http://127.0.0.1:{}/{}/", port_, token_);
}

double PageServer::idle_seconds() const {
    const std::lock_guard lock(mutex_);
    if (!was_asked_) return std::numeric_limits<double>::infinity();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - last_).count();
}

bool PageServer::is_own_name(const std::string& host) const {
    const std::lock_guard lock(mutex_);
    return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

PageServer::Answer PageServer::answer(const std::string& method, const std::string& host,
                                      const std::string& path) {
    const std::string text = "text/plain; charset=utf-8";
    if (!is_own_name(host)) return {403, text, "This page is for this machine alone.\n"};
    const std::size_t slash = path.find('/', 1);
    if (slash == std::string::npos || !is_same(path.substr(1, slash - 1), token_)) {
        return {404, text, "There is nothing here.\n"};
    }
    try {
        Answer result = answer(method, path.substr(slash + 1));
        const std::lock_guard lock(mutex_);
        last_ = std::chrono::steady_clock::now();
        was_asked_ = true;
        return result;
    } catch (const std::exception& error) {
        return {500, text, error.what()};
    }
}

PageServer::Answer PageServer::answer(const std::string& method, const std::string& name) {
    const std::string text = "text/plain; charset=utf-8";
    const auto found = resources_.find(name);
    if (found == resources_.end()) return {404, text, "There is nothing here.\n"};
    const Resource& resource = found->second;
    if (method != resource.method) return {405, text, "Ask by " + resource.method + ".\n"};
    return {200, resource.type, resource.body()};
}

}  // namespace etalon
