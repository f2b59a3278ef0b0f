// Edits of a scene after which the same rays must have the same hits.
#pragma once

#include <optional>

#include "core/scene/scene.h"
#include "tests/fuzz/rays/compare_backends.h"
#include "tests/fuzz/rays/palette.h"

namespace etalon::fuzz {

/// An edited scene, its rays, and the hits that they must have. With `compares_t_only` the
/// primitives of the hits are not compared, as the edit has renumbered them.
struct Edited {
    std::string name;
    Scene scene;
    std::vector<Ray> rays;
    std::vector<Hit> expected;
    double tolerance = 0;  ///< relative tolerance of t
    bool compares_t_only = false;
};

/// Applies a random edit: scales by a power of two, translates by whole numbers, permutes the
/// primitives or cuts triangles in two. Returns nothing if the edit would need rounding.
std::optional<Edited> edited(const Scene& scene, const std::vector<Ray>& rays,
                             const std::vector<Hit>& hits, const AdversarialNumbers& numbers);

/// Returns the first ray whose hit is not the expected one, or on which the backends disagree.
std::optional<Finding> find_change(const Edited& edited);

}  // namespace etalon::fuzz
