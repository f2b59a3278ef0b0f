// A listener for tev's network protocol, written only from its documentation: the README of
// Tom94/tev, and the order in which its Ipc.cpp reads each message. It shares no code with the
// sender.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace etalon::test {

/// An image as a viewer would show it.
struct ViewedImage {
    int width = 0, height = 0;
    std::map<std::string, std::vector<float>> channels;  ///< by rows
    int updates = 0;
};

/// Listens on a port of 127.0.0.1 that the system chooses, for one connection.
class TevListener {
  public:
    /// Behaviour of a viewer.
    enum class Manner { read_all, close_after_some, read_nothing };

    explicit TevListener(Manner manner = Manner::read_all);
    ~TevListener();
    TevListener(const TevListener&) = delete;
    TevListener& operator=(const TevListener&) = delete;

    std::string address() const;

    /// Returns the images by their names, once the sender has closed the connection. Throws if a
    /// message does not follow the protocol.
    std::map<std::string, ViewedImage> images();

  private:
    void run(Manner manner);

    int listener_, port_;
    std::map<std::string, ViewedImage> images_;
    std::string error_;
    std::atomic<bool> is_over_ = false;
    std::thread thread_;
};

}  // namespace etalon::test
