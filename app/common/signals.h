#pragma once

#include <atomic>

namespace etalon {

/// During its lifetime the first SIGINT, SIGTERM or SIGHUP only sets a flag, so that results so far
/// can be written; another one, of any of these kinds, ends the program at once, unless it comes
/// within a second, as those that `timeout` sends in pairs do. A SIGHUP that was ignored
/// stays ignored.
class SignalGuard {
  public:
    SignalGuard();
    ~SignalGuard();
    SignalGuard(const SignalGuard&) = delete;
    SignalGuard& operator=(const SignalGuard&) = delete;

    static const std::atomic<bool>& raised();
    static int signal();  ///< number of the signal; 0 if there was none

    /// Acts like a first SIGINT. Thread-safe; may be called repeatedly.
    static void interrupt();

    /// Returns whether interrupt() ended the work, and no signal has come since.
    static bool is_requested();
};

}  // namespace etalon
