#pragma once

#include <chrono>

#include "core/base/clocks.h"

namespace etalon {

/// Seconds of wall clock time, and of processor time of all threads together.
struct Duration {
    double wall = 0, cpu = 0;
};

class Stopwatch {
  public:
    /// Returns the time since construction or the last lap.
    Duration lap() {
        const Stopwatch now;
        const Duration d{std::chrono::duration<double>(now.wall_ - wall_).count(), now.cpu_ - cpu_};
        *this = now;
        return d;
    }

  private:
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
    double cpu_ = process_cpu_seconds();
};

}  // namespace etalon
