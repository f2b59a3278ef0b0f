#include "core/tessellate/half_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace etalon {
namespace {

/// A side and the vertices that it joins, the lower one first.
struct Edge {
    std::uint32_t low, high, side;
    bool joins_the_same(const Edge& e) const { return low == e.low && high == e.high; }
};

/// Returns what is wrong with the indices themselves; empty if nothing is.
std::string find_bad_index(std::span<const std::uint32_t> indices, std::size_t vertex_count) {
    if (indices.size() % 3 != 0) {
        return fmt::format("{} indices, which are not three for each triangle", indices.size());
    }
    if (indices.size() >= HalfEdges::none) return "too many triangles";
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
        const std::uint32_t largest = std::max({a, b, c});
        if (largest >= vertex_count) {
            return fmt::format("triangle {} names vertex {}, of {} vertices from 0", i / 3, largest,
                               vertex_count);
        }
        if (a == b || b == c || c == a) {
            return fmt::format("triangle {} names vertex {} twice", i / 3, a == b ? a : c);
        }
    }
    return {};
}

std::vector<Edge> sorted_edges(const HalfEdges& mesh) {
    std::vector<Edge> edges;
    edges.reserve(mesh.origins.size());
    for (std::uint32_t side = 0; side < mesh.origins.size(); ++side) {
        const std::uint32_t a = mesh.origins[side], b = mesh.target(side);
        edges.push_back({std::min(a, b), std::max(a, b), side});
    }
    std::ranges::sort(edges, {}, [](const Edge& e) { return std::tuple(e.low, e.high, e.side); });
    return edges;
}

}  // namespace

Result<HalfEdges> make_half_edges(std::span<const std::uint32_t> indices,
                                  std::size_t vertex_count) {
    Result<HalfEdges> result;
    result.error = find_bad_index(indices, vertex_count);
    if (!result) return result;
    HalfEdges& mesh = result.value;
    mesh.origins.assign(indices.begin(), indices.end());
    mesh.twins.assign(indices.size(), HalfEdges::none);
    const std::vector<Edge> edges = sorted_edges(mesh);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const Edge &a = edges[i], &b = edges[i + 1];
        if (!a.joins_the_same(b)) continue;
        if (mesh.twins[a.side] != HalfEdges::none) {
            result.error = fmt::format(
                "more than two triangles meet at the edge of vertices {} and {}", a.low, a.high);
            return result;
        }
        if (mesh.origins[a.side] == mesh.origins[b.side]) {
            result.error =
                fmt::format("triangles {} and {} face opposite sides at their common edge",
                            a.side / 3, b.side / 3);
            return result;
        }
        mesh.twins[a.side] = b.side;
        mesh.twins[b.side] = a.side;
    }
    return result;
}

}  // namespace etalon
