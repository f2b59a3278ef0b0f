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

}  // namespace

void TriangleCluster::fill(const Scene& scene, const Frame& frame,
                           std::span<const std::uint32_t> all) {
    std::array<std::array<Vec3, 3>, cluster_lanes> places;
    Box3 around;
    double extent = 0;
    for (std::size_t lane = 0; lane < all.size(); ++lane) {
        const Primitive& primitive = scene.primitives[all[lane]];
        const Triangle& triangle = scene.get<Triangle>(primitive);
        ids[lane] = all[lane];
        vertices[lane] = triangle.vertices;
        sides[lane] = primitive.sides;
        taken |= 1U << lane;
        Box3 box;
        for (int c = 0; c < 3; ++c) {
            places[lane][c] = frame.point(scene.vertices[triangle.vertices[c]]);
            box.extendBy(places[lane][c]);
        }
        around.extendBy(box);
        extent = std::max(extent, max_abs(box.size()));
    }
    base = float_down(around.min);
    steps_per_unit = etalon::steps_per_unit(max_abs(around.max - Vec3(base)));
    doubt = edge_doubt(extent, steps_per_unit);
    for (std::size_t lane = 0; lane < all.size(); ++lane) {
        for (int c = 0; c < 3; ++c) {
            const Vec3 steps = (places[lane][c] - Vec3(base)) * steps_per_unit;
            for (int k = 0; k < 3; ++k) {
                corners[c][k][lane] = static_cast<std::uint16_t>(steps[k] + 0.5);
            }
        }
    }
}

SphereCluster::SphereCluster() {
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    for (Lanes& axis : centre) axis.fill(nothing);
    radius.fill(nothing);
}

void SphereCluster::fill(const Scene& scene, const Frame& frame,
                         std::span<const std::uint32_t> all) {
    for (std::size_t lane = 0; lane < all.size(); ++lane) {
        const Primitive& primitive = scene.primitives[all[lane]];
        const Sphere& sphere = scene.get<Sphere>(primitive);
        const Vec3 place = frame.point(sphere.centre);
        for (int k = 0; k < 3; ++k) centre[k][lane] = static_cast<float>(place[k]);
        radius[lane] = enlarged_radius(sphere.radius * frame.scale());
        ids[lane] = all[lane];
        sides[lane] = primitive.sides;
        exact[lane] = sphere;
    }
}

}  // namespace etalon
