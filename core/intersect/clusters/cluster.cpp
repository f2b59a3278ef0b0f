#include "core/intersect/clusters/cluster.h"

#include <algorithm>
#include <limits>

#include "core/intersect/clusters/doubt.h"
#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

/// Of so large an extent.
float steps_per_unit(double extent) {
    constexpr double most = 65535, finest = 0x1p-40;
    return static_cast<float>(power_of_two_reciprocal(std::max(extent / most, finest)) / 2);
}

/// Each lane's; those that are not taken repeat the last.
Ids spread(std::span<const std::uint32_t> all) {
    Ids ids;
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        ids[lane] = all[std::min(lane, all.size() - 1)];
    }
    return ids;
}

/// Where they are in the scene, and brought into the caches all at once.
std::array<const Primitive*, cluster_lanes> look_up(const Scene& scene, const Ids& ids) {
    std::array<const Primitive*, cluster_lanes> primitives;
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        primitives[lane] = &scene.primitives[ids[lane]];
        __builtin_prefetch(primitives[lane]);
    }
    return primitives;
}

}  // namespace

/// All lanes step by step, so that their cache misses on the way to the corners overlap: they are
/// most of what building takes.
void TriangleCluster::fill(const Scene& scene, const Frame& frame,
                           std::span<const std::uint32_t> all) {
    ids = spread(all);
    taken = (1U << all.size()) - 1;
    const auto primitives = look_up(scene, ids);
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        vertices[lane] = scene.get<Triangle>(*primitives[lane]).vertices;
        sides[lane] = primitives[lane]->sides;
    }
    std::array<std::array<Vec3, 3>, cluster_lanes> places;
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        for (int c = 0; c < 3; ++c) places[lane][c] = scene.vertices[vertices[lane][c]];
    }
    for (auto& corners_of_one : places) {
        for (Vec3& place : corners_of_one) place = frame.point(place);
    }
    set_corners(places);
}

void TriangleCluster::set_corners(const std::array<std::array<Vec3, 3>, cluster_lanes>& places) {
    Box3 around;
    double extent = 0;
    for (const auto& of_one : places) {
        Box3 box;
        for (const Vec3& place : of_one) box.extendBy(place);
        around.extendBy(box);
        extent = std::max(extent, max_abs(box.size()));
    }
    base = float_down(around.min);
    steps_per_unit = etalon::steps_per_unit(max_abs(around.max - Vec3(base)));
    doubt = edge_doubt(extent, steps_per_unit);
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        for (int c = 0; c < 3; ++c) {
            const Vec3 steps = (places[lane][c] - Vec3(base)) * steps_per_unit;
            for (int k = 0; k < 3; ++k) {
                corners[c][k][lane] = static_cast<std::uint16_t>(steps[k] + 0.5);
            }
        }
    }
}

void SphereCluster::fill(const Scene& scene, const Frame& frame,
                         std::span<const std::uint32_t> all) {
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    ids = spread(all);
    const auto primitives = look_up(scene, ids);
    for (std::size_t lane = 0; lane < cluster_lanes; ++lane) {
        const Sphere& sphere = scene.get<Sphere>(*primitives[lane]);
        const Vec3 place = frame.point(sphere.centre);
        for (int k = 0; k < 3; ++k) centre[k][lane] = static_cast<float>(place[k]);
        radius[lane] = lane < all.size() ? enlarged_radius(sphere.radius * frame.scale()) : nothing;
        sides[lane] = primitives[lane]->sides;
        exact[lane] = sphere;
    }
}

}  // namespace etalon
