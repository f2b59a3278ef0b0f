// The table from which every kernel test is generated: its rows are in tests/intersect/shapes. A
// new shape is new rows there; a hard case that once went wrong is a row too.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/numerics/random.h"
#include "core/scene/scene.h"

namespace etalon {

/// Points worth aiming at, some of which depend on where the ray comes from.
struct Target {
    std::string name;
    std::function<Vec3(Random&, const Vec3& from)> point;
};

struct ShapeCase {
    std::string name;
    Scene scene;  ///< the shape alone, as primitive 0
    Vec3 centre;
    double size;
    /// True if hit or miss is right for every ray. Otherwise it is right for a ray that starts a
    /// few roundings from the one asked for: see kernel_classification.h.
    bool exact;
    std::vector<Target> targets;
    std::vector<Vec3> tips;  ///< next to which the shape is thinner than a rounding
};

std::vector<ShapeCase> shape_cases();

/// Shapes that nothing may hit: of no extent, inside out, or not finite.
struct DegenerateCase {
    std::string name;
    Scene scene;
    bool empty_bounds = true;
};
std::vector<DegenerateCase> degenerate_cases();

}  // namespace etalon
