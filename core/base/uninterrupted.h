// System calls that a signal may interrupt, and writes that may be partial. Etalon's own handlers
// restart calls, but not those of every library and debugger do, and not every file system obeys.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

namespace etalon {

/// 0, or the errno of the failed call.
using Errno = int;

/// Returns the system's words for an error.
inline std::string error_text(Errno error) {
    return std::generic_category().message(error);
}

/// Repeats a call, which returns -1 and sets errno on failure, while signals interrupt it.
template <class Call>
auto uninterrupted(const Call& call) {
    auto result = call();
    while (result == -1 && errno == EINTR) result = call();
    return result;
}

/// Opens a file; a new one gets the permissions that the umask leaves. Returns -1 on failure.
inline int open_file(const char* path, int flags) {
    return uninterrupted([&] { return ::open(path, flags | O_CLOEXEC, 0666); });
}

/// Waits until the contents of a file are on the disk.
inline Errno synchronize(int file) {
    return uninterrupted([&] { return ::fsync(file); }) == 0 ? 0 : errno;
}

/// Closes a file, once: if a signal interrupts that on Linux, the file is closed nevertheless, and
/// its number may already be another file's. Network disks report failures of writes here.
inline Errno close_file(int file) {
    return ::close(file) == 0 || errno == EINTR ? 0 : errno;
}

/// Closes a file after work that ended with `earlier`. Returns the first failure.
inline Errno close_after(int file, Errno earlier) {
    const Errno closing = close_file(file);
    return earlier != 0 ? earlier : closing;
}

/// Writes all bytes, with as many calls as it takes.
inline Errno write_all(int file, std::string_view content) {
    while (!content.empty()) {
        const ssize_t n =
            uninterrupted([&] { return ::write(file, content.data(), content.size()); });
        if (n < 0) return errno;
        if (n == 0) return EIO;  // avoids an endless loop
        content.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

}  // namespace etalon
