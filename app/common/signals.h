#pragma once

#include <atomic>

namespace etalon {

/// While it lives, the first SIGINT or SIGTERM only sets a flag, so that what there is can be
/// written; a second one ends the program at once.
class SignalGuard {
  public:
    SignalGuard();
    ~SignalGuard();
    SignalGuard(const SignalGuard&) = delete;
    SignalGuard& operator=(const SignalGuard&) = delete;

    const std::atomic<bool>& raised() const;
    int signal() const;  ///< its number; 0 if there was none
};

}  // namespace etalon
