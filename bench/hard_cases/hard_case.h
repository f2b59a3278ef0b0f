// The catalogue of hard cases: constructions on which ray tracers fail, with millions of rays.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/intersect/ray.h"
#include "core/numerics/random.h"
#include "core/scene/scene.h"

namespace etalon::hard {

/// Criterion by which the answers to a case's rays are checked.
enum class Criterion {
    oracle,    ///< the oracle's answer to each ray
    enclosed,  ///< every ray starts inside a closed surface: a miss is a leak
    spawned    ///< the rays that leave the hits: hitting the same surface again is a self-hit
};

/// A constructed case: a scene and its rays.
struct CaseSetup {
    Scene scene;
    double size = 1;  ///< size of the shape, to which errors of positions and roots are relative
    /// Generates a ray. Thread-safe; all randomness comes from `random`, which is new for every
    /// ray.
    std::function<Ray(Random& random)> ray;
    /// Relative difference below which distances count as equal, since a kernel's rounding may put
    /// either first. Zero if every t is a double.
    double tie = 2 * t_tolerance;
};

struct HardCase {
    std::string id;       ///< names the construction, e.g. "SPH-1"
    std::string variant;  ///< distinguishes the id's rows, e.g. "1e3 radii"
    /// The shape's name if the scene is one primitive, so that kernels alone can be measured, too;
    /// else "scene".
    std::string shape;
    Criterion criterion = Criterion::oracle;
    std::function<CaseSetup()> make;
};

/// Returns all cases, by id.
std::vector<HardCase> hard_cases();

/// Returns the ray as a float renderer would get it: every number rounded to float.
Ray in_float(Ray ray);

}  // namespace etalon::hard
