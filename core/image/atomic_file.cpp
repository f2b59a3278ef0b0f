#include "core/image/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "core/base/link_target.h"
#include "core/base/uninterrupted.h"
#include "core/base/write_target.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

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

/// Writes a new file and renames it to `path`, where there may be a file whose permissions it gets.
Errno write_and_rename(const std::string& path, std::string_view content,
                       const WriteTarget& replaced) {
    std::string temporary;
    const int file = open_beside(path, temporary);
    if (file < 0) return errno;
    Errno error = write_all(file, content);
    if (error == 0 && replaced.exists() && ::fchmod(file, replaced.permissions()) != 0) {
        error = errno;
    }
    // The name must not reach the disk before the content does.
    if (error == 0) error = synchronize(file);
    error = close_after(file, error);
    if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
    if (error != 0) ::unlink(temporary.c_str());
    return error;
}

Errno write_file(const std::string& path, std::string_view content) {
    const WriteTarget target(path);
    if (target.stream() >= 0) return write_all(target.stream(), content);
    if (target.exists() && ::access(path.c_str(), W_OK) != 0) return errno;
    if (target.is_in_place()) return write_in_place(path, content);
    const Errno error = write_and_rename(link_target(path), content, target);
    const bool is_overwritten = target.exists() && forbids_rename(error);
    return is_overwritten ? write_in_place(path, content, O_TRUNC) : error;
}

}  // namespace

std::string write_file_atomically(const std::string& path, std::string_view content) {
    try {
        const Errno error = write_file(path, content);
        if (error == 0) return {};
        return path + ": cannot be written: " + error_text(error);
    } catch (const std::exception& e) {
        return path + ": cannot be written: " + e.what();
    }
}

}  // namespace etalon
