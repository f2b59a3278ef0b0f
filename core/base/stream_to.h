#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace etalon {

/// Returns whether a file descriptor was inherited and can be written. The program's own files are
/// closed on exec; a new one may get the inode of a file that another thread has just replaced.
inline bool is_redirected(int stream) {
    return (::fcntl(stream, F_GETFD) & FD_CLOEXEC) == 0 &&
           (::fcntl(stream, F_GETFL) & O_ACCMODE) != O_RDONLY;
}

/// Returns the stream, one of those that a shell redirects, that was opened to write this file,
/// such as standard output for /dev/fd/1; -1 if there is none. To open the file anew, or to
/// replace it, would lose what was and will be written to the stream.
inline int stream_to(const struct stat& file) {
    constexpr int last = 9;
    for (int stream = STDOUT_FILENO; stream <= last; ++stream) {
        struct stat opened = {};
        if (::fstat(stream, &opened) != 0) continue;
        const bool is_it = opened.st_dev == file.st_dev && opened.st_ino == file.st_ino;
        if (is_it && is_redirected(stream)) return stream;
    }
    return -1;
}

}  // namespace etalon
