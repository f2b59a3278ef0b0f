// Threads that stay on their cores while they are timed.
#pragma once

#include <functional>

#include "app/stopwatch.h"

namespace etalon::speed {

/// How many cores this process may use, and so how many threads can have one each.
int usable_cores();

/// Runs `work` on so many threads at the same time, each pinned to a core of its own. Wall seconds
/// are from the first that begins to the last that ends, CPU seconds those of the threads together.
/// What `work` throws is thrown here.
Duration run_pinned(int threads, const std::function<void()>& work);

}  // namespace etalon::speed
