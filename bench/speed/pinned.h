// Threads pinned to cores for timing.
#pragma once

#include <functional>

#include "app/common/stopwatch.h"

namespace etalon::speed {

/// Returns the number of cores that this process may use, one for each thread.
int usable_cores();

/// Clocks in seconds since any fixed moment.
struct Clocks {
    double (*wall)();        ///< the same for all threads
    double (*thread_cpu)();  ///< processor time of the calling thread
};

/// The clocks of the operating system.
extern const Clocks system_clocks;

/// Runs `work` on so many threads at the same time, each pinned to a core of its own. Wall seconds
/// are from the first start to the last end, CPU seconds are the sum over the threads. Exceptions
/// of `work` are passed on.
Duration run_pinned(int threads, const std::function<void()>& work,
                    const Clocks& clocks = system_clocks);

}  // namespace etalon::speed
