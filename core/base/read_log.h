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

/// Records the files that any thread reads during its lifetime: those of which a scene is made.
/// Logs may be nested: an outer one records what an inner one does. The one that was made last must
/// end first.
class ReadLog {
  public:
    enum class Keeps : std::uint8_t { paths, contents };

    /// Without `contents`, files need not be hashed, and fingerprint() does not distinguish them.
    explicit ReadLog(Keeps keeps = Keeps::contents)
        : outer_(current_), needs_contents_(keeps == Keeps::contents || needs_contents()) {
        current_ = this;
    }
    ~ReadLog() { current_ = outer_; }
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

    /// Returns whether a log needs the contents of files.
    static bool needs_contents() {
        const ReadLog* const log = current_;
        return log && log->needs_contents_;
    }

    /// Records a file with its contents, if there is a log.
    static void note(const std::string& path, std::string_view content) {
        note_hash(path, needs_contents() ? hash64(content) : 0);
    }

    /// Records a file with the hash of its contents, which is arbitrary unless needs_contents().
    static void note_hash(const std::string& path, std::uint64_t content) {
        for (ReadLog* log = current_; log; log = log->outer_) {
            const std::lock_guard lock(log->mutex_);
            log->contents_.emplace(path, content);
        }
    }

  private:
    inline static std::atomic<ReadLog*> current_ = nullptr;

    ReadLog* const outer_;
    const bool needs_contents_;  ///< here or in an outer log
    mutable std::mutex mutex_;
    std::set<std::pair<std::string, std::uint64_t>> contents_;  ///< paths with their hashes
};

}  // namespace etalon
