#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace etalon {

/// Last of the streams that a shell redirects.
inline constexpr int last_stream = 9;

/// Bits of the streams that were open before main(), and so were inherited. What is open later may
/// be the program's own: another thread's file, closed and opened anew between two questions.
inline const unsigned inherited_streams = []() noexcept {
    unsigned bits = 0;
    for (int stream = STDOUT_FILENO; stream <= last_stream; ++stream) {
        if (::fcntl(stream, F_GETFD) >= 0) bits |= 1U << stream;
    }
    return bits;
}();

/// Returns the inherited stream that was opened to write this file, such as standard output for
/// /dev/fd/1; -1 if there is none. To open the file anew, or to replace it, would lose what was and
/// will be written to the stream.
inline int stream_to(const struct stat& file) {
    for (int stream = STDOUT_FILENO; stream <= last_stream; ++stream) {
        if ((inherited_streams >> stream & 1) == 0) continue;
        struct stat opened = {};
        if (::fstat(stream, &opened) != 0) continue;
        const bool is_it = opened.st_dev == file.st_dev && opened.st_ino == file.st_ino;
        if (is_it && (::fcntl(stream, F_GETFL) & O_ACCMODE) != O_RDONLY) return stream;
    }
    return -1;
}

}  // namespace etalon
