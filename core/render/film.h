#pragma once

#include <cstdint>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Sums of samples, pixel by pixel, over a window of the picture. Threads may add to different
/// pixels at the same time.
class Film {
  public:
    /// `window` inclusive on both ends.
    explicit Film(const Imath::Box2i& window);

    void add(int x, int y, const Color& sample);

    const Imath::Box2i& window() const { return window_; }

    /// The mean of each pixel's samples, rows from the top; black where there is none yet.
    std::vector<Color> pixels() const;

    /// For a film of a grid's corners: that of the cells between them, each with the samples of its
    /// four corners. It is smaller by one both ways.
    Film cells() const;

  private:
    struct Pixel {
        Vec3 sum{0};
        std::uint32_t count = 0;
    };

    Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - window_.min.y) * width_ + (x - window_.min.x);
    }

    Imath::Box2i window_;
    int width_;
    std::vector<Pixel> pixels_;
};

}  // namespace etalon
