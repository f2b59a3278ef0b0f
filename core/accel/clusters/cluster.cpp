#include "core/accel/clusters/cluster.h"

#include <algorithm>
#include <limits>

#include "core/accel/clusters/error_bounds.h"
#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

/// Returns the primitive number of each lane; unused lanes repeat the last.
Ids spread(std::span<const std::uint32_t> all) {
    Ids ids;
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        ids[lane] = all[std::min(lane, all.size() - 1)];
    }
    return ids;
}

}  // namespace

/// Fills all lanes step by step, so that the cache misses of reading corners overlap: they take
/// most of the time of building.
void TriangleCluster::fill(const Geometry& geometry, const NormalizedSpace& space,
                           std::span<const std::uint32_t> all) {
    ids = spread(all);
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        const Primitive primitive = geometry.primitives[ids[lane]];
        vertices[lane] = geometry.get<Triangle>(primitive).vertices;
        sides[lane] = primitive.sides;
    }
    std::array<std::array<Vec3, 3>, cluster_lanes> exact;
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        exact[lane] = etalon::corners(geometry, Triangle{vertices[lane]});
    }
    error_bound = 0;
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        Box3 box;
        for (int c = 0; c < 3; ++c) {
            const Vec3 corner = space.point(exact[lane][c]);
            box.extendBy(corner);
            for (int k = 0; k < 3; ++k) {
                corners[c][k][lane] = lane < all.size() ? static_cast<float>(corner[k]) : nothing;
            }
        }
        error_bound = std::max(error_bound, edge_error_bound(max_abs(box.size())));
    }
}

void SphereCluster::fill(const Geometry& geometry, const NormalizedSpace& space,
                         std::span<const std::uint32_t> all) {
    ids = spread(all);
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        const Primitive primitive = geometry.primitives[ids[lane]];
        const Sphere& sphere = geometry.get<Sphere>(primitive);
        const Vec3 place = space.point(sphere.centre);
        for (int k = 0; k < 3; ++k) centre[k][lane] = static_cast<float>(place[k]);
        radius[lane] = lane < all.size() ? enlarged_radius(sphere.radius * space.scale()) : nothing;
        sides[lane] = primitive.sides;
        exact[lane] = sphere;
    }
}

}  // namespace etalon
