#include "core/formats/pbrt/material_pool.h"

#include <functional>

namespace etalon::pbrt {
namespace {

struct HashValues {
    template <class T>
    std::size_t operator()(const std::vector<T>& values) const {
        std::size_t hash = values.size();
        for (const T& v : values) hash = hash * 31 + std::hash<T>()(v);
        return hash;
    }
    std::size_t operator()(const TextureNumber& texture) const { return texture.number + 1; }
};

std::size_t hash_of(const Material& material) {
    std::size_t hash = std::hash<const void*>()(material.plugin.type);
    for (const std::uint32_t mixed : material.mixed) hash = hash * 1000003 + mixed;
    for (const Argument& a : material.plugin.parameters.arguments()) {
        hash = hash * 1000003 + std::hash<const void*>()(a.spec);
        hash = hash * 1000003 + std::visit(HashValues{}, a.values);
    }
    return hash;
}

bool is_equal(const Material& a, const Material& b) {
    return a.plugin.parameters == b.plugin.parameters && a.mixed == b.mixed;
}

}  // namespace

std::uint32_t MaterialPool::add(Material material, std::vector<Material>& materials) {
    const std::size_t hash = hash_of(material);
    const auto [first, last] = numbers_.equal_range(hash);
    for (auto i = first; i != last; ++i) {
        if (is_equal(materials[i->second], material)) return i->second;
    }
    const auto number = static_cast<std::uint32_t>(materials.size());
    materials.push_back(std::move(material));
    numbers_.emplace(hash, number);
    return number;
}

}  // namespace etalon::pbrt
