// Source of a rank's scene: the files themselves, or those that rank 0 sends.
#pragma once

#include <set>
#include <string>

#include "app/mpi/ranks.h"
#include "app/mpi/scene_copy.h"
#include "app/render/arguments.h"
#include "app/scene_arguments.h"
#include "core/formats/file_text.h"

namespace etalon {

class SceneSource {
  public:
    /// Both must outlive the source.
    SceneSource(RenderArguments& arguments, Ranks& ranks) : a_(arguments), ranks_(ranks) {}

    /// Gets the scene from rank 0, if that sends it. Returns why that failed, or an empty string.
    std::string receive();

    /// Returns whether rank 0 needs nothing from this rank.
    bool is_over() const { return copy_.is_over(); }

    LoadedScene load();

    /// Returns the path by which this rank reads the scene.
    std::string path_read() const;

    /// Returns a text that begins with the path of a file that this rank reads, with rank 0's path.
    std::string at_rank_0(const std::string& text) const { return copy_.original(text); }

    /// Sends the files of the loaded scene to the other ranks, if they get it this way.
    void send(const std::set<std::string>& files);

  private:
    bool is_sent() const {
        return ranks_.size() > 1 && (a_.mpi_scene == "broadcast" || a_.scene.path == "-");
    }

    RenderArguments& a_;
    Ranks& ranks_;
    SceneCopy copy_;
    FileText standard_input_;  ///< its contents, if the scene is read from it and sent
};

}  // namespace etalon
