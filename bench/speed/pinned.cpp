#include "bench/speed/pinned.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

#include "core/base/clocks.h"

namespace etalon::speed {
namespace {

std::vector<int> cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    sched_getaffinity(0, sizeof set, &set);
    std::vector<int> numbers;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(core, &set)) numbers.push_back(core);
    }
    return numbers;
}

void pin_to(int core) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(core, &set);
    const int error = pthread_setaffinity_np(pthread_self(), sizeof set, &set);
    if (error != 0) throw std::system_error(error, std::generic_category(), "pinning a thread");
}

/// Spinning barrier for threads: waking a sleeping thread takes as long as a thousand rays.
class SpinBarrier {
  public:
    explicit SpinBarrier(int threads) : missing_(threads) {}

    /// Returns whether all threads arrived: not if one of them cannot come.
    bool arrive_and_wait() {
        --missing_;
        while (missing_ > 0) {
            if (is_given_up_) return false;
        }
        return true;
    }

    /// Lets the threads that wait for others go.
    void give_up() { is_given_up_ = true; }

  private:
    std::atomic<int> missing_;
    std::atomic<bool> is_given_up_ = false;
};

/// Times of one thread's share of the work.
struct ThreadRun {
    double begin = 0, end = 0, cpu = 0;
    std::exception_ptr failure;

    /// Keeps the first exception, so that all threads still reach the barrier.
    template <class F>
    void attempt(const F& f) {
        if (failure) return;
        try {
            f();
        } catch (...) {
            failure = std::current_exception();
        }
    }

    void measure(const std::function<void()>& work, const Clocks& clocks) {
        begin = clocks.wall();
        const double start = clocks.thread_cpu();
        work();
        cpu = clocks.thread_cpu() - start;
        end = clocks.wall();
    }
};

Duration total(const std::vector<ThreadRun>& runs) {
    double begin = runs.front().begin, end = runs.front().end, cpu = 0;
    for (const ThreadRun& s : runs) {
        if (s.failure) std::rethrow_exception(s.failure);
        begin = std::min(begin, s.begin);
        end = std::max(end, s.end);
        cpu += s.cpu;
    }
    return {end - begin, cpu};
}

}  // namespace

int usable_cores() {
    return static_cast<int>(cores().size());
}

const Clocks system_clocks{wall_seconds, thread_cpu_seconds};

Duration run_pinned(int threads, const std::function<void()>& work, const Clocks& clocks) {
    const std::vector<int> core_ids = cores();
    std::vector<ThreadRun> runs(static_cast<std::size_t>(threads));
    SpinBarrier barrier(threads);
    std::vector<std::jthread> pinned_threads;
    const auto run_one = [&](std::size_t k) {
        ThreadRun& run = runs[k];
        run.attempt([&] { pin_to(core_ids.at(k)); });
        if (barrier.arrive_and_wait()) run.attempt([&] { run.measure(work, clocks); });
    };
    try {
        for (std::size_t k = 0; k < runs.size(); ++k) pinned_threads.emplace_back(run_one, k);
    } catch (...) {  // the system starts no more
        barrier.give_up();
        throw;
    }
    pinned_threads.clear();  // joins
    return total(runs);
}

}  // namespace etalon::speed
