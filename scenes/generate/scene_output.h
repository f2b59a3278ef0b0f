#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "core/image/file_replacement.h"

namespace etalon::generate {

/// A file that appears whole or not at all, at commit(). An empty path is standard output; what
/// exists and is no regular file (a pipe, /dev/null) is written in place, and so is a file to which
/// a stream was redirected (/dev/fd/1). A symbolic link stays one: what it leads to is written.
/// Throws std::runtime_error, whose text is the reason, where the file cannot be opened, written or
/// finished: a full disk ends the work at once.
class Output {
  public:
    explicit Output(const std::string& path);
    ~Output();  ///< removes what was not committed
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    void write(std::string_view text);
    void commit();

  private:
    void require(bool success) const;

    std::string path_;
    std::optional<FileReplacement> file_;
    std::FILE* device_ = nullptr;  ///< if it is written in place
};

}  // namespace etalon::generate
