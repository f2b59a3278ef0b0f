// Calls of the system that a signal may interrupt, and writes that may take a part only. Etalon's
// own handlers let calls start again, but not those of every library and debugger do, and not every
// file system obeys.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

namespace etalon {

/// 0, or the errno of the call that failed.
using Errno = int;

/// Repeats a call, which returns -1 and sets errno where it fails, while signals interrupt it.
template <class Call>
auto uninterrupted(const Call& call) {
    auto result = call();
    while (result == -1 && errno == EINTR) result = call();
    return result;
}

/// Opens a file, a new one with the permissions that the umask leaves. Returns -1 if it cannot be.
inline int open_file(const char* path, int flags) {
    return uninterrupted([&] { return ::open(path, flags | O_CLOEXEC, 0666); });
}

/// Waits until what was written to a file is on the disk.
inline Errno synchronize(int file) {
    return uninterrupted([&] { return ::fsync(file); }) == 0 ? 0 : errno;
}

/// Closes a file, once: where a signal interrupts that on Linux, the file is closed all the same,
/// and its number may be another file's already. Network disks report failures of writes here.
inline Errno close_file(int file) {
    return ::close(file) == 0 || errno == EINTR ? 0 : errno;
}

/// Writes all bytes, however many calls it takes.
inline Errno write_all(int file, std::string_view content) {
    while (!content.empty()) {
        const ssize_t n =
            uninterrupted([&] { return ::write(file, content.data(), content.size()); });
        if (n < 0) return errno;
        if (n == 0) return EIO;  // or this would never end
        content.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

}  // namespace etalon
