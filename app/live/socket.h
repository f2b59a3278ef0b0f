#pragma once

#include <unistd.h>

#include <utility>

namespace etalon {

/// A socket, or another of the system's descriptors, closed at the end.
class Socket {
  public:
    Socket() = default;
    explicit Socket(int number) : number_(number) {}  ///< -1: none
    ~Socket() {
        if (number_ >= 0) ::close(number_);
    }
    Socket(Socket&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Socket& operator=(Socket&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }

    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

  private:
    int number_ = -1;
};

}  // namespace etalon
