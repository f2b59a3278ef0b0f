#pragma once

#include <vector>

#include "core/intersect/normalized_space.h"
#include "core/intersect/outliers.h"
#include "core/scene/geometry.h"

namespace etalon {

/// A primitive or an instance as an accelerator sees it. Each corner is loaded together
/// with the number behind it, as one vector of four floats.
struct alignas(16) BoundedPrimitive {
    /// Leaves the members uninitialized, so that a large array is first touched by the threads that
    /// fill it.
    BoundedPrimitive() {}
    BoundedPrimitive(const Box3f& box, std::uint32_t id_, ShapeKind kind_)
        : min(box.min), id(id_), max(box.max), kind(kind_) {}

    Box3f box() const { return {min, max}; }

    Vec3f min;         ///< lower corner of the padded box in normalized space
    std::uint32_t id;  ///< number among the geometry's items
    Vec3f max;
    std::uint32_t kind;
};

static_assert(sizeof(BoundedPrimitive) == 32);

/// A scene's primitives and instances, bounded and unbounded ones apart. Degenerate ones, which
/// nothing can hit, are in no list.
struct SceneBounds {
    /// Computes the bounds with as many threads as allowed. The lists are in the scene's order.
    static SceneBounds of(const Geometry& geometry, const InstancePadding& padding = full_padding,
                          OutlierRule rule = OutlierRule::cost);

    /// Puts every primitive into the list of unbounded ones, which are always tested. Instances are
    /// left out.
    static SceneBounds none_bounded(const Geometry& geometry);

    /// Moves the outliers among the unbounded primitives to `far`, if there are more than a few.
    void separate_far(const Geometry& geometry);

    /// Returns whether there is anything that is not in the list of bounded primitives.
    bool has_more() const { return !unbounded.empty() || !far.empty(); }

    NormalizedSpace space;
    double spread = 1;  ///< see InstanceBounds
    std::vector<BoundedPrimitive> bounded;
    std::vector<std::uint32_t> unbounded;  ///< always tested
    std::vector<std::uint32_t> far;        ///< outliers: see ReachCounts
};

}  // namespace etalon
