#include "core/intersect/instance_bounds.h"

#include <algorithm>
#include <optional>

#include "core/intersect/kernels.h"
#include "core/intersect/motion_bounds.h"
#include "core/intersect/object_outline.h"
#include "core/intersect/placement.h"
#include "core/parallel/chunks.h"

namespace etalon {
namespace {

constexpr std::size_t chunk_size = 1024;

/// Half the scene's size with its boxes' margins, relative to that without.
constexpr double room_for_margins = 1.5;

/// Largest margin of a box, relative to that half size, that is small against the scene. Rays start
/// at least 2 half sizes before their point nearest to the centre (see normalized_ray()), and with
/// this margin all boxes are within 1.9 of it.
constexpr double largest_margin = 1.0 / 16;

std::vector<ObjectOutline> outlines_of(const std::vector<Geometry>& objects) {
    std::vector<ObjectOutline> outlines(objects.size());
    Chunks(objects.size(), 1)
        .parallel_for_each([&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) outlines[i] = ObjectOutline(objects[i]);
        });
    return outlines;
}

Box3 unpadded_moving(const AnimatedTransform& motion, const ObjectOutline& outline) {
    const MotionBounds bounds(motion);
    return bounds.exist() ? bounds.box(outline) : everywhere();
}

Box3 unpadded_still(const std::optional<Affine>& map, const ObjectOutline& outline) {
    if (map && !is_finite(*map)) return {};
    return map ? outline.image(*map) : everywhere();
}

Box3 bounded_or_everywhere(const Box3& box) {
    return box.isEmpty() || is_bounded(box) ? box : everywhere();
}

/// Quantities on which the roundings of rays to an instance depend.
struct Roundings {
    Vec3 spread;      ///< see spread()
    double distance;  ///< from the object's origin to the scene's centre
};

/// `spread` is that of an instance that does not move.
Roundings roundings_of(const Geometry& geometry, const Instance& instance, const Vec3& spread,
                       const Vec3& centre) {
    if (instance.moves()) {
        const MotionBounds motion(geometry.motions[instance.motion]);
        return {Vec3(motion.spread()), motion.distance_from(centre)};
    }
    return {spread, max_abs(instance.origin - centre)};
}

/// Returns how far the roundings of rays to the object move a hit. A ray's origin o and the hit are
/// within 2^24 S of the scene's centre, where S is half its size (NormalizedSpace::resolves), or,
/// for boxes without padding, within 8 S. In object space o' and t d' are off by at most 4 u |A|
/// (|o - c| + t |d|), which the inverse spreads. The box is off by 25 u of its distance from c. The
/// factors leave room for half as much again.
Vec3 margin_of(const Roundings& roundings, double half, const InstancePadding& padding) {
    return (padding.roundings * half + 0x1p-47 * roundings.distance) * roundings.spread;
}

/// Boxes before they are padded.
struct UnpaddedBoxes {
    explicit UnpaddedBoxes(std::size_t instances) : boxes(instances), spreads(instances) {}

    void set(std::size_t i, const Geometry& geometry, const ObjectOutline& outline) {
        const Instance& instance = geometry.instances[i];
        if (instance.moves()) {
            boxes[i] = unpadded_moving(geometry.motions[instance.motion], outline);
        } else {
            const std::optional<Affine> map = instance.precise_to_world();
            boxes[i] = unpadded_still(map, outline);
            if (map) spreads[i] = spread(instance, *map);
        }
        boxes[i] = widened(bounded_or_everywhere(boxes[i]));
    }

    LargeVector<Box3> boxes;
    LargeVector<Vec3> spreads;  ///< of instances that do not move
};

/// Pads the boxes of the instances from `begin` to before `end`, in a scene with the bounds
/// `world`. Returns the largest spread of those that stay bounded.
double pad(const Geometry& geometry, const Box3& world, const InstancePadding& padding,
           UnpaddedBoxes& unpadded, std::size_t begin, std::size_t end) {
    const Vec3 centre = world.center();
    const double half = room_for_margins * max_abs(world.max - centre);
    double spread = 1;
    for (std::size_t i = begin; i < end; ++i) {
        Box3& box = unpadded.boxes[i];
        if (!is_bounded(box)) continue;
        const Roundings roundings =
            roundings_of(geometry, geometry.instances[i], unpadded.spreads[i], centre);
        if (!(max_abs(margin_of(roundings, half, full_padding)) <= largest_margin * half)) {
            box = everywhere();
            continue;
        }
        const Vec3 margin = margin_of(roundings, half, padding);
        box = {box.min - margin, box.max + margin};
        spread = std::max(spread, max_abs(roundings.spread));
    }
    return spread;
}

}  // namespace

InstanceBounds instance_bounds(const Geometry& geometry, const Box3& others, const NearRegion& near,
                               const InstancePadding& padding) {
    const auto& instances = geometry.instances;
    if (instances.empty()) return {};
    const std::vector<ObjectOutline> outlines = outlines_of(geometry.objects);
    UnpaddedBoxes unpadded(instances.size());
    const Chunks chunks(instances.size(), chunk_size);
    std::vector<Box3> of_chunk(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            unpadded.set(i, geometry, outlines[instances[i].object]);
            if (near.contains(unpadded.boxes[i])) of_chunk[chunk].extendBy(unpadded.boxes[i]);
        }
    });
    Box3 world = others;
    for (const Box3& box : of_chunk) world.extendBy(box);
    if (world.isEmpty()) return {std::move(unpadded.boxes)};
    std::vector<double> spreads(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        spreads[chunk] = pad(geometry, world, padding, unpadded, begin, end);
    });
    const double spread = std::ranges::max(spreads);
    const double left_out = full_padding.roundings - padding.roundings;
    return {std::move(unpadded.boxes), spread, room_for_margins * left_out * spread};
}

Box3 finite_bounds(const Geometry& geometry) {
    Box3 all;
    const auto add = [&](const Box3& box) {
        if (is_bounded(box)) all.extendBy(box);
    };
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        add(whole_bounds(geometry, id));
    }
    for (const Box3& box : instance_bounds(geometry, all).boxes) add(box);
    return all;
}

}  // namespace etalon
