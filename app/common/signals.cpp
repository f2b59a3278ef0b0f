#include "app/common/signals.h"

#include <time.h>

#include <csignal>
#include <cstdint>

namespace etalon {
namespace {

std::atomic<bool> was_raised = false, was_requested = false;
std::atomic<int> signal_number = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

/// Handled signals. A closed terminal sends SIGHUP.
constexpr int caught[] = {SIGINT, SIGTERM, SIGHUP};

/// Milliseconds after a signal in which others are the same request: `timeout` sends it to the
/// program and then to its group, which has the program in it.
constexpr std::int64_t same_request = 1000;

/// Milliseconds since any fixed moment, of the first signal; 0 if there was none.
std::atomic<std::int64_t> first_signal = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t milliseconds() {
    timespec time = {};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1000 * static_cast<std::int64_t>(time.tv_sec) + time.tv_nsec / 1'000'000 + 1;
}

void handle(int number) {
    const std::int64_t now = milliseconds();
    std::int64_t first = 0;
    if (first_signal.compare_exchange_strong(first, now)) {
        was_requested = false;
        signal_number = number;
        was_raised = true;
    } else if (now - first > same_request) {
        std::signal(number, SIG_DFL);
        std::raise(number);  // ends the program when this returns
    }
}

/// Returns the current action of a signal.
auto disposition(int number) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    return action.sa_handler;
}

/// Returns whether the program was started to outlive its terminal, as by nohup.
bool outlives(int number) {
    return number == SIGHUP && disposition(number) == SIG_IGN;
}

}  // namespace

SignalGuard::SignalGuard() {
    struct sigaction action = {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART;
    // Of several that wait, the last would otherwise interrupt the first before it is noted.
    for (const int number : caught) sigaddset(&action.sa_mask, number);
    for (const int number : caught) {
        if (!outlives(number)) sigaction(number, &action, nullptr);
    }
}

SignalGuard::~SignalGuard() {
    for (const int number : caught) {
        if (disposition(number) == handle) std::signal(number, SIG_DFL);
    }
}

const std::atomic<bool>& SignalGuard::raised() {
    return was_raised;
}

void SignalGuard::interrupt() {
    if (was_raised) return;
    was_requested = true;
    signal_number = SIGINT;
    was_raised = true;
}

bool SignalGuard::is_requested() {
    return was_requested;
}

int SignalGuard::signal() {
    return signal_number;
}

}  // namespace etalon
