// Interface of the MPI module to the rest of the program: C types only, so that no exception and no
// type of a library crosses it. One thread at a time calls it. Errors are texts that stay valid
// until the next call; null: there was none.
#pragma once

#include <cstddef>

extern "C" {

/// Takes a message.
struct EtalonMpiReceiver {
    void* context;
    void (*take)(void* context, int from, const char* bytes, std::size_t size);
};

struct EtalonMpi {
    int version;  ///< etalon_mpi_version

    /// Joins the other processes.
    const char* (*join)(int* rank, int* size);

    /// Begins to send a message of at most 2^31 - 1 bytes, of which it keeps a copy.
    const char* (*send)(int to, const char* bytes, std::size_t size);

    /// Tells how many messages are still to be sent.
    const char* (*count_unsent)(std::size_t* count);

    /// Receives a message, if there is one; `received` says whether.
    const char* (*receive)(const EtalonMpiReceiver* receiver, int* received);

    /// Waits for the other processes, drops what they still send, and leaves them. Gives up after
    /// `patience` seconds; the process must then end without it.
    void (*leave)(double patience);
};

/// The module's one symbol has this type and the name etalon_mpi.
using EtalonMpiEntry = const EtalonMpi* (*)();

}  // extern "C"

inline constexpr int etalon_mpi_version = 1;
