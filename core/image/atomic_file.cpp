#include "core/image/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "core/base/link_target.h"
#include "core/base/stream_to.h"
#include "core/base/uninterrupted.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

Errno close_after(int file, Errno earlier) {
    const Errno closing = close_file(file);
    return earlier != 0 ? earlier : closing;
}

Errno write_in_place(const std::string& path, std::string_view content, int flags = 0) {
    const int file = open_file(path.c_str(), O_WRONLY | flags);
    return file < 0 ? errno : close_after(file, write_all(file, content));
}

/// A new file in the directory of `path`: on the same file system, or rename would have to copy.
/// Its name does not grow from the target's, whose length may already be the limit.
int open_beside(const fs::path& path, std::string& name) {
    static std::atomic<unsigned> serial = 0;
    int file = -1;
    do {
        name = path.parent_path() /
               (".etalon-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp");
        file = open_file(name.c_str(), O_WRONLY | O_CREAT | O_EXCL);
    } while (file < 0 && errno == EEXIST);
    return file;
}

/// Writes and renames a file; `replaced` is what is at `path` now, or nullptr.
Errno write_and_rename(const std::string& path, std::string_view content,
                       const struct stat* replaced) {
    std::string temporary;
    const int file = open_beside(path, temporary);
    if (file < 0) return errno;
    Errno error = write_all(file, content);
    if (error == 0 && replaced && ::fchmod(file, replaced->st_mode & 0777) != 0) error = errno;
    // The name must not reach the disk before the content does.
    if (error == 0) error = synchronize(file);
    error = close_after(file, error);
    if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
    if (error != 0) ::unlink(temporary.c_str());
    return error;
}

/// Returns whether a file may be written that none may replace: because it is a mount point, or
/// another user's in a folder such as /tmp.
bool forbids_rename(Errno error) {
    return error == EBUSY || error == EPERM || error == EXDEV;
}

Errno write_file(const std::string& path, std::string_view content) {
    struct stat present = {};
    if (::stat(path.c_str(), &present) != 0) {
        return write_and_rename(link_target(path), content, nullptr);
    }
    if (const int stream = stream_to(present); stream >= 0) return write_all(stream, content);
    if (::access(path.c_str(), W_OK) != 0) return errno;
    if (!S_ISREG(present.st_mode)) return write_in_place(path, content);
    const Errno error = write_and_rename(link_target(path), content, &present);
    return forbids_rename(error) ? write_in_place(path, content, O_TRUNC) : error;
}

}  // namespace

std::string write_file_atomically(const std::string& path, std::string_view content) {
    try {
        const Errno error = write_file(path, content);
        if (error == 0) return {};
        return path + ": cannot be written: " + std::generic_category().message(error);
    } catch (const std::exception& e) {
        return path + ": cannot be written: " + e.what();
    }
}

}  // namespace etalon
