#pragma once

#include <atomic>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

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

    /// Returns a hash of the contents, independent of the files' names, of their order, and of how
    /// often each was read.
    std::uint64_t fingerprint() const {
        const std::lock_guard lock(mutex_);
        Hash64 hash;
        for (const std::uint64_t content : contents_) {
            hash.add({reinterpret_cast<const char*>(&content), sizeof content});
        }
        return hash.value();
    }

    /// Returns the paths by which files were read.
    std::set<std::string> paths() const {
        const std::lock_guard lock(mutex_);
        return paths_;
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
        log->contents_.insert(content);
        log->paths_.insert(path);
    }

  private:
    inline static std::atomic<ReadLog*> current_ = nullptr;

    mutable std::mutex mutex_;
    std::set<std::uint64_t> contents_;
    std::set<std::string> paths_;
};

}  // namespace etalon
