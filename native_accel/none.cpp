#include "native_accel/none.h"

namespace etalon {

None::None(const Scene& scene) : Intersector(scene, SceneBounds::none_bounded(scene)) {}

std::size_t None::memory_bytes() const {
    return scene_bounds().unbounded.size() * sizeof(std::uint32_t);
}

}  // namespace etalon
