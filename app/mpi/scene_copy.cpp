#include "app/mpi/scene_copy.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <vector>

#include "app/common/signals.h"
#include "app/mpi/poll_pause.h"
#include "app/mpi/tile_message.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

/// Bytes of a piece of a file, and number of messages that may wait to be sent.
constexpr std::size_t piece_size = 4 << 20, most_unsent = 4;

/// Name of standard input's copy.
constexpr const char* standard_input_name = "standard_input";

/// Sends a message to the two ranks that get it from this one.
void send_on(Ranks& ranks, std::string_view message) {
    for (int to = 2 * ranks.rank() + 1; to <= 2 * ranks.rank() + 2 && to < ranks.size(); ++to) {
        ranks.send(to, message);
    }
    ranks.wait_until_unsent(most_unsent);
}

/// A message of a file: the zero-terminated path, and the bytes.
void send_piece(Ranks& ranks, const std::string& path, std::string_view bytes) {
    send_on(ranks, message_of(MessageKind::file, (path + '\0').append(bytes)));
}

void send_file(Ranks& ranks, const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<char> bytes(piece_size);
    do {
        file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        send_piece(ranks, fs::absolute(path),
                   {bytes.data(), static_cast<std::size_t>(file.gcount())});
    } while (file);
}

}  // namespace

void send_scene(Ranks& ranks, const std::set<std::string>& paths, std::string_view standard_input) {
    std::error_code none;
    for (const std::string& path : paths) {
        if (fs::is_regular_file(path, none)) send_file(ranks, path);
    }
    for (std::size_t at = 0; at < standard_input.size(); at += piece_size) {
        send_piece(ranks, "-", standard_input.substr(at, piece_size));
    }
    send_on(ranks, message_of(MessageKind::files_end, fs::current_path().string()));
}

SceneCopy::~SceneCopy() {
    std::error_code none;
    if (!root_.empty()) fs::remove_all(root_, none);
}

std::string SceneCopy::place_of(const std::string& path) const {
    if (path == "-") return root_ / standard_input_name;
    return root_.string() + fs::absolute(path).lexically_normal().string();
}

std::string SceneCopy::original(const std::string& text) const {
    const std::string root = root_.string();
    return !root.empty() && text.starts_with(root) ? text.substr(root.size()) : text;
}

std::string SceneCopy::receive(Ranks& ranks) {
    std::string folder = fs::temp_directory_path() / "etalon-scene-XXXXXX";
    if (!::mkdtemp(folder.data())) return folder + ": cannot be made, to hold the scene";
    root_ = folder;
    PollPause pause;
    while (!is_complete_ && !is_over_ && ranks.error().empty()) {
        if (SignalGuard::raised()) {
            return fmt::format("was ended by signal {}", SignalGuard::signal());
        }
        const bool received =
            ranks.receive([&](int, std::string_view message) { handle(ranks, message); });
        if (received) {
            pause.reset();
        } else {
            pause.sleep();
        }
    }
    return error_.empty() ? ranks.error() : error_;
}

void SceneCopy::handle(Ranks& ranks, std::string_view message) {
    const std::string_view content = content_of(message);
    switch (kind_of(message)) {
        case MessageKind::end:
            is_over_ = true;
            return;
        case MessageKind::file:
            append(content);
            break;
        default: {
            is_complete_ = true;
            const fs::path folder = place_of(std::string(content));
            std::error_code error;
            fs::create_directories(folder, error);
            fs::current_path(folder, error);
            if (error && error_.empty()) error_ = folder.string() + ": " + error.message();
        }
    }
    send_on(ranks, message);
}

/// Makes all folders on the path of a file, also those that `..` leaves again: without them the
/// path would not lead to the copy.
void SceneCopy::make_folders(const fs::path& path) const {
    fs::path folder;
    std::error_code none;
    for (const fs::path& name : path.parent_path()) {
        folder /= name;
        fs::create_directories(place_of(folder), none);
    }
}

/// Appends a piece to the copy of its file. Rank 0 sends absolute paths.
void SceneCopy::append(std::string_view content) {
    const std::size_t end = content.find('\0');
    const std::string path(content.substr(0, end));
    const fs::path place = place_of(path);
    std::error_code error;
    if (!fs::exists(place, error)) make_folders(path);
    std::ofstream file(place, std::ios::binary | std::ios::app);
    file << content.substr(end + 1) << std::flush;
    if (!file && error_.empty()) error_ = place.string() + ": cannot be written";
}

}  // namespace etalon
