#include "native_accel/none.h"

namespace etalon {

None::None(const Geometry& geometry) : Intersector(geometry, SceneBounds::none_bounded(geometry)) {}

std::size_t None::memory_bytes() const {
    return scene_bounds().unbounded.size() * sizeof(std::uint32_t);
}

}  // namespace etalon
