#include "core/accel/clusters/clusters.h"

#include <algorithm>
#include <cmath>

#include "core/parallel/parallel.h"

namespace etalon {

namespace {

/// Returns the array that holds a cluster; lists of primitives and of instances share one.
ClusterRef::Kind array_of(ClusterRef::Kind kind) {
    return kind == ClusterRef::instances ? ClusterRef::list : kind;
}

bool is_single_instance(ClusterRef ref) {
    return ref.kind() == ClusterRef::instances && ref.is_single();
}

}  // namespace

std::vector<ClusterRef> cluster_refs(const Geometry& geometry, std::span<const std::uint32_t> ids,
                                     std::span<const Range> ranges) {
    std::array<std::size_t, 3> counts{};
    std::vector<ClusterRef> refs;
    refs.reserve(ranges.size());
    for (const Range& range : ranges) {
        const std::uint32_t id = ids[range.first];
        const ClusterRef::Kind kind = cluster_kind(geometry.kind_of_item(id));
        const std::size_t instance = id - geometry.primitives.size();
        if (kind == ClusterRef::instances && range.count == 1 &&
            instance < ClusterRef::most_single) {
            refs.push_back(ClusterRef::single(static_cast<std::uint32_t>(instance)));
        } else {
            refs.emplace_back(kind, counts[array_of(kind)]++);
        }
    }
    return refs;
}

Clusters::Clusters(const Geometry& geometry, const NormalizedSpace& space,
                   std::span<const std::uint32_t> ids, std::span<const Range> ranges,
                   std::span<const ClusterRef> refs)
    : first_instance_(static_cast<std::uint32_t>(geometry.primitives.size())) {
    std::array<std::size_t, 3> counts{};
    for (const ClusterRef ref : refs) {
        if (!is_single_instance(ref)) ++counts[array_of(ref.kind())];
    }
    triangles_.resize(counts[ClusterRef::triangles]);
    spheres_.resize(counts[ClusterRef::spheres]);
    lists_.resize(counts[ClusterRef::list]);

    parallel_for(ranges.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            fill(geometry, space, refs[i], ids.subspan(ranges[i].first, ranges[i].count));
        }
    });
}

void Clusters::fill(const Geometry& geometry, const NormalizedSpace& space, ClusterRef ref,
                    std::span<const std::uint32_t> ids) {
    switch (ref.kind()) {
        case ClusterRef::triangles:
            return triangles_[ref.index()].fill(geometry, space, ids);
        case ClusterRef::spheres:
            return spheres_[ref.index()].fill(geometry, space, ids);
        default:
            if (is_single_instance(ref)) return;
            lists_[ref.index()].fill(no_index);
            std::copy(ids.begin(), ids.end(), lists_[ref.index()].begin());
    }
}

std::size_t Clusters::size(ClusterRef ref) const {
    const auto taken = [](const Lanes& lanes) {
        return std::count_if(lanes.begin(), lanes.end(), [](float x) { return !std::isnan(x); });
    };
    const auto count = [&] {
        switch (ref.kind()) {
            case ClusterRef::triangles:
                return taken(triangles(ref).corners[0][0]);
            case ClusterRef::spheres:
                return taken(spheres(ref).radius);
            default:
                if (is_single_instance(ref)) return std::ptrdiff_t{1};
                const List& list = lists_[ref.index()];
                return static_cast<std::ptrdiff_t>(cluster_lanes) -
                       std::count(list.begin(), list.end(), no_index);
        }
    };
    return static_cast<std::size_t>(count());
}

std::size_t Clusters::memory_bytes() const {
    return triangles_.capacity() * sizeof(TriangleCluster) +
           spheres_.capacity() * sizeof(SphereCluster) + lists_.capacity() * sizeof(List);
}

}  // namespace etalon
