// The files of a scene, sent from rank to rank: each gives them on to two others, so that the time
// grows with the logarithm of the number of ranks.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "app/mpi/ranks.h"

namespace etalon {

/// Sends the files that rank 0 has read, by the paths by which it did; `standard_input` for "-".
void send_scene(Ranks& ranks, const std::set<std::string>& paths, std::string_view standard_input);

/// A copy of such files, in a temporary folder where each has the path that it has at rank 0. They
/// are removed with this.
class SceneCopy {
  public:
    SceneCopy() = default;
    ~SceneCopy();
    SceneCopy(const SceneCopy&) = delete;
    SceneCopy& operator=(const SceneCopy&) = delete;

    /// Receives the files, gives them on, and makes the copy of rank 0's folder the current one.
    /// Returns why that failed, or nothing.
    std::string receive(Ranks& ranks);

    /// Returns whether rank 0 wants nothing instead.
    bool is_over() const { return is_over_; }

    /// Where the copy of a file is; "-" is what rank 0 had as standard input.
    std::string place_of(const std::string& path) const;

  private:
    void handle(Ranks& ranks, std::string_view message);
    void append(std::string_view content);

    std::filesystem::path root_;
    bool is_over_ = false, is_complete_ = false;
    std::string error_;
};

}  // namespace etalon
