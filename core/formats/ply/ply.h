// Triangle meshes in the PLY format: text, and binary in either byte order.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/uninitialized.h"
#include "core/formats/diagnostic_log.h"
#include "core/parallel/large_pages.h"

namespace etalon {

/// An array whose elements are left uninitialized until it is filled.
template <class T>
using FilledLater = std::vector<T, Uninitialized<T, LargePages>>;

struct PlyMesh {
    FilledLater<float> positions;            ///< x y z of each vertex, finite if a triangle uses it
    FilledLater<float> normals;              ///< as many, or none; of any length, finite
    FilledLater<float> uvs;                  ///< u v of each vertex, or none; finite
    FilledLater<std::uint32_t> indices;      ///< three vertices a triangle
    std::vector<std::int32_t> face_numbers;  ///< `face_indices` of each triangle, or none
};

/// Reads vertices and faces and ignores everything else. A quadrilateral a b c d becomes the
/// triangles a b c and d a c. Faces of other than three or four corners are left out with a
/// warning, and so are those with vertices that are not finite. Returns nothing, after an error, if
/// the header, a number of the file or the index of a vertex is wrong, or if the file ends early.
std::optional<PlyMesh> read_ply(std::string_view bytes, DiagnosticLog& log);

}  // namespace etalon
