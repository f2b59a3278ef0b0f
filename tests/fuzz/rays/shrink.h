#pragma once

#include <functional>

#include "tests/fuzz/rays/compare_backends.h"

namespace etalon::fuzz {

/// A minimised finding: as few primitives and as few digits of the ray as still show the
/// difference.
struct Shrunk {
    Scene scene;
    Finding finding;
};

using FindDifference = std::function<std::optional<Finding>(const Scene&, const std::vector<Ray>&)>;

Shrunk shrunk(Scene scene, Finding finding, const FindDifference& find);

/// Returns the scene as P3F, as far as the format allows, and the ray as `etalon trace` reads it.
std::string to_text(const Shrunk& shrunk);

}  // namespace etalon::fuzz
