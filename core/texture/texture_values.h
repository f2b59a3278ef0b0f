#pragma once

#include <string>
#include <vector>

#include "core/scene/texture.h"
#include "core/texture/difference_steps.h"
#include "core/texture/texture_images.h"
#include "core/texture/texture_point.h"

namespace etalon {

/// The textures of a scene, ready to be evaluated by any number of threads. Values are those of
/// pbrt-v3 where a point's footprint is small.
class TextureValues {
  public:
    /// Reads the images. `textures` must outlive this. `problems` gets the reasons if images cannot
    /// be read, each beginning with the path; grey replaces them.
    TextureValues(const Textures& textures, std::vector<std::string>& problems);

    /// Returns the value of a slot at a point of a surface.
    float number(const NumberSlot& slot, const TexturePoint& point) const {
        return slot.texture == no_index ? slot.value : texture_number(slot.texture, point);
    }
    Color color(const ColorSlot& slot, const TexturePoint& point) const {
        return slot.texture == no_index ? slot.value : texture_color(slot.texture, point);
    }

    /// Returns the largest steps of finite differences of a slot.
    DifferenceSteps difference_steps(const NumberSlot& slot) const {
        return slot.texture == no_index ? DifferenceSteps{} : steps_[slot.texture];
    }

  private:
    float texture_number(std::uint32_t texture, const TexturePoint& point) const;
    Color texture_color(std::uint32_t texture, const TexturePoint& point) const;

    const Textures& textures_;
    TextureImages images_;
    std::vector<DifferenceSteps> steps_;  ///< of the textures of numbers
};

}  // namespace etalon
