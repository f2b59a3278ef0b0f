#include "native_accel/bvh/triangle_leaf.h"

#include "core/intersect/shapes/triangle.h"
#include "native_accel/bvh/triangle_filter.h"

namespace etalon {

TriangleLeaf::TriangleLeaf() : doubt{}, ids{} {
    for (auto& corner : corners) corner.fill(broadcast(std::numeric_limits<float>::quiet_NaN()));
}

void TriangleLeaf::set(std::size_t lane, const Scene& scene, const Frame& frame, std::uint32_t id) {
    const auto exact = etalon::corners(scene, scene.get<Triangle>(scene.primitives[id]));
    Box3 box;
    for (int c = 0; c < 3; ++c) {
        const Vec3 corner = frame.point(exact[c]);
        box.extendBy(corner);
        for (int k = 0; k < 3; ++k) corners[c][k][lane] = static_cast<float>(corner[k]);
    }
    doubt[lane] = TriangleFilter::edge_doubt(max_abs(box.size()));
    ids[lane] = id;
}

}  // namespace etalon
