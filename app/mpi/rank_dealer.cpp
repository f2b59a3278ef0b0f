#include "app/mpi/rank_dealer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>

#include "app/common/signals.h"
#include "app/mpi/tile_message.h"
#include "app/part/image_identity.h"
#include "core/parallel/all_threads.h"

namespace etalon {
namespace {

/// Most tiles that a thread of another rank has in advance. Tiles of few samples take a fraction of
/// a millisecond, and messages wait for some milliseconds until they are polled.
constexpr std::size_t most_ahead = 64;

/// Time between two checks whether an interruption ends the wait for results.
constexpr auto stop_interval = std::chrono::milliseconds(5);

}  // namespace

RankDealer::~RankDealer() {
    listener_.reset();
    for (int rank = 1; rank < ranks_.size(); ++rank) {
        ranks_.send(rank, message_of(MessageKind::end));
    }
}

void RankDealer::listen(const nlohmann::ordered_json& identity) {
    identity_ = identity;
    all_threads_ = static_cast<std::size_t>(max_threads());
    workers_[0].threads = all_threads_;
    listener_.emplace([this] { return look(); });
}

void RankDealer::deal(const DealtPass& pass) {
    begin(pass);
    struct AtEnd {
        RankDealer& self;
        ~AtEnd() {
            const std::lock_guard lock(self.mutex_);
            self.pass_ = nullptr;
        }
    } at_end{*this};
    on_all_threads([&] {
        while (!pass.interrupted()) {
            const std::optional<std::size_t> tile = take();
            if (!tile) return;
            pass.render(*tile);
            ++rendered_here_;
        }
    });
    wait_for_results(pass);
}

void RankDealer::begin(const DealtPass& pass) {
    const std::lock_guard lock(mutex_);
    pass_ = &pass;
    tiles_.clear();
    std::ranges::copy_if(pass.tiles, std::back_inserter(tiles_),
                         [&](std::size_t tile) { return !lent_.contains(tile); });
    next_ = 0;
    is_new_ = true;
}

void RankDealer::wait_for_results(const DealtPass& pass) {
    std::unique_lock lock(mutex_);
    while (!lent_.empty() && !pass.interrupted()) has_results_.wait_for(lock, stop_interval);
}

/// Returns the next tile of the pass. May be called while there is one.
std::optional<std::size_t> RankDealer::take() {
    const std::size_t place = next_.fetch_add(1);
    return place < tiles_.size() ? std::optional(tiles_[place]) : std::nullopt;
}

/// Handles the other ranks' messages and needs; returns whether there was anything to do.
bool RankDealer::look() {
    const std::lock_guard lock(mutex_);
    if (!pass_) return false;
    try {
        const bool received =
            ranks_.receive([&](int from, std::string_view message) { handle(from, message); });
        if (!ranks_.error().empty()) fail("a message was lost: " + ranks_.error());
        if (is_new_) {
            is_new_ = false;
            for (int rank = 1; rank < ranks_.size(); ++rank) supply(rank);
        }
        return received;
    } catch (const std::exception& e) {
        fail(e.what());
        return false;
    }
}

void RankDealer::handle(int from, std::string_view message) {
    const std::string_view content = content_of(message);
    switch (kind_of(message)) {
        case MessageKind::ready:
            note_ready(from, content);
            break;
        case MessageKind::failure:
            // After a signal, which others get too, what there is of the image is still written.
            if (!SignalGuard::raised()) fail(fmt::format("rank {} has failed: {}", from, content));
            break;
        case MessageKind::problem:
            problems_.emplace_back(content);
            break;
        default:
            read_results(from, content);
    }
    supply(from);
}

void RankDealer::note_ready(int from, std::string_view content) {
    std::uint64_t threads = 0;
    StateReader reader = reader_of(content);
    reader(threads);
    const auto there = nlohmann::ordered_json::parse(content, nullptr, false);
    const std::string difference = identity_difference(there, identity_, "on rank 0");
    if (!difference.empty()) {
        return fail(fmt::format("rank {} renders another image: {}", from, difference));
    }
    workers_[from].threads = threads;
    all_threads_ += threads;
}

void RankDealer::read_results(int from, std::string_view content) {
    Worker& worker = workers_[from];
    const bool is_whole = for_each_tile_of(content, [&](std::size_t tile, std::string_view bytes) {
        StateReader reader = reader_of(bytes);
        pass_->read_result(tile, reader);
        if (reader.failed()) fail(fmt::format("rank {} sent a damaged tile", from));
        ++worker.rendered;
        --worker.dealt;
        lent_.erase(tile);
    });
    if (!is_whole) fail(fmt::format("rank {} sent a damaged message", from));
    if (lent_.empty()) has_results_.notify_one();
}

/// Returns how many tiles the rank is to have: one for each of its threads, and some in advance as
/// long as many are left.
std::size_t RankDealer::most_of(const Worker& worker) const {
    const std::size_t left = tiles_.size() - std::min(next_.load(), tiles_.size());
    return worker.threads * (1 + std::min(most_ahead, left / (2 * all_threads_)));
}

/// Gives a rank tiles up to that number.
void RankDealer::supply(int rank) {
    Worker& worker = workers_[rank];
    TileMessage message(MessageKind::tasks);
    while (!message.is_full() && worker.dealt < most_of(worker) && !pass_->interrupted()) {
        const std::optional<std::size_t> tile = take();
        if (!tile) break;
        std::string task;
        StateWriter writer = writer_to(task);
        pass_->write_task(*tile, writer);
        message.add(*tile, task);
        ++worker.dealt;
        lent_.insert(*tile);
    }
    if (!message.is_empty()) ranks_.send(rank, message.text());
}

void RankDealer::fail(const std::string& why) {
    if (error_.empty()) error_ = why;
    has_failed_ = true;
}

std::string RankDealer::error() const {
    const std::lock_guard lock(mutex_);
    return error_;
}

std::vector<std::string> RankDealer::problems() const {
    const std::lock_guard lock(mutex_);
    return problems_;
}

nlohmann::ordered_json RankDealer::stats() const {
    const std::lock_guard lock(mutex_);
    nlohmann::ordered_json threads, tiles;
    for (const Worker& worker : workers_) {
        threads.push_back(worker.threads);
        tiles.push_back(worker.rendered);
    }
    tiles[0] = rendered_here_.load();
    const Traffic& traffic = ranks_.traffic();
    return {{"count", ranks_.size()},
            {"threads", threads},
            {"tiles", tiles},
            {"messages_sent", traffic.messages_sent},
            {"bytes_sent", traffic.bytes_sent},
            {"messages_received", traffic.messages_received},
            {"bytes_received", traffic.bytes_received}};
}

}  // namespace etalon
