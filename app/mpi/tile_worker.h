#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "app/mpi/ranks.h"
#include "core/render/tile_dealer.h"

namespace etalon {

/// Renders the tiles that rank 0 deals to this rank.
class TileWorker {
  public:
    /// `find_error` returns why the tiles rendered so far cannot be used, or an empty string; it is
    /// called by several threads.
    TileWorker(Ranks& ranks, std::function<std::string()> find_error)
        : ranks_(ranks), find_error_(std::move(find_error)) {}

    /// Renders tiles of the image of this identity, on all threads, until rank 0 ends the work.
    void run(const TileTask& task, const nlohmann::ordered_json& identity);

  private:
    /// A tile's number and its bytes.
    using Tile = std::pair<std::size_t, std::string>;

    void render_tiles(const TileTask& task);
    std::optional<Tile> next();
    std::string render(const Tile& tile, const TileTask& task) const;
    bool look();
    void handle(std::string_view message);
    void send_results();
    void fail(const std::string& why);

    Ranks& ranks_;
    std::function<std::string()> find_error_;
    std::mutex mutex_;  ///< protects all below
    std::condition_variable is_changed_;
    std::deque<Tile> tasks_, results_;
    std::string failure_;  ///< to be sent to rank 0
    std::atomic<bool> is_over_ = false;
};

}  // namespace etalon
