#include "app/mpi/ranks.h"

#include <fmt/format.h>

#include "app/mpi/poll_pause.h"
#include "core/base/module_symbol.h"

namespace etalon {

std::string Ranks::join() {
    const StartedRank started = started_rank();
    if (started.size == 1) return {};
    const Result<void*> symbol = module_symbol("etalon_mpi.so", "etalon_mpi");
    if (!symbol) {
        return fmt::format(
            "was started as a process of several by MPI, but built or installed without MPI; "
            "expected a build with Open MPI (libopenmpi-dev), or one process: {}",
            symbol.error);
    }
    module_ = reinterpret_cast<EtalonMpiEntry>(symbol.value)();
    if (module_->version != etalon_mpi_version) {
        return "etalon_mpi.so belongs to another version of the program";
    }
    if (const char* const error = module_->join(&rank_, &size_)) {
        return fmt::format("cannot join the processes of MPI: {}", error);
    }
    return check(started);
}

/// Returns why these are not the processes that the launcher started, or an empty string. An MPI
/// that does not understand the launcher leaves each process alone, and each would render the whole
/// image.
std::string Ranks::check(const StartedRank& started) const {
    const bool is_alone = size_ == 1 && started.size > 1;
    if (rank_ == started.rank && !is_alone) return {};
    return fmt::format(
        "is process {} of {} to its launcher, {} of {} to its MPI; expected the launcher of the "
        "MPI that it was built with, mpirun of Open MPI or srun --mpi=pmix",
        started.rank + 1, started.size, rank_ + 1, size_);
}

void Ranks::send(int to, std::string_view message) {
    ++traffic_.messages_sent;
    traffic_.bytes_sent += message.size();
    note_error(module_->send(to, message.data(), message.size()));
}

void Ranks::wait_until_unsent(std::size_t most) {
    PollPause pause;
    while (error_.empty()) {
        std::size_t unsent = 0;
        note_error(module_->count_unsent(&unsent));
        if (unsent <= most) return;
        pause.sleep();
    }
}

bool Ranks::receive(const std::function<void(int, std::string_view)>& take) {
    struct Context {
        Traffic& traffic;
        const std::function<void(int, std::string_view)>& take;
    } context{traffic_, take};
    const EtalonMpiReceiver receiver = {
        &context, [](void* to, int from, const char* bytes, std::size_t size) {
            Context& c = *static_cast<Context*>(to);
            ++c.traffic.messages_received;
            c.traffic.bytes_received += size;
            c.take(from, {bytes, size});
        }};
    int received = 0;
    note_error(module_->receive(&receiver, &received));
    return received != 0;
}

void Ranks::note_error(const char* error) {
    if (error && error_.empty()) error_ = error;
}

void Ranks::leave(double patience) {
    if (module_) module_->leave(patience);
    module_ = nullptr;
}

}  // namespace etalon
