#include "core/tessellate/loop_subdivision.h"

#include <algorithm>
#include <numbers>

#include "core/tessellate/half_edges.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Meshes above this would take more memory than most machines have: some 100 bytes a triangle.
constexpr std::size_t most_triangles = 50'000'000;

/// Weight of each neighbour of an inner vertex (Warren's choice, as in pbrt-v3).
double neighbour_weight(std::size_t valence) {
    return valence == 3 ? 3.0 / 16 : 3.0 / (8 * static_cast<double>(valence));
}

/// The same for the limit of refining for ever.
double limit_weight(std::size_t valence) {
    return 1 / (static_cast<double>(valence) + 3 / (8 * neighbour_weight(valence)));
}

using Ring = std::vector<std::uint32_t>;

/// The vertex with some of its neighbours, each of that weight: of a boundary those along it.
Vec3 smoothed(const std::vector<Vec3>& points, std::uint32_t vertex, const Ring& ring,
              bool is_boundary, double weight) {
    if (is_boundary) {
        return (1 - 2 * weight) * points[vertex] +
               weight * (points[ring.front()] + points[ring.back()]);
    }
    Vec3 sum(0);
    for (const std::uint32_t neighbour : ring) sum += points[neighbour];
    return (1 - static_cast<double>(ring.size()) * weight) * points[vertex] + weight * sum;
}

/// Tangent of the limit surface that points inward from a boundary.
Vec3 inward_tangent(const std::vector<Vec3>& points, std::uint32_t vertex, const Ring& ring) {
    const std::size_t n = ring.size();
    const auto p = [&](std::size_t k) { return points[ring[k]]; };
    const Vec3& v = points[vertex];
    if (n == 2) return p(0) + p(1) - 2.0 * v;
    if (n == 3) return p(1) - v;
    if (n == 4) return 2.0 * (p(1) + p(2)) - p(0) - p(3) - 2.0 * v;
    const double theta = pi / static_cast<double>(n - 1);
    Vec3 sum = std::sin(theta) * (p(0) + p(n - 1));
    for (std::size_t k = 1; k + 1 < n; ++k) {
        sum += (2 * std::cos(theta) - 2) * std::sin(static_cast<double>(k) * theta) * p(k);
    }
    return -sum;
}

Vec3 limit_normal(const std::vector<Vec3>& points, std::uint32_t vertex, const Ring& ring,
                  bool is_boundary) {
    if (is_boundary) {
        const Vec3 along = points[ring.back()] - points[ring.front()];
        return along.cross(inward_tangent(points, vertex, ring));
    }
    Vec3 s(0), t(0);
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const double angle = 2 * pi * static_cast<double>(k) / static_cast<double>(ring.size());
        s += std::cos(angle) * points[ring[k]];
        t += std::sin(angle) * points[ring[k]];
    }
    return t.cross(s);
}

/// A mesh and who is next to whom in it.
struct Level {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> corners;
};

Vec3 edge_point(const Level& level, const HalfEdges& edges, std::uint32_t h) {
    const auto& p = level.points;
    const Vec3 ends = p[edges.from(h)] + p[edges.to(h)];
    const std::uint32_t twin = edges.twin(h);
    if (twin == HalfEdges::none) return 0.5 * ends;
    const Vec3 across =
        p[edges.from(HalfEdges::previous(h))] + p[edges.from(HalfEdges::previous(twin))];
    return 3.0 / 8 * ends + 1.0 / 8 * across;
}

/// Calls visit(vertex, ring, is_boundary) for each vertex that has triangles.
template <class Visit>
void for_each_ring(const HalfEdges& edges, std::size_t vertices, const Visit& visit) {
    Ring ring;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        if (edges.first_of(v) == HalfEdges::none) continue;
        edges.ring(v, ring);
        visit(v, ring, edges.is_boundary(v));
    }
}

/// Four triangles for each, with new vertices on the edges.
Level refined(const Level& level, const HalfEdges& edges) {
    Level result{level.points, {}};
    for_each_ring(edges, level.points.size(),
                  [&](std::uint32_t v, const Ring& ring, bool is_boundary) {
                      const double weight = is_boundary ? 1.0 / 8 : neighbour_weight(ring.size());
                      result.points[v] = smoothed(level.points, v, ring, is_boundary, weight);
                  });
    std::vector<std::uint32_t> on_edge(level.corners.size());
    for (std::uint32_t h = 0; h < on_edge.size(); ++h) {
        const std::uint32_t twin = edges.twin(h);
        if (twin < h) {
            on_edge[h] = on_edge[twin];
        } else {
            on_edge[h] = static_cast<std::uint32_t>(result.points.size());
            result.points.push_back(edge_point(level, edges, h));
        }
    }
    result.corners.reserve(4 * level.corners.size());
    for (std::size_t f = 0; f < level.corners.size(); f += 3) {
        const std::uint32_t *v = &level.corners[f], *e = &on_edge[f];
        result.corners.insert(result.corners.end(), {v[0], e[0], e[2], e[0], v[1], e[1],  //
                                                     e[2], e[1], v[2], e[0], e[1], e[2]});
    }
    return result;
}

SmoothMesh limit(Level level, const HalfEdges& edges) {
    SmoothMesh mesh{level.points, std::vector<Vec3>(level.points.size(), Vec3(0)), {}};
    const std::size_t count = level.points.size();
    for_each_ring(edges, count, [&](std::uint32_t v, const Ring& ring, bool is_boundary) {
        const double weight = is_boundary ? 1.0 / 5 : limit_weight(ring.size());
        mesh.points[v] = smoothed(level.points, v, ring, is_boundary, weight);
    });
    // Tangents of limit positions, as pbrt-v3 takes them.
    for_each_ring(edges, count, [&](std::uint32_t v, const Ring& ring, bool is_boundary) {
        mesh.normals[v] = limit_normal(mesh.points, v, ring, is_boundary);
    });
    mesh.corners = std::move(level.corners);
    return mesh;
}

}  // namespace

Result<SmoothMesh> loop_subdivision(std::span<const Vec3> points,
                                    std::span<const std::uint32_t> corners, int levels) {
    Level level{{points.begin(), points.end()}, {corners.begin(), corners.end()}};
    for (int i = 0;; ++i) {
        const std::optional<HalfEdges> edges = HalfEdges::of(level.corners, level.points.size());
        if (!edges) {
            return {{},
                    "an edge belongs to more than two triangles, or to two that turn the other "
                    "way round"};
        }
        if (i >= levels) return {limit(std::move(level), *edges), {}};
        if (4 * level.corners.size() / 3 > most_triangles) {
            return {{}, "more than 50 million triangles after so many levels"};
        }
        level = refined(level, *edges);
    }
}

}  // namespace etalon
