#include "core/intersect/instance_bounds.h"

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

/// An object by the boxes of what lies in the octants about its centre: turned into the world they
/// reach less far than one box of all.
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

/// Extends a box by that of the image of a part; `magnitudes` are those of the map's axes.
void extend(Box3& box, const Affine& map, const Affine& magnitudes, const Outline::Part& part) {
    const Vec3 centre = map.point(part.centre), reach = magnitudes.vector(part.half);
    for (int k = 0; k < 3; ++k) {
        box.min[k] = std::min(box.min[k], centre[k] - reach[k]);
        box.max[k] = std::max(box.max[k], centre[k] + reach[k]);
    }
}

/// Returns the box of all that `add` adds to a box for each part of an outline.
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

/// What roundings of rays to an instance depend on.
struct Roundings {
    Vec3 spread;      ///< see spread()
    double distance;  ///< of the object's origin from the scene's centre
};

Roundings roundings_of(const Geometry& geometry, const Instance& instance, const Vec3& centre) {
    if (instance.moves()) {
        const MotionBounds motion(geometry.motions[instance.motion]);
        return {Vec3(motion.spread()), motion.distance_from(centre)};
    }
    return {spread(instance), max_abs(instance.origin - centre)};
}

/// Pads a box by what roundings of rays to the object move a hit. A ray's origin o and the place of
/// the hit are within 2^24 S of the scene's centre, S half its size (NormalizedSpace::resolves);
/// o' and t d' are good to 4 u |A| (|o - c| + t |d|), which the inverse spreads. The factors leave
/// room for three times as much.
Box3 padded(const Box3& box, const Roundings& roundings, double half) {
    const double reach = 0x1p-24 * half + 0x1p-48 * roundings.distance;
    const Vec3 margin = reach * roundings.spread;
    if (!(max_abs(margin) <= half / 8)) return everywhere();
    return {box.min - margin, box.max + margin};
}

}  // namespace

std::vector<Box3> instance_bounds(const Geometry& geometry, const Box3& others, double limit) {
    const auto& instances = geometry.instances;
    std::vector<Box3> boxes(instances.size());
    if (instances.empty()) return boxes;
    const std::vector<Outline> outlines = outlines_of(geometry.objects);
    const Chunks chunks(instances.size(), chunk_size);
    std::vector<Box3> of_chunk(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            boxes[i] = widened(unpadded(geometry, instances[i], outlines[instances[i].object]));
            if (is_bounded(boxes[i], limit)) of_chunk[chunk].extendBy(boxes[i]);
        }
    });
    Box3 world = others;
    for (const Box3& box : of_chunk) world.extendBy(box);
    if (world.isEmpty()) return boxes;
    const Vec3 centre = world.center();
    const double half = 1.5 * max_abs(world.max - centre);  // with room for the margins
    chunks.parallel_for_each([&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (boxes[i].isEmpty() || !is_bounded(boxes[i])) continue;
            boxes[i] = padded(boxes[i], roundings_of(geometry, instances[i], centre), half);
        }
    });
    return boxes;
}

Box3 finite_bounds(const Geometry& geometry) {
    Box3 all;
    const auto add = [&](const Box3& box) {
        if (!box.isEmpty() && is_bounded(box)) all.extendBy(box);
    };
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        add(whole_bounds(geometry, id));
    }
    for (const Box3& box : instance_bounds(geometry, all)) add(box);
    return all;
}

}  // namespace etalon
