#include "core/intersect/instance_bounds.h"

#include <algorithm>
#include <span>

#include "core/intersect/kernels.h"
#include "core/intersect/motion_bounds.h"
#include "core/intersect/placement.h"
#include "core/parallel/chunks.h"

namespace etalon {
namespace {

constexpr std::size_t chunk_size = 1024;

const Box3& everywhere() {
    static const Box3 box(Vec3(-infinity), Vec3(infinity));
    return box;
}

bool is_bounded(const Box3& box) {
    return is_finite(box.min) && is_finite(box.max);
}

/// An object as the boxes of what lies in the octants about its centre. Transformed to world space
/// they are smaller than the box of a single one.
struct Outline {
    struct Part {
        Vec3 centre, half;
    };

    std::vector<Part> parts;
    bool is_unbounded = false;
};

Box3 box_of(const Geometry& object) {
    Box3 all;
    for (std::uint32_t id = 0; id < object.primitives.size(); ++id) {
        all.extendBy(whole_bounds(object, id));
    }
    return all;
}

Outline outline_of(const Geometry& object) {
    const Box3 all = box_of(object);
    if (all.isEmpty() || !is_bounded(all)) return {{}, !all.isEmpty()};
    const Vec3 centre = all.center();
    std::array<Box3, 8> octants;
    for (std::uint32_t id = 0; id < object.primitives.size(); ++id) {
        const Box3 box = whole_bounds(object, id);
        if (box.isEmpty()) continue;
        const Vec3 c = box.center();
        octants[(c.x < centre.x ? 1U : 0U) + (c.y < centre.y ? 2U : 0U) +
                (c.z < centre.z ? 4U : 0U)]
            .extendBy(box);
    }
    Outline outline;
    for (const Box3& box : octants) {
        if (!box.isEmpty()) outline.parts.push_back({box.center(), box.size() / 2});
    }
    return outline;
}

std::vector<Outline> outlines_of(const std::vector<Geometry>& objects) {
    std::vector<Outline> outlines(objects.size());
    Chunks(objects.size(), 1)
        .parallel_for_each([&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) outlines[i] = outline_of(objects[i]);
        });
    return outlines;
}

/// Extends a box by the box of a part's image; `magnitudes` are the magnitudes of the map's axes.
void extend(Box3& box, const Affine& map, const Affine& magnitudes, const Outline::Part& part) {
    const Vec3 centre = map.point(part.centre), reach = magnitudes.vector(part.half);
    for (int k = 0; k < 3; ++k) {
        box.min[k] = std::min(box.min[k], centre[k] - reach[k]);
        box.max[k] = std::max(box.max[k], centre[k] + reach[k]);
    }
}

/// Returns the union of what `add` adds to a box for each part of an outline.
template <class Add>
Box3 box_of_places(const Outline& outline, const Add& add) {
    if (outline.is_unbounded) return everywhere();
    Box3 world;
    for (const Outline::Part& part : outline.parts) add(world, part);
    return outline.parts.empty() || is_bounded(world) ? world : everywhere();
}

Box3 unpadded_moving(const AnimatedTransform& motion, const Outline& outline) {
    const MotionBounds bounds(motion);
    if (!bounds.exist()) return everywhere();
    return box_of_places(outline, [&](Box3& world, const Outline::Part& part) {
        world.extendBy(bounds.box({part.centre - part.half, part.centre + part.half}));
    });
}

Box3 unpadded(const Geometry& geometry, const Instance& instance, const Outline& outline) {
    if (instance.moves()) return unpadded_moving(geometry.motions[instance.motion], outline);
    const Affine map = instance.to_world();
    if (!is_finite(map)) return {};
    const Affine magnitudes{abs(map.x), abs(map.y), abs(map.z), Vec3(0)};
    return box_of_places(outline, [&](Box3& world, const Outline::Part& part) {
        extend(world, map, magnitudes, part);
    });
}

/// Quantities on which the roundings of rays to an instance depend.
struct Roundings {
    Vec3 spread;      ///< see spread()
    double distance;  ///< from the object's origin to the scene's centre
};

Roundings roundings_of(const Geometry& geometry, const Instance& instance, const Vec3& centre) {
    if (instance.moves()) {
        const MotionBounds motion(geometry.motions[instance.motion]);
        return {Vec3(motion.spread()), motion.distance_from(centre)};
    }
    return {spread(instance), max_abs(instance.origin - centre)};
}

/// Returns how far the roundings of rays to the object move a hit. A ray's origin o and the hit are
/// within 2^24 S of the scene's centre, where S is half its size (NormalizedSpace::resolves), or,
/// for boxes without padding, within 8 S. In object space o' and t d' are off by at most 4 u |A|
/// (|o - c| + t |d|), which the inverse spreads. The factors leave room for three times as much.
Vec3 margin_of(const Roundings& roundings, double half, const InstancePadding& padding) {
    return (padding.roundings * half + 0x1p-48 * roundings.distance) * roundings.spread;
}

/// Pads the boxes of the instances from number `first` on, in a scene with the bounds `world`.
/// Returns the largest spread of those that stay bounded.
double pad(const Geometry& geometry, const Box3& world, const InstancePadding& padding,
           std::span<Box3> boxes, std::size_t first) {
    const Vec3 centre = world.center();
    const double half = 1.5 * max_abs(world.max - centre);  // with room for the margins
    double spread = 1;
    for (Box3& box : boxes) {
        const Instance& instance = geometry.instances[first++];
        if (box.isEmpty() || !is_bounded(box)) continue;
        const Roundings roundings = roundings_of(geometry, instance, centre);
        if (!(max_abs(margin_of(roundings, half, full_padding)) <= half / 8)) {
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

InstanceBounds instance_bounds(const Geometry& geometry, const Box3& others, double limit,
                               const InstancePadding& padding) {
    const auto& instances = geometry.instances;
    InstanceBounds result{std::vector<Box3>(instances.size())};
    if (instances.empty()) return result;
    const std::vector<Outline> outlines = outlines_of(geometry.objects);
    const Chunks chunks(instances.size(), chunk_size);
    std::vector<Box3> of_chunk(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Box3& box = result.boxes[i];
            box = widened(unpadded(geometry, instances[i], outlines[instances[i].object]));
            if (is_bounded(box, limit)) of_chunk[chunk].extendBy(box);
        }
    });
    Box3 world = others;
    for (const Box3& box : of_chunk) world.extendBy(box);
    if (world.isEmpty()) return result;
    std::vector<double> spreads(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        const std::span boxes(result.boxes);
        spreads[chunk] = pad(geometry, world, padding, boxes.subspan(begin, end - begin), begin);
    });
    result.spread = std::ranges::max(spreads);
    return result;
}

Box3 finite_bounds(const Geometry& geometry) {
    Box3 all;
    const auto add = [&](const Box3& box) {
        if (!box.isEmpty() && is_bounded(box)) all.extendBy(box);
    };
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        add(whole_bounds(geometry, id));
    }
    for (const Box3& box : instance_bounds(geometry, all).boxes) add(box);
    return all;
}

}  // namespace etalon
