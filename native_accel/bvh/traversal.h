// Traversal of the tree, compiled for several instruction sets. The best one that the machine has
// is used.
#pragma once

#include "core/accel/wide/wide_tree.h"
#include "core/intersect/intersector.h"
#include "core/intersect/object_space.h"
#include "core/intersect/ray.h"
#include "core/intersect/traversal_cost.h"

namespace etalon {

struct BvhObject;

/// View of the data that a traversal needs.
struct BvhView {
    const Geometry& geometry;
    const SceneBounds& bounds;
    const WideTree& tree;
    const Clusters& clusters;
    const Intersector& instances;
    const BvhObject* objects = nullptr;  ///< one for each object of the geometry

    /// Returns whether the ray is likely to take the same path through the tree as those before it.
    /// That is unlikely if it enters very many nodes.
    bool predicts_branches(const Ray& ray) const {
        return ray.coherent() && tree.expected_nodes < 16;
    }
};

/// An object as a ray in world space enters it.
struct BvhObject {
    explicit BvhObject(const BvhView& v)
        : space(v.bounds), view(v), is_plain(v.geometry.instances.empty() && !v.tree.empty()) {}

    ObjectSpace space;
    BvhView view;
    bool is_plain;  ///< true if all of its primitives are in its tree
};

/// Traversal functions for one instruction set.
struct BvhTraversal {
    /// Offers `nearest` every primitive that could be hit no later than nearest.t.
    void (*closest)(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                    NearestHit& nearest);

    /// The same, adding the boxes of all nodes visited and the members of all clusters to `cost`.
    void (*closest_counted)(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local,
                            NearestHit& nearest, TraversalCost& cost);

    /// Returns whether any primitive is hit at t <= query.ray.tmax.
    bool (*occluded)(const BvhView& bvh, const RayQuery& query, const NormalizedRay& local);
};

/// Returns the traversal for the instruction set in use now.
BvhTraversal bvh_traversal();

/// Returns the traversal of boxes with least_padding, for scenes with instances of any size. It is
/// slower at each node, but enters no more nodes than necessary.
BvhTraversal bvh_instance_traversal();

}  // namespace etalon
