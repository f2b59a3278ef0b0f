#pragma once

#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// An image of all directions: rows are angles from +z, columns angles about it from +x. Values are
/// those of the file, as pbrt-v3 takes them, whatever they are encoded for.
class SphericalImage {
  public:
    /// Empty without a file. `problems` gets the reason why a file cannot be read.
    SphericalImage(const std::string& file, std::vector<std::string>& problems);

    /// An image of these texels, by rows from +z.
    SphericalImage(int width, int height, std::vector<Color> texels)
        : width_(width),
          height_(height),
          aspect_(static_cast<double>(width) / height),
          texels_(std::move(texels)) {}

    bool empty() const { return texels_.empty(); }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Width over height of the file's image, which the texels may not have.
    double aspect() const { return aspect_; }

    /// A texel; beyond a border the image begins again.
    const Color& texel(int x, int y) const;

    /// The image at a place of the unit square, bilinear.
    Color at(const Vec2& place) const;

    /// Place of a unit vector.
    static Vec2 place_of(const Vec3& direction);

    /// The unit vector whose place this is.
    static Vec3 direction_at(const Vec2& place);

  private:
    int width_ = 0, height_ = 0;
    double aspect_ = 1;
    std::vector<Color> texels_;  ///< by rows from +z
};

}  // namespace etalon
