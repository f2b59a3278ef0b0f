#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// Bytes that come in pieces and take the place of a file when all of them are there. Until then,
/// and where anything fails, the file stays what it was. Made for files that are replaced again and
/// again: what a killed process leaves behind is written over by the next one.
class FileReplacement {
  public:
    explicit FileReplacement(const std::string& path);
    ~FileReplacement();  ///< gives up what was not put in place
    FileReplacement(const FileReplacement&) = delete;
    FileReplacement& operator=(const FileReplacement&) = delete;

    /// Writes the next bytes, unless something failed before.
    void write(std::string_view bytes);

    /// Puts what was written in place of the file, once it is on the disk. Returns the reason of
    /// the first failure, beginning with the path, or nothing.
    std::string put_in_place();

  private:
    void open();
    bool lock();

    std::string path_, temporary_;
    int file_ = -1;
    int error_ = 0;  ///< errno of the first call that failed
};

}  // namespace etalon
