#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace etalon::generate {

/// A file that appears whole or not at all: written beside its place, renamed by commit(). An empty
/// path is standard output; what exists and is no regular file (a pipe, /dev/null) is written in
/// place. A symbolic link stays one: what it leads to is written. Throws std::system_error where
/// the file cannot be opened, written or finished: a full disk ends the work at once.
class Output {
  public:
    explicit Output(const std::string& path);
    ~Output();  ///< removes what was not committed
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    void write(std::string_view text);
    void commit();

  private:
    std::string path_, written_;  ///< where it belongs, and where it is being written
    std::FILE* file_;             ///< nullptr: standard output
};

}  // namespace etalon::generate
