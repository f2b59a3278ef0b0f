#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "app/live/http_abi.h"

namespace etalon {

/// What a page, or something on it, is at the moment.
struct Resource {
    std::string type;                   ///< as in Content-Type
    std::function<std::string()> body;  ///< called from several threads
    std::string method = "GET";
};

/// Serves resources to this machine alone, below a path that cannot be guessed. Requests that call
/// the machine by another name than its own are refused: a web page can make a browser send them.
class PageServer {
  public:
    /// The resources by their names; "" is the page.
    explicit PageServer(std::map<std::string, Resource> resources);
    ~PageServer();
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;

    /// Begins to serve. Returns why that failed, or nothing.
    std::string start();

    /// "http://127.0.0.1:PORT/TOKEN/"
    std::string address() const;

    /// Seconds since the last request that was answered; infinite where there was none.
    double idle_seconds() const;

  private:
    struct Answer {
        int status;
        std::string type, body;
    };

    Answer answer(const std::string& method, const std::string& host, const std::string& path);
    Answer answer(const std::string& method, const std::string& name);
    bool is_own_name(const std::string& host) const;

    std::map<std::string, Resource> resources_;
    std::string token_;
    int port_ = 0;
    const EtalonHttp* module_ = nullptr;
    void* server_ = nullptr;
    mutable std::mutex mutex_;
    std::chrono::steady_clock::time_point last_;
    bool was_asked_ = false;
};

}  // namespace etalon
