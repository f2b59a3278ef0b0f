// The catalogue of hard cases: constructions on which ray tracers go wrong, by the million.
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
    spawned    ///< the rays that leave the hits: meeting the same surface again is a self-hit
};

/// A case made: a scene and the rays to shoot at it.
struct CaseSetup {
    Scene scene;
    double size = 1;  ///< of what is hit, to express errors of positions and roots in
    /// Thread-safe; all that is random comes from `random`, which is new for every ray.
    std::function<Ray(Random& random)> ray;
    /// Distances that differ by less, relative to themselves, are taken for equal: a kernel's
    /// rounding may put either first. Zero where every t is a double.
    double tie = 2 * t_tolerance;
};

struct HardCase {
    std::string id;       ///< names the construction, e.g. "SPH-1"
    std::string variant;  ///< tells the id's rows apart, e.g. "1e3 radii"
    /// The shape's name where the scene is one primitive, which kernels by themselves can then be
    /// asked too; else "scene".
    std::string shape;
    Criterion criterion = Criterion::oracle;
    std::function<CaseSetup()> make;
};

/// All of them, by id.
std::vector<HardCase> hard_cases();

/// The ray as a renderer in float would be given it: every number rounded to float.
Ray in_float(Ray ray);

}  // namespace etalon::hard
