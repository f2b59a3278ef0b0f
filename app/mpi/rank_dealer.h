#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/mpi/polling_thread.h"
#include "app/mpi/ranks.h"
#include "core/render/tile_dealer.h"

namespace etalon {

/// Deals tiles to the threads of this process, rank 0, and to the other ranks. Each rank has some
/// tiles in advance, fewer towards the end of a pass, so that it need not wait for messages. When a
/// pass is interrupted, for a checkpoint, they keep them: the film has these tiles as they were.
class RankDealer : public TileDealer {
  public:
    explicit RankDealer(Ranks& ranks) : ranks_(ranks), workers_(ranks.size()) {}

    /// Tells the other ranks that there is no more work.
    ~RankDealer() override;

    /// Starts to listen to the other ranks, which must render an image of this identity.
    void listen(const nlohmann::ordered_json& identity);

    void deal(const DealtPass& pass) override;
    bool has_failed() const override { return has_failed_; }

    /// Returns why rendering had to stop, or an empty string.
    std::string error() const;

    /// Returns why other ranks have replaced images.
    std::vector<std::string> problems() const;

    /// Returns the numbers of processes and messages, for --stats.
    nlohmann::ordered_json stats() const;

  private:
    /// State of a rank; for rank 0 itself only the tiles.
    struct Worker {
        std::size_t threads = 0;  ///< 0 if it is not ready yet
        std::size_t dealt = 0;    ///< number of its tiles that are not back
        std::size_t rendered = 0;
    };

    void begin(const DealtPass& pass);
    void wait_for_results(const DealtPass& pass);
    std::optional<std::size_t> take();
    bool look();
    void handle(int from, std::string_view message);
    void note_ready(int from, std::string_view content);
    void read_results(int from, std::string_view content);
    void supply(int rank);
    std::size_t most_of(const Worker& worker) const;
    void fail(const std::string& why);

    Ranks& ranks_;
    nlohmann::ordered_json identity_;
    mutable std::mutex mutex_;  ///< protects all below except atomics
    std::condition_variable has_results_;
    const DealtPass* pass_ = nullptr;  ///< null between passes, when no message is read either
    std::vector<std::size_t> tiles_;   ///< tiles of the pass that no other rank has from before
    std::set<std::size_t> lent_;       ///< tiles that other ranks have
    bool is_new_ = false;              ///< no tile of the pass has been dealt
    std::size_t all_threads_ = 0;
    std::vector<Worker> workers_;  ///< by rank
    std::string error_;
    std::vector<std::string> problems_;
    std::atomic<std::size_t> next_ = 0;  ///< index of the next tile of the pass
    std::atomic<std::size_t> rendered_here_ = 0;
    std::atomic<bool> has_failed_ = false;
    std::optional<PollingThread> listener_;
};

}  // namespace etalon
