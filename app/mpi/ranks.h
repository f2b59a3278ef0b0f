#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "app/common/started_rank.h"
#include "app/mpi/mpi_abi.h"

namespace etalon {

/// Numbers of messages and bytes that a process has sent and received.
struct Traffic {
    std::uint64_t messages_sent = 0, bytes_sent = 0, messages_received = 0, bytes_received = 0;
};

/// The processes that an MPI launcher started together, and this one's rank among them. MPI is
/// loaded only if there are others. Only one thread at a time may call the members that send or
/// receive.
class Ranks {
  public:
    Ranks() = default;
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    /// Joins the other processes. Returns why that failed, or an empty string.
    std::string join();

    int rank() const { return rank_; }
    int size() const { return size_; }  ///< 1 if there are no others

    /// Begins to send a message.
    void send(int to, std::string_view message);

    /// Waits until at most `most` messages are still to be sent.
    void wait_until_unsent(std::size_t most);

    /// Passes a message to `take`, if one has arrived. Returns whether it did.
    bool receive(const std::function<void(int from, std::string_view message)>& take);

    /// Returns why a message could not be sent or received, or an empty string.
    const std::string& error() const { return error_; }

    const Traffic& traffic() const { return traffic_; }

    /// Waits for the others to leave, too, at most `patience` seconds. What they still send is
    /// lost.
    void leave(double patience);

  private:
    std::string check(const StartedRank& started) const;
    void note_error(const char* error);

    const EtalonMpi* module_ = nullptr;
    int rank_ = 0, size_ = 1;
    std::string error_;
    Traffic traffic_;
};

}  // namespace etalon
