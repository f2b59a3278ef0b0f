// Distribution of a scene's files from rank to rank: each passes them on to two others, so that the
// time is logarithmic in the number of ranks.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "app/mpi/ranks.h"

namespace etalon {

/// Sends the files that rank 0 has read, by the same paths; `standard_input` is the contents of
/// "-".
void send_scene(Ranks& ranks, const std::set<std::string>& paths, std::string_view standard_input);

/// A copy of such files in a temporary folder, in which each has the same path as at rank 0.
/// Removed by the destructor.
class SceneCopy {
  public:
    SceneCopy() = default;
    ~SceneCopy();
    SceneCopy(const SceneCopy&) = delete;
    SceneCopy& operator=(const SceneCopy&) = delete;

    /// Receives the files, passes them on, and makes the copy of rank 0's folder the current one.
    /// Returns why that failed, or an empty string.
    std::string receive(Ranks& ranks);

    /// Returns whether rank 0 has ended instead.
    bool is_over() const { return is_over_; }

    /// Returns the path of the copy of a file; "-" is rank 0's standard input.
    std::string place_of(const std::string& path) const;

    /// Returns a text that begins with the path of a copy, with that of the file; others unchanged.
    std::string original(const std::string& text) const;

  private:
    void handle(Ranks& ranks, std::string_view message);
    void append(std::string_view content);
    void make_folders(const std::filesystem::path& path) const;

    std::filesystem::path root_;
    bool is_over_ = false, is_complete_ = false;
    std::string error_;
};

}  // namespace etalon
