#include "bench/speed/pinned.h"

#include <sched.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>

#include "tests/catch.h"

using namespace etalon;
using namespace etalon::speed;

TEST_CASE("Pinned threads have a core each, and leave the caller its own") {
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

TEST_CASE("Only the work counts, in CPU seconds of all threads") {
    const auto burn = [] {
        std::atomic<std::uint64_t> sum{0};
        for (int i = 0; i < 2'000'000; ++i) sum += i;
    };
    const Duration one = run_pinned(1, burn);
    CHECK(one.cpu > 0);
    CHECK(one.cpu <= one.wall * 1.01);
    const Duration nothing = run_pinned(1, [] {});
    CHECK(nothing.cpu < one.cpu);
}

TEST_CASE("What goes wrong in a pinned thread reaches the caller") {
    CHECK_THROWS_AS(run_pinned(1, [] { throw std::runtime_error("no"); }), std::runtime_error);
}
