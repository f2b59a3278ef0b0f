#pragma once

#include <functional>

#include "tests/fuzz/rays/judge.h"

namespace etalon::fuzz {

/// A scene of as few primitives and a ray of as few digits as still show a difference.
struct Shrunk {
    Scene scene;
    Finding finding;
};

using FindDifference = std::function<std::optional<Finding>(const Scene&, const std::vector<Ray>&)>;

Shrunk shrunk(Scene scene, Finding finding, const FindDifference& find);

/// The scene as P3F, as far as that says it, and the ray as `etalon trace` reads it.
std::string to_text(const Shrunk& shrunk);

}  // namespace etalon::fuzz
