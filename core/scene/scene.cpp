#include "core/scene/scene.h"

namespace etalon {

namespace {

template <class... Array>
std::size_t bytes(const Array&... arrays) {
    return ((arrays.capacity() * sizeof(typename Array::value_type)) + ...);
}

std::size_t bytes(const WhittedLook& look) {
    return bytes(look.materials, look.lights);
}

std::size_t bytes(const PhysicalLook& look) {
    const Textures& t = look.textures;
    std::size_t sum = bytes(look.bindings, look.materials, look.lights, look.media, t.numbers,
                            t.colors, t.images, look.named_images);
    for (const PhysicalMedium& medium : look.media) {
        if (medium.grid) sum += bytes(medium.grid->densities);
    }
    return sum;
}

}  // namespace

std::size_t memory_bytes(const Scene& scene) {
    return sizeof(Scene) + memory_bytes(scene.geometry) +
           std::visit([](const auto& look) { return bytes(look); }, scene.look);
}

}  // namespace etalon
