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

    /// Returns the seconds since a request was last being answered: 0 while one is, infinite if
    /// there was none.
    double idle_seconds() const;

  private:
    HttpAnswer answer(const HttpRequest& request);
    HttpAnswer answer(const std::string& method, const std::string& name);
    void note_making(bool is_making);

    std::map<std::string, Resource> resources_;
    std::string token_;
    mutable std::mutex mutex_;
    mutable std::chrono::steady_clock::time_point last_;  ///< when it was last known to answer
    bool was_asked_ = false, is_making_ = false;          ///< an answer
    HttpServer server_;                                   ///< declared last, so that it ends first
};

}  // namespace etalon
