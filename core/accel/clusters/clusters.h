#pragma once

#include <span>
#include <vector>

#include "core/accel/clusters/cluster.h"
#include "core/intersect/kernels.h"
#include "core/parallel/large_pages.h"

namespace etalon {

/// Reference to a cluster, in 32 bits for the leaves of trees. An instance that is alone in its
/// leaf is referred to directly, without a list.
struct ClusterRef {
    enum Kind : std::uint32_t { list, triangles, spheres, instances };

    static constexpr std::uint32_t most_single = 1U << 28;

    ClusterRef(Kind kind, std::size_t index)
        : bits(kind << 29 | static_cast<std::uint32_t>(index)) {}
    explicit ClusterRef(std::uint32_t from) : bits(from) {}

    /// `instance` is its number among the geometry's instances, below most_single.
    static ClusterRef single(std::uint32_t instance) { return {instances, instance | most_single}; }

    Kind kind() const { return static_cast<Kind>(bits >> 29); }
    std::uint32_t index() const { return bits & 0x1FFFFFFFU; }

    /// Returns whether a cluster of instances is one instance.
    bool is_single() const { return (bits & most_single) != 0; }
    std::uint32_t instance() const { return index() & ~most_single; }

    std::uint32_t bits;  ///< the highest bit is always 0
};

/// Returns the kind of cluster for primitives of a kind.
constexpr ClusterRef::Kind cluster_kind(ShapeKind kind) {
    if (kind == kind_of<Triangle>()) return ClusterRef::triangles;
    if (kind == instance_kind) return ClusterRef::instances;
    return kind == kind_of<Sphere>() ? ClusterRef::spheres : ClusterRef::list;
}

/// A range of a list.
struct Range {
    std::uint32_t first, count;
};

/// Returns references to the clusters that `ranges` of `ids` will become. Each range has at most
/// cluster_lanes primitives of one kind of cluster. With the references a tree can be built before
/// the clusters, which take more memory than all else.
std::vector<ClusterRef> cluster_refs(const Geometry& geometry, std::span<const std::uint32_t> ids,
                                     std::span<const Range> ranges);

/// A scene's primitives in clusters. Primitives without a filter, and instances, are in lists of
/// numbers.
class Clusters {
  public:
    Clusters() = default;

    /// Builds the clusters that `refs` refer to, as cluster_refs() returned them for the same `ids`
    /// and `ranges`. Uses as many threads as allowed.
    Clusters(const Geometry& geometry, const NormalizedSpace& space,
             std::span<const std::uint32_t> ids, std::span<const Range> ranges,
             std::span<const ClusterRef> refs);

    /// A primitive and the result of its kernel.
    struct Candidate {
        std::uint32_t id;
        double t;
    };

    /// Intersects the primitive at a used lane, or at any lane of a list: then the id is no_index
    /// if the lane is unused. Not for instances: see instance_list.h.
    Candidate intersect_lane(const Geometry& geometry, ClusterRef ref, std::size_t lane,
                             const RayQuery& query) const;

    const TriangleCluster& triangles(ClusterRef ref) const { return triangles_[ref.index()]; }
    const SphereCluster& spheres(ClusterRef ref) const { return spheres_[ref.index()]; }

    /// Calls visit(item) for each instance of a cluster, for as long as it returns true.
    template <class Visit>
    void visit_instances(ClusterRef ref, const Visit& visit) const {
        if (ref.is_single()) {
            visit(first_instance_ + ref.instance());
            return;
        }
        for (const std::uint32_t item : lists_[ref.index()]) {
            if (item == no_index || !visit(item)) return;
        }
    }

    bool has_spheres() const { return !spheres_.empty(); }

    /// Returns the number of its primitives.
    std::size_t size(ClusterRef ref) const;

    std::size_t memory_bytes() const;

  private:
    /// Primitive numbers, with no_index after the last.
    using List = std::array<std::uint32_t, cluster_lanes>;

    void fill(const Geometry& geometry, const NormalizedSpace& space, ClusterRef ref,
              std::span<const std::uint32_t> ids);

    std::vector<TriangleCluster, LargePages<TriangleCluster>> triangles_;
    std::vector<SphereCluster, LargePages<SphereCluster>> spheres_;
    std::vector<List> lists_;
    std::uint32_t first_instance_ = 0;  ///< number of the first instance among the items
};

inline Clusters::Candidate Clusters::intersect_lane(const Geometry& geometry, ClusterRef ref,
                                                    std::size_t lane, const RayQuery& query) const {
    switch (ref.kind()) {
        case ClusterRef::triangles: {
            const TriangleCluster& cluster = triangles(ref);
            const std::uint32_t id = cluster.ids[lane];
            const Sides sides = cluster.sides[lane];
            if (sides == Sides::cut_out) [[unlikely]]
                return {id, primitive_first_hit(geometry, id, query)};
            const Triangle triangle{cluster.vertices[lane]};
            return {id, shape_first_hit(geometry, triangle, sides, query)};
        }
        case ClusterRef::spheres: {
            const SphereCluster& cluster = spheres(ref);
            return {cluster.ids[lane],
                    shape_first_hit(geometry, cluster.exact[lane], cluster.sides[lane], query)};
        }
        default: {
            const std::uint32_t id = lists_[ref.index()][lane];
            return {id, id == no_index ? no_hit : primitive_first_hit(geometry, id, query)};
        }
    }
}

}  // namespace etalon
