// Clocks, all in seconds since a fixed moment.
#pragma once

#include <chrono>
#include <ctime>

namespace etalon {

/// Returns the time of a clock of the system.
inline double seconds_of(clockid_t clock) {
    timespec t = {};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Returns the wall clock time. It never goes back.
inline double wall_seconds() {
    using Seconds = std::chrono::duration<double>;
    return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns the processor time of all threads of this process.
inline double process_cpu_seconds() {
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

/// Returns the processor time of the calling thread.
inline double thread_cpu_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace etalon
