#include "app/common/signals.h"

#include <csignal>

namespace etalon {
namespace {

std::atomic<bool> was_raised = false;
std::atomic<int> signal_number = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void handle(int number) {
    signal_number = number;
    was_raised = true;
}

}  // namespace

SignalGuard::SignalGuard() {
    struct sigaction action = {};
    action.sa_handler = handle;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

SignalGuard::~SignalGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& SignalGuard::raised() const {
    return was_raised;
}

int SignalGuard::signal() const {
    return signal_number;
}

}  // namespace etalon
