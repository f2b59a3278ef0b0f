#pragma once

#include "core/scene/scene.h"
#include "tests/fuzz/rays/palette.h"

namespace etalon::fuzz {

/// A scene of one to six primitives of any kinds, which often share numbers, and now and then of
/// instances that stand or move.
Scene nasty_scene(const NastyNumbers& numbers);

}  // namespace etalon::fuzz
