#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "app/live/http_server.h"

namespace etalon {

/// A resource of a page: the page itself or something on it.
struct Resource {
    std::string type;                   ///< as in Content-Type
    std::function<std::string()> body;  ///< called from the server's thread
    std::string method = "GET";
};

/// Serves resources only to this machine, below a path that cannot be guessed. Requests that use
/// another name of the machine are refused, as a web page can make a browser send them (DNS
/// rebinding).
class PageServer {
  public:
    /// `resources` are by name; "" is the page.
    explicit PageServer(std::map<std::string, Resource> resources);

    /// Starts to serve. Returns why that failed, or an empty string.
    std::string start();

    /// Returns "http://127.0.0.1:PORT/TOKEN/".
    std::string address() const;

    /// Returns the seconds since the last answered request; infinite if there was none.
    double idle_seconds() const;

  private:
    HttpAnswer answer(const HttpRequest& request);
    HttpAnswer answer(const std::string& method, const std::string& name);

    std::map<std::string, Resource> resources_;
    std::string token_;
    mutable std::mutex mutex_;
    std::chrono::steady_clock::time_point last_;
    bool was_asked_ = false;
    HttpServer server_;  ///< declared last, so that it ends first
};

}  // namespace etalon
