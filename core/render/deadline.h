#pragma once

#include <algorithm>

#include "core/base/clocks.h"

namespace etalon {

/// A limit in seconds of wall clock time, from its construction. Without a limit it never expires.
class Deadline {
  public:
    using Clock = double (*)();  ///< seconds since any fixed moment; thread-safe

    Deadline() = default;
    explicit Deadline(double seconds, Clock clock = wall_seconds)
        : seconds_(seconds), clock_(clock), start_(clock()) {}

    /// Returns the fraction of the time that has passed, in [0, 1]; always 0 without a limit.
    double elapsed_fraction() const {
        if (!is_limited()) return 0;
        return std::min((clock_() - start_) / seconds_, 1.0);
    }

    bool is_limited() const { return seconds_ > 0; }

    bool is_over() const { return elapsed_fraction() >= 1; }

  private:
    double seconds_ = 0;
    Clock clock_ = wall_seconds;
    double start_ = 0;
};

}  // namespace etalon
