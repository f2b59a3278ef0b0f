#pragma once

#include <span>
#include <vector>

#include "core/intersect/clusters/cluster.h"

namespace etalon {

/// Where a cluster is: 32 bits for the leaves of trees.
struct ClusterRef {
    enum Kind : std::uint32_t { list, triangles, spheres };

    ClusterRef(Kind kind, std::size_t index)
        : bits(kind << 29 | static_cast<std::uint32_t>(index)) {}
    explicit ClusterRef(std::uint32_t from) : bits(from) {}

    Kind kind() const { return static_cast<Kind>(bits >> 29); }
    std::uint32_t index() const { return bits & 0x1FFFFFFFU; }

    std::uint32_t bits;  ///< the highest is free
};

/// A part of a list.
struct Range {
    std::uint32_t first, count;
};

/// A scene's primitives in clusters. Those that no filter is for are in lists of numbers.
class Clusters {
  public:
    Clusters() = default;

    /// One for each of `ranges` of `ids`, of at most cluster_lanes primitives, and to refs[i]
    /// where the i-th is. Those of different kinds make a list. As many threads as allowed.
    Clusters(const Scene& scene, const Frame& frame, std::span<const std::uint32_t> ids,
             std::span<const Range> ranges, std::vector<ClusterRef>& refs);

    const TriangleCluster& triangles(ClusterRef ref) const { return triangles_[ref.index()]; }
    const SphereCluster& spheres(ClusterRef ref) const { return spheres_[ref.index()]; }

    /// Primitive numbers by lane; after the last, no_index.
    const std::array<std::uint32_t, cluster_lanes>& ids(ClusterRef ref) const {
        return ids_[ref.kind()][ref.index()];
    }

    std::size_t memory_bytes() const;

  private:
    using Ids = std::array<std::uint32_t, cluster_lanes>;

    std::vector<TriangleCluster> triangles_;
    std::vector<SphereCluster> spheres_;
    std::array<std::vector<Ids>, 3> ids_;  ///< by kind of cluster
};

}  // namespace etalon
