#pragma once

#include <sys/stat.h>

#include <cerrno>
#include <string>

#include "core/base/stream_to.h"
#include "core/base/uninterrupted.h"

namespace etalon {

/// What is at the path of a file that is to be written, following symbolic links.
class WriteTarget {
  public:
    explicit WriteTarget(const std::string& path)
        : error_(::stat(path.c_str(), &status_) == 0 ? 0 : errno),
          stream_(exists() ? stream_to(status_) : -1) {}

    bool exists() const { return error_ == 0; }
    bool is_regular() const { return exists() && S_ISREG(status_.st_mode); }

    /// Returns why nothing can be found there: ENOENT if nothing is.
    Errno error() const { return error_; }

    /// Returns the stream of this process that writes it already: see stream_to().
    int stream() const { return stream_; }

    /// Returns whether it must be written as it is: a device, a pipe, or a file to which a stream
    /// was redirected. Anything else may be replaced by a new file.
    bool is_in_place() const { return exists() && (stream_ >= 0 || !is_regular()); }

    mode_t permissions() const { return status_.st_mode & 0777; }

  private:
    struct stat status_ = {};
    Errno error_;
    int stream_;
};

/// Returns whether rename() failed because a file may be written, but not replaced: it is a mount
/// point, or another user's in a folder such as /tmp.
inline bool forbids_rename(Errno error) {
    return error == EBUSY || error == EPERM || error == EXDEV;
}

}  // namespace etalon
