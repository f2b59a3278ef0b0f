#pragma once

#include <vector>

#include "core/intersect/frame.h"
#include "core/scene/scene.h"

namespace etalon {

/// A primitive as an accelerator sees it.
struct BoundedPrimitive {
    Box3f box;         ///< in the frame, padded
    std::uint32_t id;  ///< number in Scene::primitives
};

/// A scene's primitives sorted by what an accelerator can do with them. Degenerate ones, which
/// nothing can hit, are in neither list.
struct SceneBounds {
    static SceneBounds of(const Scene& scene);

    /// Every primitive in the list of those that must always be tested.
    static SceneBounds none_bounded(const Scene& scene);

    Frame frame;
    std::vector<BoundedPrimitive> bounded;
    std::vector<std::uint32_t> unbounded;
};

}  // namespace etalon
