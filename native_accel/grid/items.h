#pragma once

#include <vector>

#include "core/intersect/bounded.h"
#include "native_accel/grid/overlap.h"

namespace etalon {

/// A scene's bounded primitives, sorted by what the grid can do with them.
struct GridItems {
    GridItems(const Scene& scene, const SceneBounds& bounds);

    std::vector<SphereItem> spheres;
    std::vector<TriangleItem> triangles;
    std::vector<BoxItem> others;
};

}  // namespace etalon
