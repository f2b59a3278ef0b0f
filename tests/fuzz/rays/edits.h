// Changes of a scene after which the same rays must find the same things.
#pragma once

#include <optional>

#include "core/scene/scene.h"
#include "tests/fuzz/rays/judge.h"
#include "tests/fuzz/rays/palette.h"

namespace etalon::fuzz {

/// A scene, its rays, and the hits that they must have; a hit's primitive does not count where
/// equally near ones have changed places.
struct Edited {
    std::string name;
    Scene scene;
    std::vector<Ray> rays;
    std::vector<Hit> expected;
    double tolerance = 0;  ///< of t, relative
    bool compares_t_only = false;
};

/// Scales by a power of two, moves by whole numbers where all sums are exact, permutes the
/// primitives or cuts triangles in two, at random. Nothing where the edit would round.
std::optional<Edited> edited(const Scene& scene, const std::vector<Ray>& rays,
                             const std::vector<Hit>& hits, const NastyNumbers& numbers);

/// Returns the first ray that finds something else in an edited scene.
std::optional<Finding> find_change(const Edited& edited);

}  // namespace etalon::fuzz
