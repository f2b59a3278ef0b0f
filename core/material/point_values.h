#pragma once

#include "core/bsdf/trowbridge_reitz.h"
#include "core/material/material.h"

namespace etalon {

/// The values of slots at one point, as materials take them.
struct PointValues {
    const TextureValues& textures;
    TexturePoint at;

    float number(const NumberSlot& slot) const { return textures.number(slot, at); }
    Color color(const ColorSlot& slot) const { return textures.color(slot, at); }

    /// A reflectance or a transmittance: not below 0, though it may be above 1.
    Color part(const ColorSlot& slot) const {
        const Color c = color(slot);
        return {std::max(c.x, 0.0F), std::max(c.y, 0.0F), std::max(c.z, 0.0F)};
    }

    TrowbridgeReitz facets(const Roughness& roughness) const;
};

}  // namespace etalon
