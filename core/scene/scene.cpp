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
    return bytes(look.bindings, look.materials, look.lights, t.numbers, t.colors, t.images,
                 look.named_images);
}

}  // namespace

std::size_t memory_bytes(const Scene& scene) {
    return sizeof(Scene) + memory_bytes(scene.geometry) +
           std::visit([](const auto& look) { return bytes(look); }, scene.look);
}

}  // namespace etalon
