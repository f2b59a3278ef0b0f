#pragma once

#include "core/bsdf/trowbridge_reitz.h"
#include "core/material/material.h"

namespace etalon {

/// The values of slots at one point, as materials use them.
class PointValues {
  public:
    PointValues(const TextureValues& textures, const TexturePoint& at)
        : textures_(textures), at_(at) {}

    float number(const NumberSlot& slot) const {
        asked_point_ |= slot.texture != no_index;
        return textures_.number(slot, at_);
    }
    Color color(const ColorSlot& slot) const {
        asked_point_ |= slot.texture != no_index;
        return textures_.color(slot, at_);
    }

    /// Returns a reflectance or a transmittance: not below 0, though it may be above 1.
    Color part(const ColorSlot& slot) const {
        const Color c = color(slot);
        return {std::max(c.x, 0.0F), std::max(c.y, 0.0F), std::max(c.z, 0.0F)};
    }

    TrowbridgeReitz facets(const Roughness& roughness) const;

    /// Returns the coordinate across the surface.
    double v() const {
        asked_point_ = true;
        return at_.uv.y;
    }

    /// Returns whether any value so far depends on the point, as a texture's does.
    bool asked_point() const { return asked_point_; }

  private:
    const TextureValues& textures_;
    TexturePoint at_;
    mutable bool asked_point_ = false;
};

}  // namespace etalon
