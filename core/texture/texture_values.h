#pragma once

#include <string>
#include <vector>

#include "core/scene/texture.h"

namespace etalon {

/// Point of a surface as textures see it.
struct TexturePoint {
    Vec2 uv;        ///< the surface's coordinates
    Vec3 position;  ///< in the world
};

/// Textures of a scene ready to be evaluated, by any number of threads at a time.
class TextureValues {
  public:
    /// Takes over nothing: `textures` must outlive the object. `problems` gets the reasons why
    /// images cannot be shown, each beginning with the path; a constant stands in for them.
    TextureValues(const Textures& textures, std::vector<std::string>& problems);

    /// The value of a slot at a point of a surface.
    float number(const NumberSlot& slot, const TexturePoint& point) const {
        return slot.texture == no_index ? slot.value : texture_number(slot.texture, point);
    }
    Color color(const ColorSlot& slot, const TexturePoint& point) const {
        return slot.texture == no_index ? slot.value : texture_color(slot.texture, point);
    }

  private:
    float texture_number(std::uint32_t texture, const TexturePoint& point) const;
    Color texture_color(std::uint32_t texture, const TexturePoint& point) const;

    const Textures& textures_;
};

}  // namespace etalon
