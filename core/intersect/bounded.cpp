#include "core/intersect/bounded.h"

#include <numeric>
#include <span>

#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/intersect/near_region.h"
#include "core/parallel/chunks.h"

namespace etalon {
namespace {

constexpr std::size_t chunk_size = 4096;

/// Summary of a part of the scene before there is a normalized space.
struct ChunkBounds {
    explicit ChunkBounds(const NearRegion& region) : near(region) {}

    NearRegion near;
    ReachCounts reaches;
    Box3 world;
    std::size_t bounded = 0;
    std::vector<std::uint32_t> unbounded;

    void add(const Box3& box, std::uint32_t id, bool is_instance = false) {
        if (near.contains(box)) {
            world.extendBy(box);
            reaches.add(near.reach_of(box), max_abs(box.size()), is_instance);
            ++bounded;
        } else if (!box.isEmpty()) {
            unbounded.push_back(id);
        }
    }

    void add(const ChunkBounds& next) {
        world.extendBy(next.world);
        reaches.add(next.reaches);
        bounded += next.bounded;
        unbounded.insert(unbounded.end(), next.unbounded.begin(), next.unbounded.end());
    }
};

/// A scene's items, sorted into bounded and unbounded ones.
struct SortedItems {
    ChunkBounds all;
    InstanceBounds instances;
    std::vector<std::size_t> offsets;  ///< of each chunk's bounded primitives; last, of instances
};

SortedItems sort_items(const Geometry& geometry, const Chunks& chunks, const NearRegion& near,
                       const InstancePadding& padding) {
    std::vector<ChunkBounds> bounds_of_chunks(chunks.number(), ChunkBounds(near));
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto id = static_cast<std::uint32_t>(i);
            bounds_of_chunks[chunk].add(whole_bounds(geometry, id), id);
        }
    });
    SortedItems sorted{ChunkBounds(near), {}, {}};
    for (const ChunkBounds& s : bounds_of_chunks) {
        sorted.offsets.push_back(sorted.all.bounded);
        sorted.all.add(s);
    }
    sorted.offsets.push_back(sorted.all.bounded);
    sorted.instances = instance_bounds(geometry, sorted.all.world, near, padding);
    auto id = static_cast<std::uint32_t>(geometry.primitives.size());
    for (const Box3& box : sorted.instances.boxes) sorted.all.add(box, id++, true);
    return sorted;
}

/// Computes the boxes a second time, which costs less than keeping them in double.
void bound(const Geometry& geometry, const NormalizedSpace& space, const NearRegion& near,
           std::size_t begin, std::size_t end, BoundedPrimitive* out) {
    for (std::size_t i = begin; i < end; ++i) {
        const auto id = static_cast<std::uint32_t>(i);
        const Box3 box = whole_bounds(geometry, id);
        if (near.contains(box)) *out++ = {space.box(box), id, geometry.primitives[i].kind};
    }
}

void bound_instances(const Geometry& geometry, const NormalizedSpace& space, const NearRegion& near,
                     double pad, std::span<const Box3> boxes, BoundedPrimitive* out) {
    auto id = static_cast<std::uint32_t>(geometry.primitives.size());
    for (const Box3& box : boxes) {
        if (near.contains(box)) *out++ = {space.box(box, pad), id, instance_kind};
        ++id;
    }
}

}  // namespace

SceneBounds SceneBounds::of(const Geometry& geometry, const InstancePadding& padding,
                            OutlierRule rule) {
    const Chunks chunks(geometry.primitives.size(), chunk_size);
    NearRegion near{middle_of(geometry)};
    SortedItems sorted = sort_items(geometry, chunks, near, padding);
    near.reach = sorted.all.reaches.limit(rule);
    if (!near.is_everything()) sorted = sort_items(geometry, chunks, near, padding);

    SceneBounds result;
    result.unbounded = std::move(sorted.all.unbounded);
    result.spread = sorted.instances.spread;
    result.space = NormalizedSpace(sorted.all.world, sorted.instances.drift);
    result.bounded.resize(sorted.all.bounded);
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        bound(geometry, result.space, near, begin, end,
              result.bounded.data() + sorted.offsets[chunk]);
    });
    bound_instances(geometry, result.space, near, padding.box, sorted.instances.boxes,
                    result.bounded.data() + sorted.offsets.back());
    result.separate_far(geometry);
    return result;
}

void SceneBounds::separate_far(const Geometry& geometry) {
    const auto is_far = [&](std::uint32_t item) {
        return !geometry.is_instance(item) && is_bounded(whole_bounds(geometry, item));
    };
    std::ranges::copy_if(unbounded, std::back_inserter(far), is_far);
    if (far.size() <= ReachCounts::few) {
        far.clear();
    } else {
        std::erase_if(unbounded, is_far);
    }
}

SceneBounds SceneBounds::none_bounded(const Geometry& geometry) {
    SceneBounds result;
    result.unbounded.resize(geometry.primitives.size());
    std::iota(result.unbounded.begin(), result.unbounded.end(), 0U);
    return result;
}

}  // namespace etalon
