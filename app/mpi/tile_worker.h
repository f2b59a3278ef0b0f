#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/mpi/ranks.h"
#include "core/render/tile_dealer.h"

namespace etalon {

/// Renders the tiles that rank 0 deals to this rank.
class TileWorker {
  public:
    /// `find_problems` returns why images were replaced in the tiles rendered so far; it is called
    /// by several threads. Tiles cannot be used if it was for lack of memory.
    TileWorker(Ranks& ranks, std::function<std::vector<std::string>()> find_problems)
        : ranks_(ranks), find_problems_(std::move(find_problems)) {}

    /// Renders tiles of the image of this identity, on all threads, until rank 0 ends the work.
    void run(const TileTask& task, const nlohmann::ordered_json& identity);

  private:
    /// A tile's number and its bytes.
    using Tile = std::pair<std::size_t, std::string>;

    void render_tiles(const TileTask& task);
    std::optional<Tile> next();
    std::string render(const Tile& tile, const TileTask& task) const;
    void add(std::size_t tile, std::string result, const std::vector<std::string>& problems);
    bool look();
    void handle(std::string_view message);
    void send_results();
    void heed_signal();
    void fail(const std::string& why);

    Ranks& ranks_;
    std::function<std::vector<std::string>()> find_problems_;
    std::mutex mutex_;  ///< protects all below
    std::condition_variable is_changed_;
    std::deque<Tile> tasks_, results_;
    std::vector<std::string> problems_;  ///< all that were found
    std::size_t sent_problems_ = 0;
    std::string failure_;                                             ///< to be sent to rank 0
    std::optional<std::chrono::steady_clock::time_point> signalled_;  ///< when a signal was seen
    std::atomic<bool> is_over_ = false;
};

}  // namespace etalon
