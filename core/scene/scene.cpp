#include "core/scene/scene.h"

namespace etalon {

std::size_t memory_bytes(const Scene& scene) {
    const WhittedLook& look = scene.look;
    return sizeof(Scene) + memory_bytes(scene.geometry) +
           look.materials.capacity() * sizeof(Material) + look.lights.capacity() * sizeof(Light);
}

}  // namespace etalon
