#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

namespace etalon {

/// Pauses between polls: at most a tenth of the time since the last message, so that neither
/// waiting nor polling costs much, whether tiles take long or not.
class PollPause {
  public:
    /// Restarts with the shortest pause, after a message.
    void reset() { next_ = shortest; }

    void sleep() {
        std::this_thread::sleep_for(next_);
        next_ = std::min(longest, next_ + next_ / 10);
    }

  private:
    using Time = std::chrono::nanoseconds;
    static constexpr Time shortest = std::chrono::milliseconds(1);
    static constexpr Time longest = std::chrono::milliseconds(4);

    Time next_ = shortest;
};

}  // namespace etalon
