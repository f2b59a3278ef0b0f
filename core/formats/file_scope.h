#pragma once

#include <filesystem>
#include <string>

namespace etalon {

/// The files that a scene may open: all, or those in one directory after resolving symbolic links.
class FileScope {
  public:
    /// With an empty `root` all files may be opened.
    explicit FileScope(const std::string& root);

    /// Returns why a file may not be opened: "'x' lies outside of 'DIR', ..."; empty if it may. The
    /// result is the same whether or not the file exists.
    std::string check(const std::filesystem::path& file) const;

  private:
    bool holds(const std::filesystem::path& file) const;

    std::string root_;
    std::filesystem::path real_root_;  ///< with links resolved; empty if it does not exist
};

}  // namespace etalon
