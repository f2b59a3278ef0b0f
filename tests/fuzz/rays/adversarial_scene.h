#pragma once

#include "core/scene/scene.h"
#include "tests/fuzz/rays/palette.h"

namespace etalon::fuzz {

/// Returns a scene of one to six primitives of any shapes, which often share coordinates, and
/// sometimes of static or moving instances.
Scene adversarial_scene(const AdversarialNumbers& numbers);

}  // namespace etalon::fuzz
