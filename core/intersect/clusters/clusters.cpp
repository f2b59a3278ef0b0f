#include "core/intersect/clusters/clusters.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/parallel/parallel.h"

namespace etalon {

Clusters::Clusters(const Scene& scene, const Frame& frame, std::span<const std::uint32_t> ids,
                   std::span<const Range> ranges, std::vector<ClusterRef>& refs) {
    std::array<std::size_t, 3> counts{};
    refs.clear();
    refs.reserve(ranges.size());
    for (const Range& range : ranges) {
        const ClusterRef::Kind kind = cluster_kind(scene.primitives[ids[range.first]].kind);
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
    switch (ref.kind()) {
        case ClusterRef::triangles:
            return triangles_[ref.index()].fill(scene, frame, ids);
        case ClusterRef::spheres:
            return spheres_[ref.index()].fill(scene, frame, ids);
        default:
            lists_[ref.index()].fill(no_index);
            std::copy(ids.begin(), ids.end(), lists_[ref.index()].begin());
    }
}

std::size_t Clusters::size(ClusterRef ref) const {
    const auto lanes_where = [](const auto& lanes, const auto& holds) {
        return static_cast<std::size_t>(std::count_if(lanes.begin(), lanes.end(), holds));
    };
    switch (ref.kind()) {
        case ClusterRef::triangles:
            return static_cast<std::size_t>(std::popcount(triangles(ref).taken));
        case ClusterRef::spheres:
            return lanes_where(spheres(ref).radius, [](float r) { return !std::isnan(r); });
        default:
            return lanes_where(lists_[ref.index()], [](auto id) { return id != no_index; });
    }
}

std::size_t Clusters::memory_bytes() const {
    return triangles_.capacity() * sizeof(TriangleCluster) +
           spheres_.capacity() * sizeof(SphereCluster) + lists_.capacity() * sizeof(List);
}

}  // namespace etalon
