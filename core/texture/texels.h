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

/// Storage of an image, shared by all textures that use it.
using SharedTexels = std::variant<std::shared_ptr<const Image>, std::shared_ptr<const PackedImage>>;

/// An image as textures use it: interpolated between the centres of its texels, with t upwards and
/// (0, 0) and (1, 1) at its corners.
class Texels {
  public:
    /// Has no image; must not be evaluated.
    Texels() = default;

    /// Uses an image of one pixel or more. Bytes are decoded if `how` says so; floats and packed
    /// colours are used as they are.
    Texels(const SharedTexels& texels, const TextureImage& how);

    /// Returns the numbers of columns and rows.
    Imath::V2i size() const {
        return packed_ ? Imath::V2i(packed_->width, packed_->height)
                       : Imath::V2i(image_->width, image_->height);
    }

    /// Return the value at (s, t): the first three channels, or grey; or the first channel alone,
    /// of an image that is not packed.
    Color color(const Vec2& st) const;
    float number(const Vec2& st) const;

    /// Returns where number() is 0, if that follows from a bit for each texel: if sums and products
    /// of values that are not 0 cannot be 0.
    std::optional<ZeroTexels> zeros() const;

  private:
    /// Returns the number for which a stored one stands.
    template <class Stored>
    float shown(Stored value) const;

    template <class Value>
    Value interpolated(const Vec2& st) const;

    Color interpolated_packed(const Vec2& st) const;

    std::shared_ptr<const Image> image_;
    std::shared_ptr<const PackedImage> packed_;  ///< either this or the other is null
    const std::array<float, 256>* byte_values_ = nullptr;
    Wrap wrap_ = Wrap::repeat;
    float scale_ = 1;
};

}  // namespace etalon
