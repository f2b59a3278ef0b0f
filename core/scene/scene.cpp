#include "core/scene/scene.h"

namespace etalon {
namespace {

template <class T>
std::size_t bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

}  // namespace

std::size_t memory_bytes(const Scene& scene) {
    const std::size_t shapes =
        std::apply([](const auto&... v) { return (bytes(v) + ...); }, scene.shapes);
    return sizeof(Scene) + shapes + bytes(scene.lights) + bytes(scene.materials) +
           bytes(scene.primitives) + bytes(scene.vertices) + bytes(scene.normals);
}

}  // namespace etalon
