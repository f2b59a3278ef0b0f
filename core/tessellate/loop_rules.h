// How vertices of a Loop subdivision surface follow from their neighbours.
#pragma once

#include <vector>

#include "core/numerics/vec.h"
#include "core/tessellate/half_edges.h"

namespace etalon {

/// A mesh on its way to the surface.
struct LoopMesh {
    HalfEdges sides;
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> starts;  ///< a side from each vertex; none if no triangle names it
};

/// The vertices around one. At a boundary they go from one end of it to the other.
struct Ring {
    std::vector<Vec3> points;
    bool is_open = false;  ///< whether the vertex is at a boundary

    /// Becomes the ring of a vertex that triangles name.
    void gather(const LoopMesh& mesh, std::uint32_t vertex);
};

/// Position in the next, finer mesh of a vertex that is in both.
Vec3 even_position(const Vec3& vertex, const Ring& ring);

/// Position in the next mesh of the vertex that splits a side.
Vec3 odd_position(const LoopMesh& mesh, std::uint32_t side);

/// Position on the surface.
Vec3 limit_position(const Vec3& vertex, const Ring& ring);

/// Normal of the surface, of any length, where vertex and ring have been moved to it.
Vec3 limit_normal(const Vec3& vertex, const Ring& ring);

}  // namespace etalon
