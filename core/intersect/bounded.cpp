#include "core/intersect/bounded.h"

#include <numeric>

#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/parallel/chunks.h"

namespace etalon {
namespace {

constexpr std::size_t chunk_size = 4096;

bool is_bounded(const Box3& box) {
    return !box.isEmpty() && is_finite(box.min) && is_finite(box.max);
}

/// Summary of a piece of the scene before there is a normalized space.
struct BoundsSummary {
    Box3 world;
    std::size_t bounded = 0;
    std::vector<std::uint32_t> unbounded;

    void add(const Box3& box, std::uint32_t id) {
        if (is_bounded(box)) {
            world.extendBy(box);
            ++bounded;
        } else if (!box.isEmpty()) {
            unbounded.push_back(id);
        }
    }
};

BoundsSummary summarize_bounds(const Geometry& geometry, std::size_t begin, std::size_t end) {
    BoundsSummary result;
    for (std::size_t i = begin; i < end; ++i) {
        const auto id = static_cast<std::uint32_t>(i);
        result.add(primitive_bounds(geometry, id), id);
    }
    return result;
}

/// Summary of all instances, whose boxes are given.
BoundsSummary summarize_bounds(const Geometry& geometry, const std::vector<Box3>& instances) {
    BoundsSummary result;
    auto id = static_cast<std::uint32_t>(geometry.primitives.size());
    for (const Box3& box : instances) result.add(box, id++);
    return result;
}

/// The boxes are asked for a second time: that costs less than to keep them in double.
void bound(const Geometry& geometry, const NormalizedSpace& space, std::size_t begin,
           std::size_t end, BoundedPrimitive* out) {
    for (std::size_t i = begin; i < end; ++i) {
        const auto id = static_cast<std::uint32_t>(i);
        const Box3 box = primitive_bounds(geometry, id);
        if (is_bounded(box)) *out++ = {space.box(box), id, geometry.primitives[i].kind};
    }
}

void bound_instances(const Geometry& geometry, const NormalizedSpace& space,
                     const std::vector<Box3>& boxes, BoundedPrimitive* out) {
    auto id = static_cast<std::uint32_t>(geometry.primitives.size());
    for (const Box3& box : boxes) {
        if (is_bounded(box)) *out++ = {space.box(box), id, instance_kind};
        ++id;
    }
}

}  // namespace

SceneBounds SceneBounds::of(const Geometry& geometry) {
    const Chunks chunks(geometry.primitives.size(), chunk_size);
    std::vector<BoundsSummary> summaries(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        summaries[chunk] = summarize_bounds(geometry, begin, end);
    });

    SceneBounds result;
    Box3 world;
    std::vector<std::size_t> offsets;
    std::size_t count = 0;
    for (const BoundsSummary& s : summaries) world.extendBy(s.world);
    const std::vector<Box3> instances = instance_bounds(geometry, world);
    summaries.push_back(summarize_bounds(geometry, instances));
    world.extendBy(summaries.back().world);
    for (const BoundsSummary& s : summaries) {
        offsets.push_back(count);
        count += s.bounded;
        result.unbounded.insert(result.unbounded.end(), s.unbounded.begin(), s.unbounded.end());
    }
    result.space = NormalizedSpace(world);
    result.bounded.resize(count);
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        bound(geometry, result.space, begin, end, result.bounded.data() + offsets[chunk]);
    });
    bound_instances(geometry, result.space, instances, result.bounded.data() + offsets.back());
    return result;
}

SceneBounds SceneBounds::none_bounded(const Geometry& geometry) {
    SceneBounds result;
    result.unbounded.resize(geometry.primitives.size());
    std::iota(result.unbounded.begin(), result.unbounded.end(), 0U);
    return result;
}

}  // namespace etalon
