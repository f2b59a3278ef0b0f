#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>

#include "core/image/image.h"
#include "core/scene/texture.h"
#include "core/texture/packed_colors.h"
#include "core/texture/zero_texels.h"

namespace etalon {

/// What is kept of an image, by however many textures that show it.
using SharedTexels = std::variant<std::shared_ptr<const Image>, std::shared_ptr<const PackedImage>>;

/// An image as textures show it: interpolated between the centres of its texels, with t upwards
/// and (0, 0) and (1, 1) at its corners.
class Texels {
  public:
    /// No image; it must not be asked for values.
    Texels() = default;

    /// Shows an image of one pixel or more. Bytes are decoded where `how` says so; floats and
    /// packed colours are what they say.
    Texels(const SharedTexels& texels, const TextureImage& how);

    /// The value at (s, t): the first three channels, or one that is grey; or the first alone, of
    /// an image that is not packed.
    Color color(const Vec2& st) const;
    float number(const Vec2& st) const;

    /// Returns where number() is 0, if a bit for each texel tells: where no sum or product of what
    /// is not 0 can be.
    std::optional<ZeroTexels> zeros() const;

  private:
    /// The number that a stored one means.
    template <class Stored>
    float shown(Stored value) const;

    template <class Value>
    Value interpolated(const Vec2& st) const;

    Color interpolated_packed(const Vec2& st) const;

    std::shared_ptr<const Image> image_;
    std::shared_ptr<const PackedImage> packed_;  ///< or null, and the other is not
    const std::array<float, 256>* byte_values_ = nullptr;
    Wrap wrap_ = Wrap::repeat;
    float scale_ = 1;
};

}  // namespace etalon
