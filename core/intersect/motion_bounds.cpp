#include "core/intersect/motion_bounds.h"

#include <algorithm>
#include <cmath>

#include "core/intersect/near_region.h"
#include "core/scene/instance.h"

namespace etalon {
namespace {

/// Returns the root of the sum of the squares of three vectors' components.
double norm(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::sqrt(a.dot(a) + b.dot(b) + c.dot(c));
}

}  // namespace

Box3 image(const Affine& map, const Box3& box) {
    const Vec3 half = box.size() / 2, centre = map.point(box.center());
    const Vec3 reach = half.x * abs(map.x) + half.y * abs(map.y) + half.z * abs(map.z);
    return {centre - reach, centre + reach};
}

/// Bounds the spread. A component of |A^-1| |A| v is at most sqrt(3) times the norms of the two
/// matrices, which are those of the stretch S and of its inverse. At the end of a slice the
/// smallest singular value of S is at least 1 / |S^-1|; from there it changes by no more than S
/// does in half a slice. The norm of the inverse is at most sqrt(3) over it.
MotionBounds::MotionBounds(const AnimatedTransform& motion) : motion_(motion) {
    const double first = motion.times().part(0), last = motion.times().part(last_shutter_time);
    length_ = std::abs(last - first) / slices;
    double largest = 0, smallest = infinity;
    for (std::size_t i = 0; i <= slices; ++i) {
        const double part = first + (last - first) * (static_cast<double>(i) / slices);
        maps_[i] = motion.at_part(part);
        const Instance instance(maps_[i], 0);
        if (!instance.exists()) return;
        const auto& [x, y, z] = instance.rows;
        largest = std::max(largest, norm(maps_[i].x, maps_[i].y, maps_[i].z));
        smallest = std::min(smallest, 1 / norm(x, y, z));
    }
    smallest -= motion.stretch_change(length_ / 2);
    if (smallest > 0) spread_ = 3 * largest / smallest;
}

template <class Image>
Box3 MotionBounds::box_of_images(const Box3& box, const Image& image) const {
    Box3 all;
    for (const Affine& map : maps_) all.extendBy(image(map));
    const Vec3 margin(motion_.deviation(box, length_));
    return {all.min - margin, all.max + margin};
}

Box3 MotionBounds::box(const Box3& box) const {
    return box_of_images(box, [&](const Affine& map) { return image(map, box); });
}

Box3 MotionBounds::box(const ObjectOutline& outline) const {
    if (!is_bounded(outline.box())) return outline.box();
    return box_of_images(outline.box(), [&](const Affine& map) { return outline.image(map); });
}

/// The origin moves along a straight line, so one of its ends is the furthest.
double MotionBounds::distance_from(const Vec3& point) const {
    return std::max(max_abs(maps_.front().origin - point), max_abs(maps_.back().origin - point));
}

}  // namespace etalon
