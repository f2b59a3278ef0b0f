#include "bench/speed/pinned.h"

#include <sched.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>

#include "tests/catch.h"

using namespace etalon;
using namespace etalon::speed;

namespace {

std::atomic<int> ticks = 0;
thread_local int work_done = 0;

/// A wall clock that ticks whenever it is read, and one of each thread that its work moves.
const Clocks fake_clocks{[] { return double(++ticks); }, [] { return double(work_done); }};

}  // namespace

TEST_CASE("Pinned threads have a core each, and leave the caller its own", "[needs_two_cores]") {
    SKIP_UNLESS(usable_cores() >= 2, "a single core");
    cpu_set_t before, after;
    sched_getaffinity(0, sizeof before, &before);
    std::mutex mutex;
    std::set<int> cores;
    int with_one_core = 0;
    run_pinned(usable_cores(), [&] {
        cpu_set_t mine;
        sched_getaffinity(0, sizeof mine, &mine);
        const std::lock_guard lock(mutex);
        with_one_core += CPU_COUNT(&mine) == 1;
        cores.insert(sched_getcpu());
    });
    CHECK(with_one_core == usable_cores());
    CHECK(static_cast<int>(cores.size()) == usable_cores());
    sched_getaffinity(0, sizeof after, &after);
    CHECK(CPU_EQUAL(&before, &after));
}

TEST_CASE("Only the work counts") {
    const Duration d = run_pinned(
        1,
        [] {
            work_done += 3;
            ticks += 10;
        },
        fake_clocks);
    CHECK(d.cpu == 3);
    CHECK(d.wall == 11);
    const Duration nothing = run_pinned(
        1, [] {}, fake_clocks);
    CHECK(nothing.cpu == 0);
    CHECK(nothing.wall == 1);
}

TEST_CASE("CPU seconds are of all threads, wall seconds from the first begin to the last end",
          "[needs_two_cores]") {
    SKIP_UNLESS(usable_cores() >= 2, "a single core");
    const Duration d = run_pinned(
        2, [] { work_done += 3; }, fake_clocks);
    CHECK(d.cpu == 6);
    CHECK(d.wall == 3);  // two begin, two end: whatever their order, the clock ticks thrice between
}

TEST_CASE("What goes wrong in a pinned thread reaches the caller") {
    CHECK_THROWS_AS(run_pinned(1, [] { throw std::runtime_error("no"); }), std::runtime_error);
}
