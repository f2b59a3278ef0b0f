// Rules by which the vertices of a Loop subdivision surface are computed from their neighbours.
#pragma once

#include <vector>

#include "core/numerics/vec.h"
#include "core/tessellate/half_edges.h"

namespace etalon {

/// A mesh that is being subdivided.
struct LoopMesh {
    HalfEdges sides;
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> starts;  ///< a side from each vertex; none if no triangle uses it
};

/// The vertices around one. At a boundary they go from one end of it to the other.
struct Ring {
    std::vector<Vec3> points;
    bool is_open = false;  ///< whether the vertex is at a boundary

    /// Collects the ring of a vertex that triangles use.
    void gather(const LoopMesh& mesh, std::uint32_t vertex);
};

/// Returns the position in the next, finer mesh of a vertex that is in both.
Vec3 even_position(const Vec3& vertex, const Ring& ring);

/// Returns the position in the next mesh of the vertex that splits a side.
Vec3 odd_position(const LoopMesh& mesh, std::uint32_t side);

/// Returns the position on the limit surface.
Vec3 limit_position(const Vec3& vertex, const Ring& ring);

/// Returns a normal of the limit surface, of any length, after vertex and ring have been moved to
/// it.
Vec3 limit_normal(const Vec3& vertex, const Ring& ring);

}  // namespace etalon
