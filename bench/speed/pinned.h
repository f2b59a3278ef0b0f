// Threads that stay on their cores while they are timed.
#pragma once

#include <functional>

#include "app/common/stopwatch.h"

namespace etalon::speed {

/// Number of cores this process may use, and so of threads that can have one each.
int usable_cores();

/// Clocks in seconds; the moment they count from does not matter.
struct Clocks {
    double (*wall)();        ///< the same for all threads
    double (*thread_cpu)();  ///< processor time of the thread that asks
};

/// The clocks of the operating system.
extern const Clocks system_clocks;

/// Runs `work` on so many threads at the same time, each pinned to a core of its own. Wall seconds
/// are from the first that begins to the last that ends, CPU seconds those of the threads together.
/// Exceptions of `work` are passed on.
Duration run_pinned(int threads, const std::function<void()>& work,
                    const Clocks& clocks = system_clocks);

}  // namespace etalon::speed
