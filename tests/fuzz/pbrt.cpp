#include "tests/fuzz/scene_target.h"
#include "tests/fuzz/target.h"

namespace etalon::fuzz {

const Target target = {[](std::string_view text) { read_scene("pbrt", text); }, true};

}  // namespace etalon::fuzz
