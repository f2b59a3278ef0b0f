#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "app/mpi/mpi_abi.h"

namespace etalon {

/// What a process has sent and received.
struct Traffic {
    std::uint64_t messages_sent = 0, bytes_sent = 0, messages_received = 0, bytes_received = 0;
};

/// The processes that an MPI launcher started together, and this one's place among them. MPI is
/// loaded only where there are others. One thread at a time calls the members that send or receive.
class Ranks {
  public:
    Ranks() = default;
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    /// Joins the other processes. Returns why that failed, or nothing.
    std::string join();

    int rank() const { return rank_; }
    int size() const { return size_; }  ///< 1: there are no others

    /// Begins to send a message.
    void send(int to, std::string_view message);

    /// Waits until no more than so many messages are still to be sent.
    void wait_until_unsent(std::size_t most);

    /// Gives a message to `take`, if one has come. Returns whether.
    bool receive(const std::function<void(int from, std::string_view message)>& take);

    /// Why a message could not be sent or received, or nothing.
    const std::string& error() const { return error_; }

    const Traffic& traffic() const { return traffic_; }

    /// Waits for the others to leave, too, at most so many seconds. What they still send is lost.
    void leave(double patience);

  private:
    void note_error(const char* error);

    const EtalonMpi* module_ = nullptr;
    int rank_ = 0, size_ = 1;
    std::string error_;
    Traffic traffic_;
};

}  // namespace etalon
