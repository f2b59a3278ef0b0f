#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>

namespace etalon {

/// Writes a file in pieces and replaces the old one when it is complete. Until then, and after any
/// failure, the old file stays unchanged. Meant for files that are replaced again and again: the
/// next process overwrites what a killed one leaves behind. A new file gets the permissions that
/// the umask leaves, a replaced one keeps its own. A file that the system lets no other replace,
/// such as a mount point, is overwritten once the new one is complete: if that fails, it is
/// damaged.
class FileReplacement {
  public:
    explicit FileReplacement(const std::string& path);
    ~FileReplacement();  ///< discards what was not put in place
    FileReplacement(const FileReplacement&) = delete;
    FileReplacement& operator=(const FileReplacement&) = delete;

    /// Writes the next bytes, unless an earlier call failed.
    void write(std::string_view bytes);

    /// Returns whether a call failed, so that further work is in vain.
    bool has_failed() const { return error_ != 0; }

    /// Replaces the file by what was written, once that is on the disk. Returns the reason of the
    /// first failure, beginning with the path, or an empty string.
    std::string put_in_place();

  private:
    int check_target();
    void open();
    int claim(bool is_new) const;
    bool is_own() const;
    bool lock() const;
    int replace();

    std::string path_, temporary_;
    std::optional<mode_t> mode_;  ///< permissions of the file that is replaced
    int file_ = -1;
    int error_ = 0;  ///< errno of the first call that failed
};

}  // namespace etalon
