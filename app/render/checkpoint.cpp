#include "app/render/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "app/common/console.h"
#include "app/common/shallow_json.h"
#include "app/part/image_identity.h"
#include "core/image/file_replacement.h"

namespace etalon {
namespace {

/// First line of all checkpoints; its number changes with the format of the state.
constexpr std::string_view kind = "etalon-checkpoint ";
constexpr std::string_view layout = "1";

/// Fraction of the time that checkpoints may take, 2 %: the interval to the next is so many times
/// the duration of the last one.
constexpr double least_ratio = 49;

/// Longest text of an identity; a longer one is damaged.
constexpr std::size_t longest_line = 1 << 16;

/// Returns a line without its end; nothing if there is none.
std::string read_line(std::istream& file) {
    std::string line;
    for (char c = 0; line.size() < longest_line && file.get(c);) {
        if (c == '\n') return line;
        line += c;
    }
    return {};
}

/// Returns whether the file's end is the hash of what comes before it.
bool is_whole(std::istream& file, std::uint64_t size) {
    std::uint64_t stored = 0;
    if (size < sizeof stored) return false;
    Hash64 hash;
    std::vector<char> bytes(std::min<std::uint64_t>(size, 1 << 20));
    file.seekg(0);
    for (std::uint64_t left = size - sizeof stored; left > 0 && file;) {
        const auto count = std::min<std::uint64_t>(left, bytes.size());
        file.read(bytes.data(), static_cast<std::streamsize>(count));
        hash.add({bytes.data(), count});
        left -= count;
    }
    file.read(reinterpret_cast<char*>(&stored), sizeof stored);
    return file && stored == hash.value();
}

}  // namespace

CheckpointWriter::CheckpointWriter(std::string path, double every,
                                   const nlohmann::ordered_json& identity, Clock clock)
    : path_(std::move(path)),
      identity_(identity.dump()),
      every_(every),
      clock_(clock),
      due_(clock() + every) {}

bool CheckpointWriter::is_due() {
    const double now = clock_();
    if (now < due_) return false;
    double none = 0;
    paused_.compare_exchange_strong(none, now);
    return true;
}

void CheckpointWriter::keep(const std::function<void(StateWriter&)>& save) {
    const double start = paused_ > 0 ? paused_.load() : clock_();
    report(write(save));
    const double end = clock_();
    seconds_ += end - start;
    due_ = end + std::max(every_, least_ratio * (end - start));
    paused_ = 0;
}

std::string CheckpointWriter::write(const std::function<void(StateWriter&)>& save) const {
    FileReplacement file(path_);
    Hash64 hash;
    const auto put = [&](std::string_view bytes) {
        hash.add(bytes);
        file.write(bytes);
    };
    put(fmt::format("{}{}\n{}\n", kind, layout, identity_));
    StateWriter writer(put);
    save(writer);
    const std::uint64_t value = hash.value();
    file.write({reinterpret_cast<const char*>(&value), sizeof value});
    return file.put_in_place();
}

/// Prints the same warning only once.
void CheckpointWriter::report(const std::string& error) {
    if (error.empty()) ++written_;
    if (!error.empty() && error != error_) {
        print_message("etalon: warning: checkpoint {}; rendering goes on\n", error);
    }
    error_ = error;
}

std::string CheckpointReader::open(const std::string& path,
                                   const nlohmann::ordered_json& identity) {
    std::error_code error;
    const bool is_other =
        std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
    if (is_other) return path + ": is no regular file";
    const std::uint64_t size = std::filesystem::file_size(path, error);
    file_.open(path, std::ios::binary);
    if (error || !file_) return path + ": cannot be read" + (error ? ": " + error.message() : "");
    const std::string first = read_line(file_), second = read_line(file_);
    if (!first.starts_with(kind)) return path + ": is not a checkpoint, or is damaged";
    if (first.substr(kind.size()) != layout) {
        return fmt::format("{}: is a checkpoint of another version of Etalon, layout {}, here {}",
                           path, first.substr(kind.size()), layout);
    }
    const auto begin = static_cast<std::streamoff>(first.size() + second.size() + 2);
    if (!is_whole(file_, size)) return path + ": the checkpoint is damaged or cut short";
    const auto there = parse_shallow_json(second);
    const std::string difference = identity_difference(there, identity, "here");
    if (!difference.empty()) return path + ": is a checkpoint of another image: " + difference;
    file_.seekg(begin);
    left_ = size - static_cast<std::uint64_t>(begin) - sizeof(std::uint64_t);
    return {};
}

StateReader CheckpointReader::state() {
    return StateReader([this](char* to, std::size_t size) {
        if (size > left_) return false;
        left_ -= size;
        return static_cast<bool>(file_.read(to, static_cast<std::streamsize>(size)));
    });
}

}  // namespace etalon
