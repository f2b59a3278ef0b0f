#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace etalon {

/// Shows the progress of a task on standard error: on a terminal as a bar of its width, elsewhere
/// as a line every few seconds. Thread-safe.
class Progress {
  public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Updates the progress; `part` is in [0, 1].
    void update(double part);

  private:
    using Clock = std::chrono::steady_clock;
    void print(double part, Clock::time_point now);

    std::string what_;
    bool terminal_;
    std::mutex mutex_;
    Clock::time_point start_, last_;
    bool printed_ = false;
};

}  // namespace etalon
