#include "app/common/signals.h"

#include <csignal>

namespace etalon {
namespace {

std::atomic<bool> was_raised = false, was_requested = false;
std::atomic<int> signal_number = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

/// Handled signals. A closed terminal sends SIGHUP.
constexpr int caught[] = {SIGINT, SIGTERM, SIGHUP};

void handle(int number) {
    was_requested = false;
    signal_number = number;
    was_raised = true;
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
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
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
