#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/geometry.h"

namespace etalon {

/// Triangles that stand together in a geometry, as one mesh of its own vertices.
struct MeshRun {
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals;  ///< one for each vertex, or none
    std::vector<std::array<std::uint32_t, 3>> faces;
};

/// The triangle number `first` and all that follow it with the same material and sides, smooth as
/// it is or flat as it is.
MeshRun mesh_from(const Geometry& geometry, std::size_t first);

}  // namespace etalon
