#include "core/light/scene_radius.h"

#include "core/intersect/kernels.h"
#include "core/intersect/motion_bounds.h"

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

/// Returns the box of an instance at all times; where its map is singular at some time, the one
/// when the shutter opens.
Box3 box_of(const Geometry& geometry, const Instance& instance, const Box3& object) {
    if (instance.moves()) {
        const MotionBounds bounds(geometry.motions[instance.motion]);
        if (bounds.exist()) return bounds.box(object);
    }
    return image(instance.to_world(), object);
}

}  // namespace

double scene_radius(const Geometry& geometry) {
    Box3 box = box_of_primitives(geometry);
    std::vector<Box3> objects;
    for (const Geometry& object : geometry.objects) objects.push_back(box_of_primitives(object));
    for (const Instance& instance : geometry.instances) {
        const Box3& object = objects[instance.object];
        if (object.isEmpty()) continue;
        const Box3 bounds = box_of(geometry, instance, object);
        if (is_finite(bounds.min) && is_finite(bounds.max)) box.extendBy(bounds);
    }
    return box.isEmpty() ? 1 : box.size().length() / 2;
}

}  // namespace etalon
