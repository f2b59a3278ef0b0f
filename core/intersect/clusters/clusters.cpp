#include "core/intersect/clusters/clusters.h"

#include <algorithm>

#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// That of all, or a list.
ClusterRef::Kind kind_for(const Scene& scene, std::span<const std::uint32_t> ids) {
    const ClusterRef::Kind kind = cluster_kind(scene.primitives[ids[0]].kind);
    const bool alike = std::all_of(ids.begin(), ids.end(), [&](std::uint32_t id) {
        return cluster_kind(scene.primitives[id].kind) == kind;
    });
    return alike ? kind : ClusterRef::list;
}

}  // namespace

Clusters::Clusters(const Scene& scene, const Frame& frame, std::span<const std::uint32_t> ids,
                   std::span<const Range> ranges, std::vector<ClusterRef>& refs) {
    std::array<std::size_t, 3> counts{};
    refs.clear();
    refs.reserve(ranges.size());
    for (const Range& range : ranges) {
        const ClusterRef::Kind kind = kind_for(scene, ids.subspan(range.first, range.count));
        refs.emplace_back(kind, counts[kind]++);
    }
    triangles_.resize(counts[ClusterRef::triangles]);
    spheres_.resize(counts[ClusterRef::spheres]);
    lists_.resize(counts[ClusterRef::list]);

    parallel_for(ranges.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            fill(scene, frame, refs[i], ids.subspan(ranges[i].first, ranges[i].count));
        }
    });
}

void Clusters::fill(const Scene& scene, const Frame& frame, ClusterRef ref,
                    std::span<const std::uint32_t> ids) {
    if (ref.kind() == ClusterRef::list) {
        lists_[ref.index()].fill(no_index);
        std::copy(ids.begin(), ids.end(), lists_[ref.index()].begin());
        return;
    }
    for (std::size_t lane = 0; lane < ids.size(); ++lane) {
        if (ref.kind() == ClusterRef::triangles) {
            triangles_[ref.index()].set(lane, scene, frame, ids[lane]);
        } else {
            spheres_[ref.index()].set(lane, scene, frame, ids[lane]);
        }
    }
}

std::size_t Clusters::size(ClusterRef ref) const {
    const auto id_at = [&](std::size_t lane) {
        switch (ref.kind()) {
            case ClusterRef::triangles:
                return triangles(ref).members[lane].id;
            case ClusterRef::spheres:
                return spheres(ref).ids[lane];
            default:
                return lists_[ref.index()][lane];
        }
    };
    std::size_t count = 0;
    while (count < cluster_lanes && id_at(count) != no_index) ++count;
    return count;
}

std::size_t Clusters::memory_bytes() const {
    return triangles_.capacity() * sizeof(TriangleCluster) +
           spheres_.capacity() * sizeof(SphereCluster) + lists_.capacity() * sizeof(List);
}

}  // namespace etalon
