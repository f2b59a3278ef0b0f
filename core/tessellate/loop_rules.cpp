#include "core/tessellate/loop_rules.h"

#include <cmath>
#include <numbers>

namespace etalon {
namespace {

/// Returns the weight of each neighbour of an inner vertex.
double even_weight(double valence) {
    return valence == 3 ? 3.0 / 16 : 3 / (8 * valence);
}

double limit_weight(double valence) {
    return 1 / (valence + 3 / (8 * even_weight(valence)));
}

/// Returns the weighted mean of a vertex and its neighbours, each of which has the weight `weight`.
Vec3 inner_mean(const Vec3& vertex, const Ring& ring, double weight) {
    Vec3 sum(0);
    for (const Vec3& p : ring.points) sum += p;
    return (1 - static_cast<double>(ring.points.size()) * weight) * vertex + weight * sum;
}

/// The same along a boundary, which depends only on the boundary.
Vec3 boundary_mean(const Vec3& vertex, const Ring& ring, double weight) {
    return (1 - 2 * weight) * vertex + weight * (ring.points.front() + ring.points.back());
}

/// Returns the tangent across a boundary.
Vec3 tangent_across(const Vec3& vertex, const std::vector<Vec3>& ring) {
    const std::size_t n = ring.size();
    if (n == 2) return ring[0] + ring[1] - 2.0 * vertex;
    if (n == 3) return ring[1] - vertex;
    if (n == 4) return 2.0 * (ring[1] + ring[2]) - ring[0] - ring[3] - 2.0 * vertex;
    const double angle = std::numbers::pi / static_cast<double>(n - 1);
    Vec3 sum = std::sin(angle) * (ring.front() + ring.back());
    for (std::size_t k = 1; k + 1 < n; ++k) {
        sum += (2 * std::cos(angle) - 2) * std::sin(static_cast<double>(k) * angle) * ring[k];
    }
    return -sum;
}

}  // namespace

void Ring::gather(const LoopMesh& mesh, std::uint32_t vertex) {
    const HalfEdges& sides = mesh.sides;
    const std::uint32_t start = mesh.starts[vertex];
    points.clear();
    std::uint32_t side = start, turned;
    do {
        points.push_back(mesh.positions[sides.target(side)]);
        turned = sides.turned(side);
    } while (turned != HalfEdges::none && (side = turned) != start);
    is_open = turned == HalfEdges::none;
    if (!is_open) return;
    points.assign(1, mesh.positions[sides.target(side)]);
    for (; side != HalfEdges::none; side = sides.turned_back(side)) {
        points.push_back(mesh.positions[sides.origins[HalfEdges::previous(side)]]);
    }
}

Vec3 even_position(const Vec3& vertex, const Ring& ring) {
    if (ring.is_open) return boundary_mean(vertex, ring, 1.0 / 8);
    return inner_mean(vertex, ring, even_weight(static_cast<double>(ring.points.size())));
}

Vec3 odd_position(const LoopMesh& mesh, std::uint32_t side) {
    const HalfEdges& sides = mesh.sides;
    const auto opposite = [&](std::uint32_t s) {
        return mesh.positions[sides.origins[HalfEdges::previous(s)]];
    };
    const Vec3 ends = mesh.positions[sides.origins[side]] + mesh.positions[sides.target(side)];
    const std::uint32_t twin = sides.twins[side];
    if (twin == HalfEdges::none) return 0.5 * ends;
    return 3.0 / 8 * ends + 1.0 / 8 * (opposite(side) + opposite(twin));
}

Vec3 limit_position(const Vec3& vertex, const Ring& ring) {
    if (ring.is_open) return boundary_mean(vertex, ring, 1.0 / 5);
    return inner_mean(vertex, ring, limit_weight(static_cast<double>(ring.points.size())));
}

Vec3 limit_normal(const Vec3& vertex, const Ring& ring) {
    if (ring.is_open) {
        return (ring.points.back() - ring.points.front())
            .cross(tangent_across(vertex, ring.points));
    }
    Vec3 s(0), t(0);
    const double step = 2 * std::numbers::pi / static_cast<double>(ring.points.size());
    for (std::size_t j = 0; j < ring.points.size(); ++j) {
        s += std::cos(static_cast<double>(j) * step) * ring.points[j];
        t += std::sin(static_cast<double>(j) * step) * ring.points[j];
    }
    return s.cross(t);
}

}  // namespace etalon
