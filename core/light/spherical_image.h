#pragma once

#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// An image of all directions: rows are angles from +z, columns angles about it from +x. Values are
/// those of the file, whatever their encoding, as in pbrt-v3.
class SphericalImage {
  public:
    /// Empty without a file. `problems` gets the reason if the file cannot be read.
    SphericalImage(const std::string& file, std::vector<std::string>& problems);

    /// Makes an image of these texels, in rows from +z.
    SphericalImage(int width, int height, std::vector<Color> texels)
        : width_(width),
          height_(height),
          aspect_(static_cast<double>(width) / height),
          texels_(std::move(texels)) {}

    bool empty() const { return texels_.empty(); }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Returns width over height of the file's image, which may differ from that of the texels.
    double aspect() const { return aspect_; }

    /// Returns a texel; beyond a border the image repeats.
    const Color& texel(int x, int y) const;

    /// Returns the bilinearly interpolated image at a point of the unit square.
    Color at(const Vec2& place) const;

    /// Returns the point of the unit square for a unit vector.
    static Vec2 place_of(const Vec3& direction);

    /// Returns the unit vector for a point of the unit square.
    static Vec3 direction_at(const Vec2& place);

  private:
    int width_ = 0, height_ = 0;
    double aspect_ = 1;
    std::vector<Color> texels_;  ///< in rows from +z
};

}  // namespace etalon
