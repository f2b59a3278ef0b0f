#pragma once

#include <algorithm>
#include <chrono>

namespace etalon {

/// So many seconds on the wall, from now on. Made without a limit it never comes.
class Deadline {
  public:
    Deadline() = default;
    explicit Deadline(double seconds) : seconds_(seconds) {}

    /// In [0, 1]; always 0 without a limit.
    double part_over() const {
        if (seconds_ <= 0) return 0;
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start_;
        return std::min(gone.count() / seconds_, 1.0);
    }

    bool is_over() const { return part_over() >= 1; }

  private:
    double seconds_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace etalon
