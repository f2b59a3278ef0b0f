// Scenes on which backends could disagree.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/scene/transformed.h"

namespace etalon::test {

struct SceneFamily {
    std::string name;
    std::function<Scene(std::size_t count)> make;  ///< of about `count` primitives
};

const std::vector<SceneFamily>& scene_families();

/// Returns the family's scene; fails the test if there is no such family.
Scene make_scene(const std::string& family, std::size_t count);

}  // namespace etalon::test
