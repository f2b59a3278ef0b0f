#pragma once

#include <filesystem>
#include <string>

namespace etalon::frames {

/// A new folder of this process below that of temporary files, which only its user can enter;
/// removed at the end with what it holds.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    /// Returns why there is no folder, or nothing.
    const std::string& error() const { return error_; }

    std::string file(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
    std::string error_;
};

}  // namespace etalon::frames
