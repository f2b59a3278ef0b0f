#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace etalon {

/// Who is next to whom in a mesh of triangles. Half-edge 3 f + k leads from corner k of triangle f
/// to the next.
class HalfEdges {
  public:
    static constexpr std::uint32_t none = 0xFFFFFFFFU;

    /// Nothing where two half-edges lead from one vertex to another: not a surface with two sides.
    static std::optional<HalfEdges> of(std::span<const std::uint32_t> corners,
                                       std::size_t vertices);

    std::uint32_t from(std::uint32_t h) const { return corners_[h]; }
    std::uint32_t to(std::uint32_t h) const { return corners_[next(h)]; }
    static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

    /// The same edge, the other way; none at a boundary.
    std::uint32_t twin(std::uint32_t h) const { return twins_[h]; }

    /// A half-edge from the vertex; on a boundary the one that runs along it. none if there is no
    /// triangle at the vertex.
    std::uint32_t first_of(std::uint32_t vertex) const { return first_[vertex]; }
    bool is_boundary(std::uint32_t vertex) const { return twin(first_of(vertex)) == none; }

    /// The vertices next to one, counter-clockwise; those of a boundary from one end to the other.
    void ring(std::uint32_t vertex, std::vector<std::uint32_t>& to) const;

  private:
    std::span<const std::uint32_t> corners_;
    std::vector<std::uint32_t> twins_, first_;
};

}  // namespace etalon
