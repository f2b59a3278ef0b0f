// The PLY files of a frame, read on all threads before the shapes that use them are built.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/formats/diagnostic_list.h"
#include "core/formats/pbrt/frame.h"
#include "core/formats/ply/ply.h"

namespace etalon::pbrt {

/// Contents of a file. Its diagnostics are reported when its shape is built, so that they come in
/// the order of the statements.
struct PlyFile {
    std::string path;
    std::string error;            ///< why it cannot be opened; else empty
    std::optional<PlyMesh> mesh;  ///< nothing after an error
    DiagnosticList said;
};

class PlyFiles {
  public:
    /// Prepares to read the files of all visible shapes of a frame.
    PlyFiles(const Frame& frame, bool strict);

    /// Returns the file of a shape; each shape calls this once. The files of the next shapes are
    /// read with it, in the order in which shapes are built: those of the world, then of objects by
    /// first instances.
    PlyFile take(const Shape& shape);

  private:
    void add(std::span<const Shape> shapes);

    /// Reads the file of the shape with this number and those of some that follow it.
    void read_ahead(std::size_t number);

    bool strict_;
    std::vector<const Shape*> shapes_;                       ///< those with a file
    std::unordered_map<const Shape*, std::size_t> numbers_;  ///< among them
    std::size_t first_read_ = 0;  ///< number of the shape of the first of `read_`
    std::vector<PlyFile> read_;
};

}  // namespace etalon::pbrt
