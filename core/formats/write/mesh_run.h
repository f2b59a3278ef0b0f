#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/geometry.h"

namespace etalon {

/// Consecutive triangles of a geometry as one mesh with vertices of its own.
struct MeshRun {
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals;  ///< one for each vertex, or none
    std::vector<std::array<std::uint32_t, 3>> faces;
};

/// Returns the mesh of triangle number `first` and all that follow with the same material and
/// sides, and either all smooth or all flat.
MeshRun mesh_from(const Geometry& geometry, std::size_t first);

}  // namespace etalon
