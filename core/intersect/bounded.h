#pragma once

#include <vector>

#include "core/intersect/normalized_space.h"
#include "core/scene/geometry.h"

namespace etalon {

/// A primitive or an instance as an accelerator sees it. Each half is loaded as four floats side by
/// side.
struct alignas(16) BoundedPrimitive {
    /// Sets nothing, so that a large array is first written by the threads that fill it.
    BoundedPrimitive() {}
    BoundedPrimitive(const Box3f& box, std::uint32_t id_, ShapeKind kind_)
        : min(box.min), id(id_), max(box.max), kind(kind_) {}

    Box3f box() const { return {min, max}; }

    Vec3f min;         ///< lower corner of the box in normalized space, with its padding
    std::uint32_t id;  ///< number among the geometry's items
    Vec3f max;
    std::uint32_t kind;
};

static_assert(sizeof(BoundedPrimitive) == 32);

/// A scene's primitives and instances sorted by what an accelerator can do with them. Degenerate
/// ones, which nothing can hit, are in neither list.
struct SceneBounds {
    /// Sorts a scene's primitives, on as many threads as allowed; both lists are in its order.
    static SceneBounds of(const Geometry& geometry, const InstancePadding& padding = full_padding);

    /// Puts every primitive into the list of those that must always be tested; instances are in
    /// neither list.
    static SceneBounds none_bounded(const Geometry& geometry);

    NormalizedSpace space;
    double spread = 1;  ///< see InstanceBounds
    std::vector<BoundedPrimitive> bounded;
    std::vector<std::uint32_t> unbounded;
};

}  // namespace etalon
