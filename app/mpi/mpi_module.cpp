// The only file that includes MPI. It is a module of its own, since MPI's libraries would be loaded
// with every program that is linked to them. All waiting is by polling, with sleep in between:
// where ranks share processors, a library that spins takes one from a rank that renders.
#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <list>
#include <optional>
#include <set>
#include <string>

#include "app/mpi/mpi_abi.h"
#include "app/mpi/poll_pause.h"

namespace {

/// A message in transit, out or in. A process that died may leave it there for ever.
struct Transfer {
    std::string bytes;
    int peer = 0;
    MPI_Request request = MPI_REQUEST_NULL;
};

std::list<Transfer> sendings, receivings;
std::string error_text;

/// Returns the text of MPI's error, null for none.
const char* error_of(int code) {
    if (code == MPI_SUCCESS) return nullptr;
    char text[MPI_MAX_ERROR_STRING];
    int size = 0;
    if (MPI_Error_string(code, text, &size) != MPI_SUCCESS) return "unknown MPI error";
    error_text.assign(text, static_cast<std::size_t>(size));
    return error_text.c_str();
}

/// Calls a function that returns an error; exceptions become errors, too.
template <class Call>
const char* guarded(const Call& call) {
    try {
        return call();
    } catch (const std::exception&) {
        return "not enough memory for a message";
    }
}

const char* join(int* rank, int* size) {
    // Both ends copy messages: Open MPI would end a receiver that reads the memory of a dead
    // sender, which then could not save its state.
    setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 0);
    int provided = 0;
    int code = MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    if (code != MPI_SUCCESS) return error_of(code);
    if (provided < MPI_THREAD_SERIALIZED) return "this MPI cannot be called from several threads";
    code = MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    if (code == MPI_SUCCESS) code = MPI_Comm_rank(MPI_COMM_WORLD, rank);
    if (code == MPI_SUCCESS) code = MPI_Comm_size(MPI_COMM_WORLD, size);
    return error_of(code);
}

/// Removes a complete transfer from the list and returns it; nothing if none is. Those of one peer
/// keep their order.
int take_complete(std::list<Transfer>& transfers, std::optional<Transfer>& taken) {
    std::set<int> waiting;  // peers of transfers that are not complete
    for (auto i = transfers.begin(); i != transfers.end(); ++i) {
        if (waiting.contains(i->peer)) continue;
        int is_complete = 0;
        const int code = MPI_Test(&i->request, &is_complete, MPI_STATUS_IGNORE);
        if (code != MPI_SUCCESS) return code;
        if (is_complete) {
            taken = std::move(*i);
            transfers.erase(i);
            break;
        }
        waiting.insert(i->peer);
    }
    return MPI_SUCCESS;
}

/// Removes the messages that have been sent.
int forget_sent() {
    std::optional<Transfer> sent;
    int code = MPI_SUCCESS;
    do {
        sent.reset();
        code = take_complete(sendings, sent);
    } while (code == MPI_SUCCESS && sent);
    return code;
}

const char* send(int to, const char* bytes, std::size_t size) {
    return guarded([&] {
        Transfer& sending = sendings.emplace_back();
        sending.bytes.assign(bytes, size);
        sending.peer = to;
        return error_of(MPI_Isend(sending.bytes.data(), static_cast<int>(size), MPI_BYTE, to, 0,
                                  MPI_COMM_WORLD, &sending.request));
    });
}

/// Begins to receive a message, if one is announced.
int begin_to_receive() {
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status;
    int is_announced = 0, size = 0;
    int code = MPI_Improbe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &is_announced, &message, &status);
    if (code == MPI_SUCCESS && is_announced) code = MPI_Get_count(&status, MPI_BYTE, &size);
    if (code != MPI_SUCCESS || !is_announced) return code;
    Transfer& receiving = receivings.emplace_back();
    receiving.bytes.resize(static_cast<std::size_t>(size));
    receiving.peer = status.MPI_SOURCE;
    return MPI_Imrecv(receiving.bytes.data(), size, MPI_BYTE, &message, &receiving.request);
}

const char* count_unsent(std::size_t* count) {
    const int code = forget_sent();
    *count = sendings.size();
    return error_of(code);
}

const char* receive(const EtalonMpiReceiver* receiver, int* received) {
    *received = 0;
    return guarded([&] {
        std::optional<Transfer> message;
        int code = forget_sent();
        if (code == MPI_SUCCESS) code = begin_to_receive();
        if (code == MPI_SUCCESS) code = take_complete(receivings, message);
        if (code == MPI_SUCCESS && message) {
            *received = 1;
            receiver->take(receiver->context, message->peer, message->bytes.data(),
                           message->bytes.size());
        }
        return error_of(code);
    });
}

/// Returns whether all processes have arrived here and have sent all messages. To be called until
/// then; `barrier` is null at first.
bool all_have_come(MPI_Request& barrier, bool& has_begun) {
    const EtalonMpiReceiver dropped = {nullptr, [](void*, int, const char*, std::size_t) {}};
    int received = 0, is_complete = 0;
    do {
        if (receive(&dropped, &received)) return false;
    } while (received);
    if (!sendings.empty() || !receivings.empty()) return false;
    if (!has_begun) has_begun = MPI_Ibarrier(MPI_COMM_WORLD, &barrier) == MPI_SUCCESS;
    return has_begun && MPI_Test(&barrier, &is_complete, MPI_STATUS_IGNORE) == MPI_SUCCESS &&
           is_complete;
}

void leave(double patience) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    MPI_Request barrier = MPI_REQUEST_NULL;
    bool has_begun = false;
    etalon::PollPause pause;
    while (!all_have_come(barrier, has_begun)) {
        if (std::chrono::duration<double>(Clock::now() - start).count() > patience) return;
        pause.sleep();
    }
    MPI_Finalize();
}

constexpr EtalonMpi module = {etalon_mpi_version, join, send, count_unsent, receive, leave};

}  // namespace

extern "C" __attribute__((visibility("default"))) const EtalonMpi* etalon_mpi() {
    return &module;
}
