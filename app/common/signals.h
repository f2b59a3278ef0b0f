#pragma once

#include <atomic>

namespace etalon {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP only sets a flag, so that what there is can
/// be written; a second one ends the program at once. A SIGHUP that was ignored stays ignored.
class SignalGuard {
  public:
    SignalGuard();
    ~SignalGuard();
    SignalGuard(const SignalGuard&) = delete;
    SignalGuard& operator=(const SignalGuard&) = delete;

    const std::atomic<bool>& raised() const;
    int signal() const;  ///< its number; 0 if there was none

    /// Does what a first SIGINT does. From any thread, any number of times.
    static void interrupt();
};

}  // namespace etalon
