#include "core/intersect/clusters/cluster.h"

#include <algorithm>
#include <limits>

#include "core/intersect/clusters/doubt.h"
#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TriangleCluster::TriangleCluster() {
    for (auto& corner : corners) {
        for (Lanes& axis : corner) axis.fill(nothing);
    }
}

void TriangleCluster::set(std::size_t lane, const Scene& scene, const Frame& frame,
                          std::uint32_t id) {
    const Primitive& primitive = scene.primitives[id];
    const Triangle& triangle = scene.get<Triangle>(primitive);
    const auto exact = etalon::corners(scene, triangle);
    Box3 box;
    for (int c = 0; c < 3; ++c) {
        const Vec3 corner = frame.point(exact[c]);
        box.extendBy(corner);
        for (int k = 0; k < 3; ++k) corners[c][k][lane] = static_cast<float>(corner[k]);
    }
    doubt = std::max(doubt, edge_doubt(max_abs(box.size())));
    sides[lane] = primitive.sides;
    members[lane] = {id, triangle.vertices};
}

SphereCluster::SphereCluster() {
    for (Lanes& axis : centre) axis.fill(nothing);
    radius.fill(nothing);
    ids.fill(no_index);
}

void SphereCluster::set(std::size_t lane, const Scene& scene, const Frame& frame,
                        std::uint32_t id) {
    const Primitive& primitive = scene.primitives[id];
    const Sphere& sphere = scene.get<Sphere>(primitive);
    const Vec3 place = frame.point(sphere.centre);
    for (int k = 0; k < 3; ++k) centre[k][lane] = static_cast<float>(place[k]);
    radius[lane] = enlarged_radius(sphere.radius * frame.scale());
    ids[lane] = id;
    sides[lane] = primitive.sides;
    exact[lane] = sphere;
}

}  // namespace etalon
