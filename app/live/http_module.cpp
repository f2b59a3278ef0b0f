// The only file that includes cpp-httplib. It is a module of its own because its library brings
// OpenSSL into every program that is linked to it.
#include <httplib.h>

#include <chrono>
#include <exception>
#include <memory>
#include <string>
#include <thread>

#include "app/live/http_abi.h"

namespace {

constexpr int threads = 8;
constexpr std::size_t largest_body = 1024;
constexpr int seconds_to_read = 2;

/// Headers that disable caches, foreign content and referrers.
const httplib::Headers headers = {
    {"Cache-Control", "no-store"},
    {"Content-Security-Policy",
     "default-src 'none'; connect-src 'self'; img-src blob: data:; script-src 'unsafe-inline'; "
     "style-src "
     "'unsafe-inline'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
    {"Referrer-Policy", "no-referrer"},
    {"X-Content-Type-Options", "nosniff"}};

class Server {
  public:
    explicit Server(const EtalonHttpHandler& handler) : handler_(handler) {
        server_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
        server_.set_payload_max_length(largest_body);
        server_.set_read_timeout(seconds_to_read);
        server_.set_keep_alive_max_count(1);  // an idle connection would occupy a thread
        server_.set_default_headers(headers);
        server_.set_pre_routing_handler([this](const auto& request, auto& response) {
            answer(request, response);
            return httplib::Server::HandlerResponse::Handled;
        });
        port_ = server_.bind_to_any_port("127.0.0.1");
        if (port_ > 0) thread_ = std::thread([this] { listen(); });
    }

    ~Server() {
        using namespace std::chrono_literals;
        while (thread_.joinable() && !server_.is_running() && !is_over_) {
            std::this_thread::sleep_for(1ms);
        }
        server_.stop();
        if (thread_.joinable()) thread_.join();
    }

    int port() const { return port_; }

  private:
    void listen() {
        server_.listen_after_bind();
        is_over_ = true;
    }

    void answer(const httplib::Request& request, httplib::Response& response) const {
        const std::string host = request.get_header_value("Host");
        const EtalonHttpRequest question = {request.method.c_str(), host.c_str(),
                                            request.path.c_str()};
        const EtalonHttpReply reply = {
            &response, [](void* to, int status, const char* type, const char* body, std::size_t n) {
                auto& out = *static_cast<httplib::Response*>(to);
                out.status = status;
                out.set_content(std::string(body, n), type);
            }};
        handler_.answer(handler_.context, &question, &reply);
    }

    EtalonHttpHandler handler_;
    httplib::Server server_;
    int port_ = 0;
    std::atomic<bool> is_over_ = false;
    std::thread thread_;
};

void* start(const EtalonHttpHandler* handler, int* port) {
    try {
        auto server = std::make_unique<Server>(*handler);
        *port = server->port();
        return *port > 0 ? server.release() : nullptr;
    } catch (const std::exception&) {  // no thread, no memory
        return nullptr;
    }
}

void stop(void* server) {
    delete static_cast<Server*>(server);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const EtalonHttp* etalon_http() {
    static constexpr EtalonHttp table = {etalon_http_version, start, stop};
    return &table;
}
