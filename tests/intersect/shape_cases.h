// The table from which every kernel test is generated; its rows are in tests/intersect/shapes. A
// new shape needs new rows there; a hard case that failed once is a row too.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/numerics/random.h"
#include "core/scene/scene.h"

namespace etalon {

/// Returns a point to aim at, which may depend on the origin of the ray.
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
    /// few roundings away: see kernel_classification.h.
    bool exact;
    std::vector<Target> targets;
    std::vector<Vec3> tips;  ///< points near which the shape is thinner than a rounding
};

std::vector<ShapeCase> shape_cases();

/// Shapes that no ray may hit: of zero extent, inside out, or not finite.
struct DegenerateCase {
    std::string name;
    Scene scene;
    bool empty_bounds = true;
};
std::vector<DegenerateCase> degenerate_cases();

}  // namespace etalon
