// Adjacency of the triangles of a mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"

namespace etalon {

/// The sides of a mesh's triangles, directed along their winding order: side k of triangle t,
/// number 3 t + k, leads from corner k to the next one.
struct HalfEdges {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::vector<std::uint32_t> origins;  ///< vertex from which a side starts: the mesh's indices
    std::vector<std::uint32_t> twins;  ///< the same edge in the other triangle; none at a boundary

    static std::uint32_t next(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
    static std::uint32_t previous(std::uint32_t side) {
        return side % 3 == 0 ? side + 2 : side - 1;
    }
    std::uint32_t target(std::uint32_t side) const { return origins[next(side)]; }

    /// Return the next or the previous side from the same vertex; none beyond a boundary.
    std::uint32_t turned(std::uint32_t side) const {
        return twins[side] == none ? none : next(twins[side]);
    }
    std::uint32_t turned_back(std::uint32_t side) const { return twins[previous(side)]; }
};

/// Finds the twins. Returns an error if an index is not below vertex_count, if a triangle names a
/// vertex twice, if more than two triangles share an edge or if two follow it in the same
/// direction.
Result<HalfEdges> make_half_edges(std::span<const std::uint32_t> indices, std::size_t vertex_count);

}  // namespace etalon
