#include "core/light/scene_radius.h"

#include "core/intersect/kernels.h"

namespace etalon {
namespace {

Box3 box_of_primitives(const Geometry& geometry) {
    Box3 box;
    for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i) {
        const Box3 bounds = primitive_bounds(geometry, i);
        if (is_finite(bounds.min) && is_finite(bounds.max)) box.extendBy(bounds);
    }
    return box;
}

/// Extends a box by that of an object placed by a map, if that is finite.
void extend(Box3& box, const Affine& map, const Box3& object) {
    const Vec3 centre = map.point(object.center()), half = object.size() / 2;
    const Vec3 reach = half.x * abs(map.x) + half.y * abs(map.y) + half.z * abs(map.z);
    if (is_finite(centre) && is_finite(reach)) box.extendBy({centre - reach, centre + reach});
}

}  // namespace

double scene_radius(const Geometry& geometry) {
    Box3 box = box_of_primitives(geometry);
    std::vector<Box3> objects;
    for (const Geometry& object : geometry.objects) objects.push_back(box_of_primitives(object));
    for (const Instance& instance : geometry.instances) {
        const Box3& object = objects[instance.object];
        if (!object.isEmpty()) extend(box, instance.to_world(), object);
    }
    return box.isEmpty() ? 1 : box.size().length() / 2;
}

}  // namespace etalon
