#pragma once

#include <atomic>

namespace etalon {

/// During its lifetime the first SIGINT, SIGTERM or SIGHUP only sets a flag, so that results so far
/// can be written; a second one ends the program at once. A SIGHUP that was ignored stays ignored.
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
