// Counters of a traversal. The traversal is compiled once with each of these, so that counting
// costs nothing where it is not needed.
#pragma once

#include "core/accel/clusters/clusters.h"
#include "core/intersect/traversal_cost.h"

namespace etalon {

struct Uncounted {
    void cell() const {}
    template <class Boxes>
    void boxes(const Boxes&) const {}
    template <class Pack>
    void members(const Pack&) const {}
    void members(const Clusters&, ClusterRef) const {}
    TraversalCost* sum() const { return nullptr; }
};

struct Counted {
    /// Counts a cell that the ray visits.
    void cell() const { ++cost.box_tests; }
    template <class Boxes>
    void boxes(const Boxes& tested) const {
        cost.box_tests += tested.count();
    }
    template <class Pack>
    void members(const Pack& tested) const {
        cost.primitive_tests += tested.count();
    }
    void members(const Clusters& clusters, ClusterRef tested) const {
        cost.primitive_tests += clusters.size(tested);
    }
    TraversalCost* sum() const { return &cost; }

    TraversalCost& cost;
};

}  // namespace etalon
