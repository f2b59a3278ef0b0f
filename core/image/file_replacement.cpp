#include "core/image/file_replacement.h"

#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "core/base/hash64.h"
#include "core/base/link_target.h"
#include "core/base/uninterrupted.h"
#include "core/base/write_target.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

/// Returns the temporary path: on the same file system, or rename would have to copy. Its name is
/// short, whatever the file's is.
std::string name_beside(const fs::path& path) {
    const std::uint64_t name = hash64(path.filename().native());
    return path.parent_path() / fmt::format(".etalon-{:016x}.tmp", name);
}

Errno copy_all(int from, int to) {
    std::array<char, 1 << 16> bytes;
    for (;;) {
        const ssize_t n = uninterrupted([&] { return ::read(from, bytes.data(), bytes.size()); });
        if (n <= 0) return n == 0 ? 0 : errno;
        const Errno error = write_all(to, {bytes.data(), static_cast<std::size_t>(n)});
        if (error != 0) return error;
    }
}

/// Overwrites a file with the bytes of another one.
Errno overwrite(const std::string& path, const std::string& source) {
    const int from = open_file(source.c_str(), O_RDONLY);
    if (from < 0) return errno;
    const int to = open_file(path.c_str(), O_WRONLY | O_TRUNC);
    if (to < 0) return close_after(from, errno);
    Errno error = copy_all(from, to);
    if (error == 0) error = synchronize(to);
    return close_after(from, close_after(to, error));
}

}  // namespace

FileReplacement::FileReplacement(const std::string& path) : path_(path) {
    try {
        path_ = fs::exists(path) ? fs::canonical(path) : link_target(path);
        temporary_ = name_beside(path_);
        error_ = check_target();
    } catch (const fs::filesystem_error& e) {
        error_ = e.code().value();
    }
    if (error_ == 0) open();
}

FileReplacement::~FileReplacement() {
    if (file_ < 0) return;
    ::unlink(temporary_.c_str());
    close_file(file_);
}

/// Notes the permissions of the file that is replaced, if there is one. Returns why it cannot be
/// replaced, or 0.
int FileReplacement::check_target() {
    const WriteTarget target(path_);
    if (!target.exists()) return target.error() == ENOENT ? 0 : target.error();
    if (!target.is_regular()) return EINVAL;
    if (::access(path_.c_str(), W_OK) != 0) return errno;
    mode_ = target.permissions();
    return 0;
}

/// Opens a new file, or one that this user has left; others who can write to the folder may have
/// put another, or a link, where it is known to be. (On network disks a new file may be another
/// user's.)
void FileReplacement::open() {
    file_ = open_file(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL);
    const bool is_new = file_ >= 0;
    if (!is_new && errno == EEXIST) {
        file_ = open_file(temporary_.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW);
    }
    if (file_ < 0) {
        error_ = errno;
    } else if (error_ = claim(is_new); error_ != 0) {
        close_file(file_);
        file_ = -1;
    } else if (uninterrupted([&] { return ::ftruncate(file_, 0); }) != 0 ||
               (mode_ && ::fchmod(file_, *mode_) != 0)) {
        error_ = errno;
    }
}

/// Returns why the opened file cannot be used, or 0.
int FileReplacement::claim(bool is_new) const {
    if (!is_new && !is_own()) return EPERM;
    return lock() ? 0 : EBUSY;
}

bool FileReplacement::is_own() const {
    struct stat opened = {};
    return ::fstat(file_, &opened) == 0 && S_ISREG(opened.st_mode) && opened.st_uid == ::geteuid();
}

/// Locks the file for this process; returns false if another one is writing it, or has just
/// replaced it. File systems without locks are trusted.
bool FileReplacement::lock() const {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
    struct stat opened = {}, named = {};
    return ::fstat(file_, &opened) == 0 && ::lstat(temporary_.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

void FileReplacement::write(std::string_view bytes) {
    if (error_ == 0) error_ = write_all(file_, bytes);
}

std::string FileReplacement::put_in_place() {
    if (error_ == 0) error_ = synchronize(file_);
    if (error_ == 0) error_ = replace();
    if (error_ == 0) return {};
    const bool is_busy = error_ == EBUSY;  // see claim()
    const std::string reason = is_busy ? "another program is writing it" : error_text(error_);
    return path_ + ": cannot be written: " + reason;
}

/// Renames the complete file; where the system forbids that, copies it.
int FileReplacement::replace() {
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) {
        return forbids_rename(errno) ? overwrite(path_, temporary_) : errno;
    }
    close_file(file_);
    file_ = -1;
    return 0;
}

}  // namespace etalon
