#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/hash64.h"

namespace etalon {

/// Records the contents of all files that any thread reads during its lifetime: those of which a
/// scene is made. Only one may exist at a time.
class ReadLog {
  public:
    ReadLog() { current_ = this; }
    ~ReadLog() { current_ = nullptr; }
    ReadLog(const ReadLog&) = delete;
    ReadLog& operator=(const ReadLog&) = delete;

    /// Returns a hash of the contents and the files' names, independent of their folders, except
    /// for the order of folders that have files of one name, and of how often and in which order
    /// they were read. The name of the file `main` does not matter.
    std::uint64_t fingerprint(const std::string& main) const {
        const std::lock_guard lock(mutex_);
        std::map<std::string, std::string> files;  // for each name what is in its files, by paths
        for (const auto& [path, content] : contents_) {
            const std::string name =
                path == main ? std::string() : std::filesystem::path(path).filename().string();
            files[name] += '\0' + std::to_string(content);
        }
        Hash64 hash;
        for (const auto& [name, contents] : files) hash.add(name + contents + '\0');
        return hash.value();
    }

    /// Returns the paths by which files were read.
    std::set<std::string> paths() const {
        const std::lock_guard lock(mutex_);
        std::set<std::string> paths;
        for (const auto& [path, content] : contents_) paths.insert(path);
        return paths;
    }

    /// Returns whether there is a log.
    static bool is_kept() { return current_ != nullptr; }

    /// Records the contents of a file, if there is a log.
    static void note(const std::string& path, std::string_view content) {
        if (is_kept()) note_hash(path, hash64(content));
    }
    static void note_hash(const std::string& path, std::uint64_t content) {
        ReadLog* const log = current_;
        if (!log) return;
        const std::lock_guard lock(log->mutex_);
        log->contents_.emplace(path, content);
    }

  private:
    inline static std::atomic<ReadLog*> current_ = nullptr;

    mutable std::mutex mutex_;
    std::set<std::pair<std::string, std::uint64_t>> contents_;  ///< paths with their hashes
};

}  // namespace etalon
