// Interface between the MPI module and the rest of the program, in C types only, so that no
// exception and no type of a library crosses it. Only one thread at a time may call it. Errors are
// texts that stay valid until the next call; null if there was none.
#pragma once

#include <cstddef>

extern "C" {

/// Receives a message.
struct EtalonMpiReceiver {
    void* context;
    void (*take)(void* context, int from, const char* bytes, std::size_t size);
};

struct EtalonMpi {
    int version;  ///< etalon_mpi_version

    /// Joins the other processes.
    const char* (*join)(int* rank, int* size);

    /// Begins to send a message of at most 2^31 - 1 bytes, which is copied.
    const char* (*send)(int to, const char* bytes, std::size_t size);

    /// Returns how many messages are still to be sent.
    const char* (*count_unsent)(std::size_t* count);

    /// Receives a message, if there is one; sets `received` accordingly.
    const char* (*receive)(const EtalonMpiReceiver* receiver, int* received);

    /// Waits for the other processes, discards what they still send, and leaves them. Gives up
    /// after `patience` seconds; the process must then end without leaving.
    void (*leave)(double patience);
};

/// The module's one symbol has this type and the name etalon_mpi.
using EtalonMpiEntry = const EtalonMpi* (*)();

}  // extern "C"

inline constexpr int etalon_mpi_version = 1;
