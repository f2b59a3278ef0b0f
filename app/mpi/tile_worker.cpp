#include "app/mpi/tile_worker.h"

#include <algorithm>

#include "app/common/signals.h"
#include "app/mpi/polling_thread.h"
#include "app/mpi/tile_message.h"
#include "core/image/lack_of_memory.h"
#include "core/parallel/all_threads.h"

namespace etalon {
namespace {

/// Time that rank 0 has after a signal to end the work: half of what Open MPI gives this rank.
constexpr auto patience_after_signal = std::chrono::milliseconds(500);

}  // namespace

void TileWorker::run(const TileTask& task, const nlohmann::ordered_json& identity) {
    const auto threads = static_cast<std::uint64_t>(max_threads());
    std::string ready = message_of(MessageKind::ready);
    writer_to(ready)(threads);
    ranks_.send(0, ready + identity.dump());
    const PollingThread listener([this] { return look(); });
    on_all_threads([&] { render_tiles(task); });
}

/// Goes on after a failure, which rank 0 answers by ending the work.
void TileWorker::render_tiles(const TileTask& task) {
    while (const std::optional<Tile> tile = next()) {
        try {
            std::string result = render(*tile, task);
            add(tile->first, std::move(result), find_problems_());
        } catch (const std::exception& e) {
            const std::lock_guard lock(mutex_);
            fail(e.what());
        }
    }
}

void TileWorker::add(std::size_t tile, std::string result,
                     const std::vector<std::string>& problems) {
    const std::lock_guard lock(mutex_);
    for (const std::string& problem : problems) {
        if (problem.ends_with(lack_of_memory)) return fail(problem);
        if (std::ranges::find(problems_, problem) == problems_.end()) problems_.push_back(problem);
    }
    results_.emplace_back(tile, std::move(result));
}

/// Waits for a task; nothing if there is no more work.
std::optional<TileWorker::Tile> TileWorker::next() {
    std::unique_lock lock(mutex_);
    is_changed_.wait(lock, [&] { return is_over_ || !tasks_.empty(); });
    if (is_over_) return std::nullopt;
    Tile tile = std::move(tasks_.front());
    tasks_.pop_front();
    return tile;
}

std::string TileWorker::render(const Tile& tile, const TileTask& task) const {
    std::string_view bytes = tile.second;
    std::string result;
    StateReader reader = reader_of(bytes);
    StateWriter writer = writer_to(result);
    task(tile.first, reader, writer, [this] { return is_over_.load(); });
    return result;
}

/// Exchanges messages with rank 0; returns whether one had arrived.
bool TileWorker::look() {
    const std::lock_guard lock(mutex_);
    try {
        const bool received =
            ranks_.receive([&](int, std::string_view message) { handle(message); });
        heed_signal();
        send_results();
        return received;
    } catch (const std::exception& e) {
        fail(e.what());
        return false;
    }
}

void TileWorker::handle(std::string_view message) {
    if (kind_of(message) == MessageKind::end) {
        is_over_ = true;
    } else {
        for_each_tile_of(content_of(message), [&](std::size_t tile, std::string_view task) {
            tasks_.emplace_back(tile, task);
        });
    }
    is_changed_.notify_all();
}

void TileWorker::send_results() {
    if (!failure_.empty()) {
        ranks_.send(0, message_of(MessageKind::failure, std::exchange(failure_, {})));
    }
    for (; sent_problems_ < problems_.size(); ++sent_problems_) {
        ranks_.send(0, message_of(MessageKind::problem, problems_[sent_problems_]));
    }
    while (!results_.empty()) {
        TileMessage message(MessageKind::results);
        for (; !results_.empty() && !message.is_full(); results_.pop_front()) {
            const auto& [tile, result] = results_.front();
            message.add(tile, result);
        }
        ranks_.send(0, message.text());
    }
}

/// Ends the work after a signal, unless rank 0 does so soon: if it is dead, the launcher ends this
/// rank before it has removed its copy of the scene.
void TileWorker::heed_signal() {
    if (!SignalGuard::raised() || is_over_) return;
    const auto now = std::chrono::steady_clock::now();
    if (!signalled_) signalled_ = now;
    if (now - *signalled_ < patience_after_signal) return;
    fail("was ended by signal " + std::to_string(SignalGuard::signal()));
    is_over_ = true;
    is_changed_.notify_all();
}

/// Reports why this rank renders nothing more, and waits for the end.
void TileWorker::fail(const std::string& why) {
    failure_ = why;
    tasks_.clear();
}

}  // namespace etalon
