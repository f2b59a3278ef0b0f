// The one place where work is given to threads. They are oneTBB's, which Embree uses, too. Results
// never depend on how work was split: callers write to disjoint places, or combine with an
// operation that gives the same bits in any order.
#pragma once

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <cstddef>

#include "core/parallel/float_environment.h"

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace etalon {

/// Tells ThreadSanitizer what oneTBB's uninstrumented library guarantees: writes before a hand-over
/// are visible after it.
class HandOver {
  public:
#if defined(__SANITIZE_THREAD__)
    void give() {
        __tsan_release(this);
    }
    void take() {
        __tsan_acquire(this);
    }
#else
    void give() {}
    void take() {}
#endif
};

/// Limits the threads of everything below it in scope; 0 sets no limit.
class ThreadLimit {
  public:
    explicit ThreadLimit(int threads)
        : control_(
              tbb::global_control::max_allowed_parallelism,
              threads > 0 ? static_cast<std::size_t>(threads) : tbb::info::default_concurrency()) {}

  private:
    tbb::global_control control_;
};

/// Returns the number of threads that may work now.
inline int max_threads() {
    return static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

/// Calls body(begin, end) for ranges of at least `grain` that together make up [0, count).
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    HandOver begin, end;
    begin.give();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
        begin.take();
        const DefaultFloatEnvironment floats;
        body(range.begin(), range.end());
        end.give();
    });
    end.take();
}

/// Calls both, possibly in parallel, and returns when both have returned.
template <class F, class G>
void parallel_invoke(const F& f, const G& g) {
    HandOver begin, end;
    begin.give();
    const auto handed = [&](const auto& work) {
        return [&] {
            begin.take();
            const DefaultFloatEnvironment floats;
            work();
            end.give();
        };
    };
    tbb::parallel_invoke(handed(f), handed(g));
    end.take();
}

}  // namespace etalon
