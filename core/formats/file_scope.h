#pragma once

#include <filesystem>
#include <string>

namespace etalon {

/// The files that a scene may open: all, or those in one directory, wherever symbolic links lead.
class FileScope {
  public:
    /// An empty `root` confines nothing.
    explicit FileScope(const std::string& root);

    /// Returns why a file may not be opened, empty if it may: "'x' lies outside of 'DIR', ...".
    /// Says the same of a file that exists and of one that does not.
    std::string objection(const std::filesystem::path& file) const;

  private:
    bool holds(const std::filesystem::path& file) const;

    std::string root_;
    std::filesystem::path real_root_;  ///< without links; empty if it cannot be found
};

}  // namespace etalon
