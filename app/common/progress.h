#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace etalon {

/// Says on standard error how far a task is: a bar as wide as the terminal, a line every few
/// seconds elsewhere. May be called from any thread.
class Progress {
  public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `part` in [0, 1].
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
